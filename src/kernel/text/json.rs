//! How is JSON written on a terminal? As the same JSON, with escapes for what a terminal would obey.

use std::fmt::Write;

use super::terminal::acts;

/// JSON in which characters that act stand as escapes, as serde writes them for some.
pub fn json(json: &str) -> String {
    let mut out = String::with_capacity(json.len());
    for letter in json.chars() {
        if !acts(letter) || letter == '\n' {
            out.push(letter);
            continue;
        }
        for unit in letter.encode_utf16(&mut [0; 2]) {
            // Writing to a string cannot fail.
            let _ = write!(out, "\\u{unit:04x}");
        }
    }
    out
}
