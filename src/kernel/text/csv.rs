//! How is a text written in a table for spreadsheets? In quotes where it needs them, and never as a formula.

/// A field: in quotes where it holds a comma, a quote or the end of a line.
pub fn field(text: &str) -> String {
    if text.contains([',', '"', '\n', '\r']) { format!("\"{}\"", text.replace('"', "\"\"")) } else { text.to_owned() }
}

/// A text that no spreadsheet computes with: an apostrophe stands before what would begin a formula.
pub(super) fn inert(text: String) -> String {
    if text.starts_with(['=', '+', '-', '@', '＝', '＋', '－', '＠']) { format!("'{text}") } else { text }
}
