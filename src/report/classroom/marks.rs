//! How did the class do? The table of marks, what was most often wrong, and the scheme.

use super::student::{points, read_in};
use crate::claim::{Judged, Place};
use crate::classroom::{Exercise, MarkedSheet, Outcome, Scheme, StudentResult};
use crate::page::{Block, Document, Table, Text, phrase};
use crate::text::Untrusted;

/// The short answer: the table of marks.
pub fn marks_answer(results: &[StudentResult], scheme: &Scheme) -> Document {
    let mut page = Document::new("marks", "Marks");
    page.push(Block::Answer(vec![summary(results)]));
    page.push(table(results));
    page.blocks.extend(remarks(results, scheme));
    page.push(Block::Note(phrase!("Points by this scheme: {}.", shown(scheme))));
    page
}

/// The page: the marks, what was wrong most often, the scheme.
pub fn marks_page(exercise: &Exercise, results: &[StudentResult], scheme: &Scheme) -> Document {
    let mut page = Document::new("marks", "Marks");
    page.push(Block::Answer(vec![summary(results)]));
    page.push(table(results));
    page.blocks.extend(remarks(results, scheme));
    page.push(Block::Heading(1, "What was right, column by column".into()));
    page.push(columns(exercise, results));
    page.push(Block::Heading(1, "Scheme".into()));
    page.push(Block::Paragraph(
        "The points of a right phase and of a right sum; the part of them for a sum that is wrong only because a phase is; and the part of all points of a sheet that is \
         right in a convention which it does not declare."
            .into(),
    ));
    page.push(Block::Verbatim("toml", Untrusted::new(scheme.to_toml())));
    page
}

/// `phase = 1, sum = 2, …`.
fn shown(scheme: &Scheme) -> Text {
    Text::code(scheme.to_toml().trim_end().replace('\n', ", "))
}

fn marked<'a>(results: &'a [StudentResult]) -> impl Iterator<Item = &'a MarkedSheet> {
    results.iter().filter_map(|result| match &result.outcome {
        Outcome::Marked(sheet) => Some(sheet.as_ref()),
        Outcome::Unreadable(_) | Outcome::NotHandedIn | Outcome::HandedInTwice => None,
    })
}

fn summary(results: &[StudentResult]) -> Text {
    let count = |is: fn(&Outcome) -> bool| results.iter().filter(|result| is(&result.outcome)).count();
    phrase!(
        "Marked: {}. Not to be read: {}. Not handed in: {}. Handed in more than once: {}.",
        marked(results).count(),
        count(|outcome| match outcome {
            Outcome::Unreadable(_) => true,
            Outcome::Marked(_) | Outcome::NotHandedIn | Outcome::HandedInTwice => false,
        }),
        count(|outcome| match outcome {
            Outcome::NotHandedIn => true,
            Outcome::Marked(_) | Outcome::Unreadable(_) | Outcome::HandedInTwice => false,
        }),
        count(|outcome| match outcome {
            Outcome::HandedInTwice => true,
            Outcome::Marked(_) | Outcome::Unreadable(_) | Outcome::NotHandedIn => false,
        })
    )
}

/// A line for each student.
fn table(results: &[StudentResult]) -> Table {
    let mut table = Table::new(["Student", "Points", "Of", "Right", "Wrong", "Follows", "Missing"]);
    for result in results {
        let cells: Vec<Text> = match &result.outcome {
            Outcome::Marked(sheet) => {
                let counts = sheet.counts();
                let numbers = [counts.right, counts.wrong + counts.unreadable, counts.consequential, counts.missing];
                let points = [points(&sheet.points), points(&sheet.possible)];
                points.into_iter().chain(numbers.map(Text::from)).collect()
            }
            Outcome::Unreadable(_) | Outcome::NotHandedIn | Outcome::HandedInTwice => vec!["–".into(); 6],
        };
        table.push([name(result)].into_iter().chain(cells).collect());
    }
    table
}

fn name(result: &StudentResult) -> Text {
    result.pupil.map_or_else(|| "nobody of the exercise".into(), |pupil| Text::from(&pupil.name))
}

/// What is to be said of some: sheets that are not marked, and those that are read in another convention.
fn remarks(results: &[StudentResult], scheme: &Scheme) -> Option<Block> {
    let remark = |result: &StudentResult| {
        let files = || Text::joined(result.files.iter().map(Text::from), ", ");
        let remark = match &result.outcome {
            Outcome::Marked(sheet) => Text::joined(read_in(sheet, scheme), " "),
            Outcome::Unreadable(why) => phrase!("{} cannot be read: {}", files(), why),
            // All of them in one line below.
            Outcome::NotHandedIn => Text::default(),
            Outcome::HandedInTwice => phrase!("handed in more than once: {}", files()),
        };
        (!remark.is_empty()).then(|| phrase!("{}: {}", name(result), remark))
    };
    let mut remarks: Vec<Text> = results.iter().filter_map(remark).collect();
    let absent = results.iter().filter(|result| match result.outcome {
        Outcome::NotHandedIn => true,
        Outcome::Marked(_) | Outcome::Unreadable(_) | Outcome::HandedInTwice => false,
    });
    let absent = Text::joined(absent.map(name), ", ");
    remarks.extend((!absent.is_empty()).then(|| phrase!("Not handed in: {}.", absent)));
    (!remarks.is_empty()).then_some(Block::List(remarks))
}

/// Of each kind of entry, how many of the class have it right.
fn columns(exercise: &Exercise, results: &[StudentResult]) -> Table {
    let mut table = Table::new(["Order", "Direct phases", "Reverse phases", "Sums of forces", "Sums of moments"]);
    for order in &exercise.orders {
        let tables = marked(results).flat_map(|sheet| &sheet.tables).filter(|table| table.order == *order);
        let mut right = [[0_usize; 2]; 4];
        for entry in tables.flat_map(|table| &table.entries) {
            let column = match entry.place {
                Place::Phase(_, crate::proof::Sense::Direct) => 0,
                Place::Phase(_, crate::proof::Sense::Reverse) => 1,
                Place::Sum(crate::proof::Quantity::Moment, _) => 3,
                Place::Sum(..) => 2,
            };
            right[column][0] += usize::from(entry.judged == Judged::Right);
            right[column][1] += 1;
        }
        let cells = right.map(|[right, all]| phrase!("{} of {}", right, all));
        table.push([Text::from(*order)].into_iter().chain(cells).collect());
    }
    table
}
