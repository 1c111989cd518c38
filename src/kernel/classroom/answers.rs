//! What does a student hand in? A table in TOML, or rows of a spreadsheet, and what is filled in there.

use serde::Deserialize;
use serde_spanned::Spanned;

use super::convention::{Convention, KEYS, PLANE};
use super::lines;
use super::submission::{Answers, Owner, Record, Submission, not_asked_for};
use crate::claim::Filled;
use crate::claim::student::{Row, Sums, filled, order};
use crate::engine::Engine;
use crate::file::LayoutError;
use crate::file::written::{Table, Text, place, read};

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct File {
    student: Option<Text>,
    sheet: Option<Text>,
    convention: Option<Table<ConventionTable>>,
    table: Option<Vec<Spanned<Table<TableKeys>>>>,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct ConventionTable {
    sense: Option<Text>,
    throws: Option<Text>,
    vectors: Option<Text>,
    plane: Option<Text>,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct TableKeys {
    order: Text,
    rows: Option<Vec<Spanned<Table<Row>>>>,
    sums: Option<Table<Sums>>,
}

/// The table of a TOML file, with whose it is; what is wrong is reported with its line.
pub(super) fn in_toml(source: String) -> Result<(Owner, Submission), String> {
    let file: File = read(&source).map_err(|error| told(&error, &source))?;
    let words =
        |text: Option<Text>| text.map(|text| text.get_ref().0.trim().to_owned()).filter(|words| !words.is_empty());
    Ok((Owner { sheet: words(file.sheet), student: words(file.student) }, Submission::Toml(source)))
}

impl Submission {
    /// Whether nothing is filled in.
    pub fn is_empty(&self) -> bool {
        match self {
            Submission::Toml(source) => read::<File>(source).is_ok_and(|file| {
                file.table.iter().flatten().map(|table| &table.get_ref().0).all(|table| {
                    let rows = table.rows.iter().flatten().all(|row| row.get_ref().0.is_empty());
                    rows && table.sums.as_ref().is_none_or(|sums| sums.0.is_empty())
                })
            }),
            Submission::Rows(records) => records.iter().all(Record::is_empty),
        }
    }

    /// What is filled in, of this engine and these orders.
    pub fn answers(&self, engine: &Engine, orders: &[u32]) -> Result<Answers, String> {
        match self {
            Submission::Toml(source) => of_toml(source, engine, orders).map_err(|error| told(&error, source)),
            Submission::Rows(records) => lines::answers(records, engine, orders),
        }
    }
}

fn of_toml(source: &str, engine: &Engine, orders: &[u32]) -> Result<Answers, LayoutError> {
    let file: File = read(source)?;
    let mut convention = Convention::default();
    if let Some(Table(declared)) = &file.convention {
        let values = [&declared.sense, &declared.throws, &declared.vectors, &declared.plane];
        let keys = KEYS.map(|(key, _)| key).into_iter().chain([PLANE]);
        for (key, text) in keys.zip(values).filter_map(|(key, text)| Some((key, text.as_ref()?))) {
            let written = &text.get_ref().0;
            let declared = convention.declare(key, written, engine);
            declared
                .map_err(|right| LayoutError::new(format!("cannot read the {key} `{written}`"), right, place(text)))?;
        }
    }
    let (mut tables, mut not_read): (Vec<(u32, Filled)>, _) = (Vec::new(), Vec::new());
    for table in file.table.iter().flatten().map(|table| &table.get_ref().0) {
        let order = order(&table.order)?;
        if let Some((message, right)) = not_asked_for(order, orders) {
            not_read.push(told(&LayoutError::new(message, right, place(&table.order)), source));
            continue;
        }
        if tables.iter().any(|(there, _)| *there == order) {
            let message = format!("order {order} has a table before");
            return Err(LayoutError::new(message, "one table per order", place(&table.order)));
        }
        tables.push((order, filled(engine, table.rows.iter().flatten(), table.sums.as_ref())?));
    }
    Ok(Answers { convention, tables, not_read })
}

/// A mistake in one line, with the number of the line where it is.
fn told(error: &LayoutError, source: &str) -> String {
    let line = error.span().and_then(|span| source.get(..span.start)).map(|before| before.matches('\n').count() + 1);
    let line = line.map(|line| format!("line {line}: ")).unwrap_or_default();
    format!("{line}{}; {}", error.message(), error.right())
}
