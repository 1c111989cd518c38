//! How is a text written in a table for spreadsheets? In quotes where it needs them, and never as a formula.

/// A field: in quotes where it holds a comma, a quote or the end of a line.
pub fn field(text: &str) -> String {
    match text.contains([',', '"', '\n', '\r']) {
        true => format!("\"{}\"", text.replace('"', "\"\"")),
        false => text.to_owned(),
    }
}

/// A text that no spreadsheet computes with: an apostrophe stands before what would begin a formula.
pub(super) fn inert(text: String) -> String {
    match text.starts_with(['=', '+', '-', '@', '＝', '＋', '－', '＠']) {
        true => format!("'{text}"),
        false => text,
    }
}
