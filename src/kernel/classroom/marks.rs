//! What does a spreadsheet hold of a class? A row per student, with points and what became of the sheet.

use num_rational::BigRational;
use num_traits::ToPrimitive;

use super::results::{Outcome, StudentResult};
use super::{Convention, MarkedSheet};
use crate::table::{Column, Table, Unit, Values};
use crate::text::{Format, Untrusted};

/// The table of marks; sheets that belong to nobody have no student.
pub fn marks_table(results: &[StudentResult]) -> Table {
    let words = |pattern, about, of: &dyn Fn(&StudentResult) -> Option<String>| {
        Column::new(pattern, Unit::NONE, about, Values::Words(results.iter().map(of).collect()))
    };
    let person = |pattern, about, of: &dyn Fn(&StudentResult) -> Option<Untrusted>| {
        Column::new(pattern, Unit::NONE, about, Values::Person(results.iter().map(of).collect()))
    };
    let decimal = |pattern, about, of: &dyn Fn(&MarkedSheet) -> BigRational| {
        let value = |result: &StudentResult| rounded(&of(marked(result)?)).to_f64();
        Column::new(pattern, Unit::NONE, about, Values::Decimal(results.iter().map(value).collect()))
    };
    let whole = |pattern, about, of: &dyn Fn(&MarkedSheet) -> usize| {
        let value = |result: &StudentResult| i64::try_from(of(marked(result)?)).ok();
        Column::new(pattern, Unit::NONE, about, Values::Integer(results.iter().map(value).collect()))
    };
    let hundred = || BigRational::from_integer(100.into());
    Table::new("marks", "a student; then unassigned sheets, and files without a table", results.len())
        .with(person("student", "the name", &|result| Some(result.pupil?.name.clone())))
        .with(words("sheet", "the name of the sheet's files", &|result| Some(result.pupil?.file.clone())))
        .with(words("outcome", "what became of the sheet", &|result| Some(outcome(&result.outcome).to_owned())))
        .with(decimal("points", "those given", &|sheet| sheet.points.clone()))
        .with(decimal("points_possible", "those for a sheet without a mistake", &|sheet| sheet.possible.clone()))
        .with(decimal("percent", "points of those possible", &|sheet| sheet.part() * hundred()))
        .with(whole("right", "entries that are right", &|sheet| sheet.counts().right))
        .with(whole("consequential", "entries that follow from a mistake before", &|sheet| {
            sheet.counts().consequential
        }))
        .with(whole("wrong", "entries that are wrong", &|sheet| sheet.counts().wrong))
        .with(whole("unreadable", "entries that cannot be read", &|sheet| sheet.counts().unreadable))
        .with(whole("missing", "entries that are not there", &|sheet| sheet.counts().missing))
        .with(whole("coarse", "entries that are right to too few digits", &|sheet| sheet.counts().coarse))
        .with(words("convention", "what the student declared", &|result| Some(declared(&marked(result)?.declared))))
        .with(words("undeclared_convention", "with which more would be right", &|result| {
            marked(result)?.undeclared.first().map(declared)
        }))
        .with(person("remark", "why there are no points, or which rows have none", &|result| remark(result)))
}

fn marked<'a>(result: &'a StudentResult) -> Option<&'a MarkedSheet> {
    match &result.outcome {
        Outcome::Marked(sheet) => Some(sheet),
        Outcome::Unreadable(_) | Outcome::NotHandedIn | Outcome::HandedInTwice | Outcome::NotRead(_) => None,
    }
}

fn outcome(outcome: &Outcome) -> &'static str {
    match outcome {
        Outcome::Marked(_) => "marked",
        Outcome::Unreadable(_) => "unreadable",
        Outcome::NotHandedIn => "not handed in",
        Outcome::HandedInTwice => "handed in more than once",
        Outcome::NotRead(_) => "not read",
    }
}

fn remark(result: &StudentResult) -> Option<Untrusted> {
    let files = || result.files.iter().map(|file| file.escaped(Format::Plain)).collect::<Vec<_>>().join(" ");
    let words = match &result.outcome {
        Outcome::Marked(sheet) if !sheet.not_read.is_empty() => {
            sheet.not_read.iter().map(|row| row.escaped(Format::Plain)).collect::<Vec<_>>().join("; ")
        }
        Outcome::Marked(_) | Outcome::NotHandedIn => return None,
        Outcome::Unreadable(why) => format!("{}: {}", files(), why.escaped(Format::Plain)),
        Outcome::NotRead(why) => format!("{}: {why}", files()),
        Outcome::HandedInTwice => files(),
    };
    Some(Untrusted::new(words))
}

fn declared(convention: &Convention) -> String {
    convention.declared().iter().map(|(key, word)| format!("{key} {word}")).collect::<Vec<_>>().join("; ")
}

/// Rounded to hundredths.
fn rounded(value: &BigRational) -> BigRational {
    let hundred = BigRational::from_integer(100.into());
    (value * &hundred).round() / hundred
}
