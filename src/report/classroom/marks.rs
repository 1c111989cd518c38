//! How did the class do? The table of marks, what was most often wrong, and the scheme.

use num_rational::BigRational;
use num_traits::Zero;

use super::super::plot::{Axis, Curve, Plot};
use super::student::{points, read_in, rows_not_read};
use crate::claim::{Judged, Place};
use crate::classroom::{Distribution, Exercise, MarkedSheet, Outcome, Scheme, StudentResult};
use crate::numbers::{self, Form};
use crate::page::number::Amount;
use crate::page::{Block, Document, Picture, Table, Text, phrase};
use crate::report::texts::marks as text;
use crate::text::Untrusted;

/// The short answer: the table of marks.
pub fn marks_answer(results: &[StudentResult], scheme: &Scheme) -> Document {
    let mut page = Document::new("marks", "Marks");
    page.push(Block::Answer(vec![summary(results)]));
    page.push(table(results));
    page.blocks.extend(Distribution::of(results).map(|points| Block::Paragraph(spread(&points))));
    page.blocks.extend(remarks(results, scheme));
    page.push(Block::Note(text::scheme(Text::code(scheme.to_toml().trim_end().replace('\n', ", ")))));
    page
}

/// The page: the marks, what was wrong most often, the scheme.
pub fn marks_page(exercise: &Exercise, results: &[StudentResult], scheme: &Scheme) -> Document {
    text::Page {
        answer: Block::Answer(vec![summary(results)]).into(),
        table: table(results).into(),
        remarks: remarks(results, scheme).into(),
        spread: Distribution::of(results).iter().flat_map(distribution).collect(),
        columns: columns(exercise, results).into(),
        scheme: Block::Verbatim("toml", Untrusted::new(scheme.to_toml())).into(),
    }
    .document()
}

fn marked<'a>(results: &'a [StudentResult]) -> impl Iterator<Item = &'a MarkedSheet> {
    results.iter().filter_map(|result| match &result.outcome {
        Outcome::Marked(sheet) => Some(sheet.as_ref()),
        _ => None,
    })
}

/// Mean and spread of the points.
fn spread(points: &Distribution) -> Text {
    // 2831/59 tells a lecturer nothing.
    let hundredfold = &points.mean * BigRational::from_integer(100.into());
    let mean = hundredfold.is_integer().then(|| Form::rational(points.mean.clone()));
    let no_spread = points.variance.is_zero().then(|| Form::rational(BigRational::zero()));
    text::points(
        Amount { exact: mean, decimal: numbers::float(&points.mean) },
        super::student::points(&points.possible),
        Amount { exact: no_spread, decimal: numbers::float(&points.variance).sqrt() },
        points.sheets,
    )
}

/// The same, and how many sheets have which part of the points.
fn distribution(points: &Distribution) -> Vec<Block> {
    let mut table = Table::new(["Part of the points in %", "Sheets"]);
    let mut steps = Vec::new();
    for (tenth, sheets) in points.tenths.iter().enumerate() {
        let (from, to) = (10 * tenth, 10 * tenth + 10);
        table.push(vec![phrase!("{} to {}", from, to), (*sheets).into()]);
        steps.extend([from, to].map(|percent| (percent as f64, *sheets as f64)));
    }
    let (first, last) = ((0.0, 0.0), (100.0, 0.0));
    let outline = [first].into_iter().chain(steps).chain([last]).collect();
    let x = Axis::linear("Part of the points in %");
    let mut plot = Plot::new("Points", x, Axis::linear("Sheets"));
    plot.curves.push(Curve::new(0, "sheets", outline));
    let picture = Picture::new("points", text::tenths(), plot.figure());
    vec![spread(points).into(), Block::Pictures(vec![picture]), table.into()]
}

fn summary(results: &[StudentResult]) -> Text {
    let count = |is: fn(&Outcome) -> bool| results.iter().filter(|result| is(&result.outcome)).count();
    text::sheets(
        marked(results).count(),
        count(|outcome| matches!(outcome, Outcome::Unreadable(_))),
        count(|outcome| matches!(outcome, Outcome::NotHandedIn)),
        count(|outcome| matches!(outcome, Outcome::HandedInTwice)),
        results.iter().filter(|result| is_no_table(result)).count(),
    )
}

fn is_no_table(result: &StudentResult) -> bool {
    matches!(result.outcome, Outcome::NotRead(_))
}

/// A line for each student.
fn table(results: &[StudentResult]) -> Table {
    let columns = ["Student", "Points", "Of", "Right", "Wrong", "Follows", "Not readable", "Missing"];
    let mut table = Table::new(columns);
    for result in results.iter().filter(|result| !is_no_table(result)) {
        let cells: Vec<Text> = match &result.outcome {
            Outcome::Marked(sheet) => {
                let counts = sheet.counts();
                let numbers = [counts.right, counts.wrong, counts.consequential, counts.unreadable, counts.missing];
                let points = [points(&sheet.points), points(&sheet.possible)];
                points.into_iter().chain(numbers.map(Text::from)).collect()
            }
            _ => vec!["–".into(); columns.len() - 1],
        };
        table.push([name(result)].into_iter().chain(cells).collect());
    }
    table
}

fn name(result: &StudentResult) -> Text {
    result.pupil.map_or_else(|| "nobody in the exercise".into(), |pupil| Text::from(&pupil.name))
}

/// What is to be said of some: sheets that are not marked, and those that are read in another convention.
fn remarks(results: &[StudentResult], scheme: &Scheme) -> Option<Block> {
    let remark = |result: &StudentResult| {
        let files = || Text::joined(result.files.iter().map(Text::from), ", ");
        let remark = match &result.outcome {
            Outcome::Marked(sheet) => Text::joined(read_in(sheet, scheme).into_iter().chain(rows_not_read(sheet)), " "),
            Outcome::Unreadable(why) => text::cannot_be_read(files(), why),
            // All of them in one line below.
            Outcome::NotHandedIn | Outcome::NotRead(_) => Text::default(),
            Outcome::HandedInTwice => text::handed_in_twice(files()),
        };
        (!remark.is_empty()).then(|| phrase!("{}: {}", name(result), remark))
    };
    let mut remarks: Vec<Text> = results.iter().filter_map(remark).collect();
    let absent = results.iter().filter(|result| matches!(result.outcome, Outcome::NotHandedIn));
    let absent = Text::joined(absent.map(name), ", ");
    remarks.extend((!absent.is_empty()).then(|| text::not_handed_in(absent)));
    remarks.extend(not_read(results));
    (!remarks.is_empty()).then_some(Block::List(remarks))
}

/// The files that are no tables, by why they are none.
fn not_read(results: &[StudentResult]) -> Vec<Text> {
    let mut by_reason: Vec<(&'static str, Vec<Text>)> = Vec::new();
    for result in results {
        let Outcome::NotRead(why) = &result.outcome else { continue };
        let files = result.files.iter().map(Text::from);
        match by_reason.iter_mut().find(|(reason, _)| reason == why) {
            Some((_, there)) => there.extend(files),
            None => by_reason.push((*why, files.collect())),
        }
    }
    by_reason.into_iter().map(|(why, files)| text::not_read(why, Text::joined(files, ", "))).collect()
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
                Place::Sum(crate::proof::Planar::Moment, _) => 3,
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
