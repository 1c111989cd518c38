//! Is this a name for a symbol, and how does it read as plain text? A letter, with accents, primes and an index.

use super::letters::{accent, is_font, letter};

/// A name in TeX as plain text; none where it is no name that LaTeX, KaTeX and MathML all set.
pub(super) fn spelled(tex: &str) -> Option<String> {
    let (base, rest) = base(tex)?;
    let primes = rest.bytes().take_while(|byte| *byte == b'\'').count();
    let index = match &rest[primes..] {
        "" => String::new(),
        rest => index(rest.strip_prefix('_')?)?,
    };
    Some(format!("{base}{}{index}", "′".repeat(primes)))
}

/// Whether a plain name holds letters and digits alone: it is in every format as it is.
pub(super) fn is_plain(text: &str) -> bool {
    let is_sign = |letter: char| ('\u{300}'..='\u{36f}').contains(&letter) || "\u{20d7}′".contains(letter);
    text.chars().next().is_some_and(char::is_alphabetic) && text.chars().all(|it| it.is_alphanumeric() || is_sign(it))
}

/// A letter, a command for one, or an accent over one; and what is behind it.
fn base(tex: &str) -> Option<(String, &str)> {
    let Some(command) = tex.strip_prefix('\\') else {
        let first = tex.chars().next().filter(char::is_ascii_alphabetic)?;
        return Some((first.to_string(), &tex[1..]));
    };
    let length = command.bytes().take_while(u8::is_ascii_alphabetic).count();
    let (name, rest) = command.split_at(length);
    if let Some(letter) = letter(name) {
        return Some((letter.to_string(), rest));
    }
    let sign = match accent(name) {
        Some(sign) => sign.to_string(),
        None => is_font(name).then(String::new)?,
    };
    let rest = rest.trim_start();
    match rest.strip_prefix('{') {
        Some(inside) => {
            let (inside, rest) = inside.split_once('}')?;
            let (letter, nothing) = base(inside)?;
            nothing.is_empty().then(|| (format!("{letter}{sign}"), rest))
        }
        // Without braces only a command follows: `\hat\beta`.
        None if rest.starts_with('\\') => base(rest).map(|(letter, rest)| (format!("{letter}{sign}"), rest)),
        None => None,
    }
}

/// `1`, `{12}`, `{\mathrm{x}}` without further signs.
fn index(tex: &str) -> Option<String> {
    let inside = match tex.strip_prefix('{') {
        Some(inside) => inside.strip_suffix('}')?,
        None => tex,
    };
    if !inside.is_empty() && inside.bytes().all(|byte| byte.is_ascii_digit()) {
        let lowered = |digit: char| char::from_u32(u32::from('₀') + digit.to_digit(10)?);
        return inside.chars().map(lowered).collect();
    }
    let (letter, nothing) = base(inside)?;
    nothing.is_empty().then(|| format!("_{letter}"))
}
