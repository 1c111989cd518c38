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
