//! How is a table written as comma-separated values? A line of names, then a line a row, each decimal with all its digits.

use super::{Table, Values};
use crate::text::{self, Format};

/// Sizes from which on a decimal is written with a power of ten, and below which.
const PLAIN: std::ops::Range<f64> = 1e-5..1e15;

/// The table as RFC 4180 has it, with `\n` at the end of each line.
///
/// A decimal reads back to the same number. A text that a spreadsheet would take for a formula has an apostrophe before it.
pub fn csv(table: &Table) -> String {
    let line = |fields: &mut dyn Iterator<Item = String>| fields.collect::<Vec<_>>().join(",") + "\n";
    let header = line(&mut table.columns().iter().map(|column| text::field(column.name())));
    let row = |row: usize| line(&mut table.columns().iter().map(|column| field(column.values(), row)));
    header + &(0..table.rows()).map(row).collect::<String>()
}

fn field(values: &Values, row: usize) -> String {
    let shown = match values {
        // Nothing of this program's own begins as a formula does, but for numbers.
        Values::Words(values) | Values::Exact(values) => values[row].as_deref().map(text::field),
        Values::Person(values) => values[row].as_ref().map(|text| text::field(&text.escaped(Format::Csv))),
        Values::Whole(values) => values[row].map(|value| value.to_string()),
        Values::Decimal(values) => values[row].and_then(decimal),
        Values::Truth(values) => values[row].map(|value| value.to_string()),
    };
    shown.unwrap_or_default()
}

/// The shortest decimal that reads back to the same number; none of what is beyond decimals.
fn decimal(value: f64) -> Option<String> {
    let size = value.abs();
    match value.is_finite() {
        false => None,
        // No minus before 0.
        true if size == 0.0 => Some("0".to_owned()),
        true if PLAIN.contains(&size) => Some(value.to_string()),
        true => Some(format!("{value:e}")),
    }
}
