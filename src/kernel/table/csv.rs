//! How is a table written as comma-separated values? A line of names, then a line a row, each decimal with all its digits.

use std::borrow::Cow;
use std::fmt::{Arguments, Write};

use super::{Table, Values};
use crate::text::{self, Format};

/// Sizes from which on a decimal is written with a power of ten, and below which.
const PLAIN: std::ops::Range<f64> = 1e-5..1e15;

/// The table as RFC 4180 has it, with `\n` at the end of each line.
///
/// A decimal reads back to the same number. A text that a spreadsheet would take for a formula has an apostrophe before it.
pub fn csv(table: &Table) -> String {
    header(table) + &rows(table)
}

/// The line of names.
pub fn header(table: &Table) -> String {
    let names: Vec<String> = table.columns().iter().map(|column| text::field(column.name())).collect();
    names.join(",") + "\n"
}

/// The lines of the rows.
pub fn rows(table: &Table) -> String {
    let mut all = String::with_capacity(table.rows() * table.columns().len() * 8);
    for row in 0..table.rows() {
        for (place, column) in table.columns().iter().enumerate() {
            if place > 0 {
                all.push(',');
            }
            field(&mut all, column.values(), row);
        }
        all.push('\n');
    }
    all
}

/// Adds a field; nothing is written where there is nothing to say.
fn field(all: &mut String, values: &Values, row: usize) {
    match values {
        // Nothing of this program's own begins as a formula does, but for numbers.
        Values::Words(values) | Values::Exact(values) => match values[row].as_deref().unwrap_or_default() {
            plain if plain.bytes().all(|byte| byte.is_ascii_alphanumeric() || b"./-".contains(&byte)) => {
                all.push_str(plain)
            }
            other => all.push_str(&text::field(other)),
        },
        Values::Person(values) => {
            let text = values[row].as_ref().map(|text| text::field(&text.escaped(Format::Csv)));
            all.push_str(&text.unwrap_or_default());
        }
        Values::Integer(values) => values[row].into_iter().for_each(|value| add(all, format_args!("{value}"))),
        Values::Decimal(values) => values[row].into_iter().for_each(|value| decimal(all, value)),
        Values::Truth(values) => all.push_str(values[row].map_or("", |value| if value { "true" } else { "false" })),
    }
}

/// Adds what is formatted: a text takes all.
fn add(all: &mut String, what: Arguments<'_>) {
    let _ = all.write_fmt(what);
}

/// The shortest decimal that reads back to the same number; none of what is beyond decimals.
fn decimal(all: &mut String, value: f64) {
    let size = value.abs();
    match value.is_finite() {
        false => {}
        // No minus before 0.
        true if size == 0.0 => all.push('0'),
        true if PLAIN.contains(&size) => add(all, format_args!("{value}")),
        true => add(all, format_args!("{value:e}")),
    }
}

/// The rows of a table like this one, from their lines; none where they are no such rows. A text of a person stays as it was escaped.
pub fn from_rows(like: &Table, lines: &str) -> Option<Table> {
    let mut columns: Vec<Values> = like.columns().iter().map(|column| column.values().of_rows(0..0)).collect();
    let (mut rest, mut rows) = (lines, 0);
    while !rest.is_empty() {
        for (place, values) in columns.iter_mut().enumerate() {
            let (text, end, after) = next_field(rest)?;
            let is_last = place + 1 == like.columns().len();
            (is_last == (end == '\n')).then_some(())?;
            values.read(text)?;
            rest = after;
        }
        rows += 1;
    }
    let filled = like.columns().iter().zip(columns).map(|(column, values)| column.with(values));
    Some(filled.fold(Table::new(like.name(), like.about(), rows), Table::with))
}

/// The next field without its quotes, what ends it, and what comes behind.
fn next_field(text: &str) -> Option<(Cow<'_, str>, char, &str)> {
    let Some(quoted) = text.strip_prefix('"') else {
        let at = text.find([',', '\n'])?;
        let end = if text[at..].starts_with(',') { ',' } else { '\n' };
        return Some((Cow::Borrowed(&text[..at]), end, &text[at + 1..]));
    };
    let mut from = 0;
    loop {
        let at = from + quoted[from..].find('"')?;
        let mut behind = quoted[at + 1..].chars();
        match behind.next()? {
            '"' => from = at + 2,
            end @ (',' | '\n') => {
                return Some((Cow::Owned(quoted[..at].replace("\"\"", "\"")), end, behind.as_str()));
            }
            _ => return None,
        }
    }
}
