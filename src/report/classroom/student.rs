//! What did one student write, what is right, and how many points is that?

use num_rational::BigRational;

use super::super::{table, typeset};
use crate::claim::{Judged, Marked, Place, RightEntry};
use crate::classroom::{Convention, MarkedSheet, Pupil, Scheme};
use crate::page::number::Amount;
use crate::page::{Block, Document, Table, Text, phrase};
use crate::proof::{Planar, Sense};
use crate::report::texts::marked as text;

/// The page of a marked sheet.
pub fn marked_page(pupil: &Pupil, sheet: &MarkedSheet, scheme: &Scheme) -> Document {
    let mut answer = vec![text::points(points(&sheet.points), points(&sheet.possible)), counts(sheet)];
    answer.extend(read_in(sheet, scheme));
    answer.extend(rows_not_read(sheet));
    let orders = sheet.tables.iter().flat_map(|table| {
        let heading = Block::Heading(1, phrase!("Order {}", table.order));
        [heading, entries(pupil, sheet, table.order, &table.entries, scheme)]
    });
    text::Page { student: (&pupil.name).into(), answer: Block::Answer(answer).into(), orders: orders.collect() }
        .document()
}

/// Points in decimals that end, else a fraction.
pub(super) fn points(value: &BigRational) -> Text {
    Text::label(typeset::number(value))
}

/// How many entries are right, wrong and so on.
pub(super) fn counts(sheet: &MarkedSheet) -> Text {
    let counts = sheet.counts();
    text::counts(counts.right, counts.wrong, counts.consequential, counts.coarse, counts.unreadable, counts.missing)
}

/// In which convention the sheet is read, where it is not the one above the table.
pub(super) fn read_in(sheet: &MarkedSheet, scheme: &Scheme) -> Vec<Text> {
    let mut told = Vec::new();
    if sheet.declared != Convention::default() {
        told.push(text::declared(named(&sheet.declared)));
    }
    let others = sheet.undeclared.iter().map(named);
    if !sheet.undeclared.is_empty() {
        told.push(text::undeclared(Text::joined(others, ", or "), points(&scheme.undeclared)));
    }
    told
}

/// The rows that belong nowhere in the table.
pub(super) fn rows_not_read(sheet: &MarkedSheet) -> Option<Text> {
    let rows = Text::joined(sheet.not_read.iter().map(Text::from), ", ");
    (!sheet.not_read.is_empty()).then(|| text::rows_not_read(rows))
}

/// `sense clockwise, vectors swapped`; that of the sheet where nothing is otherwise.
fn named(convention: &Convention) -> Text {
    let declared = convention.declared();
    match declared.is_empty() {
        true => "that of the sheet".into(),
        false => Text::joined(declared.into_iter().map(|(key, word)| Text::code(format!("{key} = {word}"))), ", "),
    }
}

fn entries(pupil: &Pupil, sheet: &MarkedSheet, order: u32, entries: &[Marked], scheme: &Scheme) -> Block {
    let part = if sheet.undeclared.is_empty() { one() } else { scheme.undeclared.clone() };
    let table = Table::of(entries)
        .column("Entry", |entry| place(pupil, entry.place))
        .column("Written", |entry| entry.written.as_ref().map_or_else(|| "–".into(), Text::from))
        .column("Answer", |entry| answer(entry.judged))
        .column("Right", |entry| match entry.judged {
            Judged::Right => Text::default(),
            _ => right(pupil, sheet, order, entry),
        })
        .column("Points", |entry| points(&(scheme.points(entry) * &part)));
    table.done().into()
}

fn one() -> BigRational {
    BigRational::from_integer(1.into())
}

fn answer(judged: Judged) -> Text {
    match judged {
        Judged::Right => "correct".into(),
        Judged::Coarse => "**too few digits**".into(),
        Judged::Consequential => "**follows**".into(),
        Judged::Wrong => "**wrong**".into(),
        Judged::Unreadable => "**not readable**".into(),
        Judged::Missing => "**missing**".into(),
    }
}

fn place(pupil: &Pupil, place: Place) -> Text {
    match place {
        Place::Phase(cylinder, sense) => {
            let name = pupil.engine.cylinders()[cylinder].name.clone();
            match sense {
                Sense::Direct => phrase!("cylinder {}, direct phase", name),
                Sense::Reverse => phrase!("cylinder {}, reverse phase", name),
            }
        }
        Place::Sum(Planar::Moment, Sense::Direct) => "sum of moments, direct".into(),
        Place::Sum(Planar::Moment, Sense::Reverse) => "sum of moments, reverse".into(),
        Place::Sum(Planar::Force, Sense::Direct) => "sum of forces, direct".into(),
        Place::Sum(Planar::Force, Sense::Reverse) => "sum of forces, reverse".into(),
    }
}

/// What belongs there, worked out where the convention is that of the sheet.
fn right(pupil: &Pupil, sheet: &MarkedSheet, order: u32, entry: &Marked) -> Text {
    match (&entry.right, entry.place) {
        (RightEntry::Angle(_), Place::Phase(cylinder, sense)) if *sheet.convention() == Convention::default() => {
            let formula = table::phase_formula(i64::from(order), sense, true);
            phrase!("{}: {}", formula, table::working(&pupil.engine.cylinders()[cylinder], order, sense))
        }
        (RightEntry::Angle(angle), _) => Text::label(typeset::angle(angle)),
        (RightEntry::Length(exact, decimal), _) => Amount { exact: exact.clone(), decimal: *decimal }.into(),
    }
}
