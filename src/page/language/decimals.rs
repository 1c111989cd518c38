//! Which points in a text are those of decimals? Those between two digits.

/// The text with another sign for the point of decimals.
pub(super) fn with(text: &str, sign: &str) -> String {
    let mut out = String::with_capacity(text.len());
    let mut letters = text.chars().peekable();
    let mut before = ' ';
    while let Some(letter) = letters.next() {
        let between = before.is_ascii_digit() && letters.peek().is_some_and(char::is_ascii_digit);
        match letter {
            '.' if between => out.push_str(sign),
            other => out.push(other),
        }
        before = letter;
    }
    out
}

/// Whether a comma stands between two digits.
pub(in crate::page) fn has_comma(text: &str) -> bool {
    let digit = |letter: Option<&u8>| letter.is_some_and(u8::is_ascii_digit);
    text.as_bytes().windows(3).any(|three| three[1] == b',' && digit(three.first()) && digit(three.last()))
}
