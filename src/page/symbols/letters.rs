//! Which letters of TeX are there, and how do they read as plain text?

use crate::text::TEX_LETTERS;

/// Commands that put a sign over a letter, with the sign that follows it in plain text.
const ACCENTS: [(&str, char); 7] = [
    ("hat", '\u{302}'),
    ("check", '\u{30c}'),
    ("bar", '\u{304}'),
    ("tilde", '\u{303}'),
    ("dot", '\u{307}'),
    ("ddot", '\u{308}'),
    ("vec", '\u{20d7}'),
];

/// Commands that set a letter in another font.
const FONTS: [&str; 4] = ["mathrm", "mathbf", "mathit", "mathcal"];

/// A letter of TeX as plain text.
pub(in crate::page) fn letter(command: &str) -> Option<char> {
    TEX_LETTERS.iter().find(|(name, _)| *name == command).map(|(_, letter)| *letter)
}

/// The sign over a letter.
pub(in crate::page) fn accent(command: &str) -> Option<char> {
    ACCENTS.iter().find(|(name, _)| *name == command).map(|(_, sign)| *sign)
}

/// Whether a command sets its letter in another font.
pub(in crate::page) fn is_font(command: &str) -> bool {
    FONTS.contains(&command)
}
