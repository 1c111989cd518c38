//! What does a person leave open? Angles and lengths that are linear in symbols: `45 + phi`, `3a + 2b`.

use std::collections::BTreeMap;
use std::fmt;

use num_rational::BigRational;
use num_traits::{One, Signed, Zero};

use super::number::parse_number;
use super::units::has_a_size;

/// `constant + Σ coefficient · symbol`, with exact coefficients, none of them zero.
#[derive(Clone, Debug, Default, PartialEq, Eq, PartialOrd, Ord)]
pub struct Linear {
    constant: Constant,
    symbols: BTreeMap<String, BigRational>,
}

/// A rational number that is 0 by default.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord)]
struct Constant(BigRational);

impl Default for Constant {
    fn default() -> Self {
        Constant(BigRational::zero())
    }
}

impl Linear {
    /// A known number.
    pub fn constant(value: BigRational) -> Self {
        Linear { constant: Constant(value), symbols: BTreeMap::new() }
    }

    /// A symbol times a coefficient.
    pub fn symbol(name: &str, coefficient: BigRational) -> Self {
        let symbols = [(name.to_owned(), coefficient)].into_iter().filter(|(_, c)| !c.is_zero()).collect();
        Linear { constant: Constant::default(), symbols }
    }

    /// The part without symbols.
    pub fn known(&self) -> &BigRational {
        &self.constant.0
    }

    /// The symbols with their coefficients, by name.
    pub fn symbols(&self) -> &BTreeMap<String, BigRational> {
        &self.symbols
    }

    /// The coefficient of a symbol, 0 where it does not occur.
    pub fn coefficient(&self, symbol: &str) -> BigRational {
        self.symbols.get(symbol).cloned().unwrap_or_else(BigRational::zero)
    }

    /// The number itself, where no symbol occurs.
    pub fn as_known(&self) -> Option<&BigRational> {
        self.symbols.is_empty().then_some(&self.constant.0)
    }

    /// The sum of both.
    pub fn plus(&self, other: &Linear) -> Linear {
        let mut sum = self.clone();
        sum.constant.0 += other.known();
        for (name, coefficient) in &other.symbols {
            *sum.symbols.entry(name.clone()).or_insert_with(BigRational::zero) += coefficient;
        }
        sum.symbols.retain(|_, coefficient| !coefficient.is_zero());
        sum
    }

    /// A multiple.
    pub fn scaled(&self, by: &BigRational) -> Linear {
        let scaled = |(name, coefficient): (&String, &BigRational)| (name.clone(), coefficient * by);
        let symbols = self.symbols.iter().map(scaled).filter(|(_, coefficient)| !coefficient.is_zero());
        Linear { constant: Constant(self.known() * by), symbols: symbols.collect() }
    }

    /// The first less the second.
    pub fn minus(&self, other: &Linear) -> Linear {
        self.plus(&other.scaled(&-BigRational::one()))
    }

    /// Puts in the values that are known; other symbols stay.
    pub fn with(&self, values: &BTreeMap<String, BigRational>) -> Linear {
        let part = |(name, coefficient): (&String, &BigRational)| match values.get(name) {
            Some(value) => Linear::constant(value * coefficient),
            None => Linear::symbol(name, coefficient.clone()),
        };
        self.symbols.iter().map(part).fold(Linear::constant(self.known().clone()), |sum, part| sum.plus(&part))
    }

    /// Reads one known quantity, which `quantity` reads, or a sum with symbols that `is_symbol` admits.
    ///
    /// The error is that of the first part that is neither.
    pub(super) fn parse(
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

/// `2a + b + 2c`, `-3/2 a`; the known part last.
impl fmt::Display for Linear {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let mut first = true;
        let known = (!self.known().is_zero() || self.symbols.is_empty()).then_some((None, self.known()));
        let symbols = self.symbols.iter().map(|(name, coefficient)| (Some(name), coefficient));
        for (name, coefficient) in symbols.chain(known) {
            let sign = match (first, coefficient.is_negative()) {
                (true, true) => "−",
                (true, false) => "",
                (false, true) => " − ",
                (false, false) => " + ",
            };
            first = false;
            let size = coefficient.abs();
            match name {
                Some(name) if size.is_one() => write!(f, "{sign}{name}")?,
                Some(name) if size.is_integer() => write!(f, "{sign}{size}{name}")?,
                Some(name) => write!(f, "{sign}{}{name}/{}", coefficient_text(size.numer()), size.denom())?,
                None => write!(f, "{sign}{size}")?,
            }
        }
        Ok(())
    }
}

fn coefficient_text(numerator: &num_bigint::BigInt) -> String {
    if numerator.is_one() { String::new() } else { numerator.to_string() }
}
