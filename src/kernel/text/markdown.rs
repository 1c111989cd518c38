//! How is a text written in Markdown? No sign of it is markup, of HTML neither, nor of the formulas in dollars.

/// Plain text, anywhere in a line, a cell or a link's caption.
pub fn markdown(text: &str) -> String {
    let mut out = String::new();
    for (at, letter) in text.char_indices() {
        match letter {
            '<' => out.push_str("&lt;"),
            '>' => out.push_str("&gt;"),
            '&' => out.push_str("&amp;"),
            '\\' | '`' | '*' | '_' | '{' | '}' | '[' | ']' | '#' | '|' | '$' | '~' | '!' | '^' | '@' => {
                out.push('\\');
                out.push(letter);
            }
            // What would begin a list in a list.
            '-' | '+' | '.' | ')' if begins_list(&text[..at], letter, &text[at + 1..]) => {
                out.push('\\');
                out.push(letter);
            }
            _ => out.push(letter),
        }
    }
    out
}

/// Whether a sign with what stands before and behind it begins an entry of a list.
fn begins_list(before: &str, sign: char, behind: &str) -> bool {
    let number = !before.is_empty() && before.bytes().all(|byte| byte.is_ascii_digit());
    let first = if sign == '-' || sign == '+' { before.is_empty() } else { number };
    first && (behind.is_empty() || behind.starts_with(' '))
}
