//! Which characters act instead of being seen? Control characters and those that turn the direction of writing.

use std::fmt::Write;

/// Whether a terminal or an editor obeys a character instead of showing it.
pub(super) fn acts(letter: char) -> bool {
    letter.is_control()
        || matches!(letter,
            // Marks, embeddings, overrides and isolates of direction; line and paragraph separators.
            '\u{061c}' | '\u{200e}' | '\u{200f}' | '\u{2028}'..='\u{202e}' | '\u{2066}'..='\u{2069}'
            // Without width: what is compared by eye is not what is there.
            | '\u{00ad}' | '\u{200b}'..='\u{200d}' | '\u{2060}'..='\u{2065}' | '\u{206a}'..='\u{206f}' | '\u{feff}'
            | '\u{fff9}'..='\u{fffb}' | '\u{e0000}'..='\u{e007f}')
}

fn shown(text: &str, is_kept: impl Fn(char) -> bool) -> String {
    let mut out = String::with_capacity(text.len());
    for letter in text.chars() {
        match acts(letter) && !is_kept(letter) {
            // Writing to a string cannot fail.
            true => drop(write!(out, "[U+{:04X}]", u32::from(letter))),
            false => out.push(letter),
        }
    }
    out
}

/// The text with as many bytes and signs in place of the characters that act, so that places in it stay what they are.
pub fn of_equal_length(text: &str) -> String {
    let sign = |letter: char| match (acts(letter) && letter != '\n' && letter != '\t', letter.len_utf8()) {
        (false, _) => letter.to_string(),
        (true, 1) => "?".to_owned(),
        (true, 2) => "¿".to_owned(),
        (true, 3) => "\u{fffd}".to_owned(),
        (true, _) => "\u{fffd}?".to_owned(),
    };
    text.chars().map(sign).collect()
}

/// A text for a terminal in which this program has set colours: those stay, all else that acts is shown.
pub fn harmless_but_colours(text: &str) -> String {
    let mut pieces = text.split("\u{1b}[");
    let mut out = harmless_lines(pieces.next().unwrap_or_default());
    for piece in pieces {
        let end = piece.find(|letter: char| !letter.is_ascii_digit() && letter != ';').unwrap_or(piece.len());
        out.push_str(if piece[end..].starts_with('m') { "\u{1b}[" } else { "[U+001B][" });
        out.push_str(&harmless_lines(piece));
    }
    out
}

/// The text in one line: spaces of any kind are one, and a character that acts is shown as `[U+001B]`.
pub fn harmless(text: &str) -> String {
    shown(&text.split_whitespace().collect::<Vec<_>>().join(" "), |_| false)
}

/// The text with its lines and spaces; a character that acts is shown as `[U+001B]`.
pub fn harmless_lines(text: &str) -> String {
    shown(text, |letter| letter == '\n' || letter == '\t')
}
