//! How is a quantity with unknowns written? `45 + phi`, `3a + 2b`, `a/2`.

use num_rational::BigRational;
use num_traits::{One, Zero};

use super::number::parse_number;
use super::units::has_a_size;
use crate::engine::Linear;

/// Reads one known quantity, which `quantity` reads, or a sum with symbols that `is_symbol` admits.
///
/// The error is that of the first part that is neither.
pub(super) fn read(
    text: &str,
    quantity: impl Fn(&str) -> Result<BigRational, String>,
    is_symbol: impl Fn(&str) -> bool,
) -> Result<Linear, String> {
    let whole = quantity(text).map(Linear::constant);
    if whole.is_ok() || !parts(text).iter().any(|(_, part)| symbol_term(part, &is_symbol).is_some()) {
        return whole;
    }
    let mut sum = Linear::default();
    for (sign, part) in parts(text) {
        let term = match symbol_term(part, &is_symbol) {
            Some(term) => term,
            None => Linear::constant(quantity(part)?),
        };
        sum = sum.plus(&term.scaled(&sign));
    }
    Ok(sum)
}

/// The parts of a sum with their signs. A sign that begins the text, or an exponent, belongs to its number.
fn parts(text: &str) -> Vec<(BigRational, &str)> {
    let mut parts = Vec::new();
    let (mut sign, mut start) = (BigRational::one(), 0);
    let mut before = ' ';
    for (place, letter) in text.char_indices() {
        let is_sign = matches!(letter, '+' | '-' | '−');
        let begins = text[start..place].trim().is_empty();
        if is_sign && !begins && !matches!(before, 'e' | 'E' | '/') {
            parts.push((sign, text[start..place].trim()));
            sign = if letter == '+' { BigRational::one() } else { -BigRational::one() };
            start = place + letter.len_utf8();
        }
        if !letter.is_whitespace() {
            before = letter;
        }
    }
    parts.push((sign, text[start..].trim()));
    parts
}

/// `a`, `-2a`, `1.5*a`, `3/2 a`, `a/2`.
fn symbol_term(text: &str, is_symbol: &impl Fn(&str) -> bool) -> Option<Linear> {
    let begin = text.find(char::is_alphabetic)?;
    let end =
        text[begin..].find(|letter: char| !letter.is_alphanumeric() && letter != '_').map_or(text.len(), |n| begin + n);
    let name = &text[begin..end];
    let coefficient = match text[..begin].trim().trim_end_matches(['*', '·']).trim() {
        "" | "+" => BigRational::one(),
        "-" | "−" => -BigRational::one(),
        number => parse_number(number).ok()?,
    };
    let divisor = match text[end..].trim() {
        "" => BigRational::one(),
        rest => parse_number(rest.strip_prefix('/')?).ok().filter(|divisor| !divisor.is_zero())?,
    };
    let coefficient = coefficient / divisor;
    (is_symbol(name) && has_a_size(&coefficient)).then(|| Linear::symbol(name, coefficient))
}
