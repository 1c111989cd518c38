//! What does a person leave open? Angles and lengths that are linear in symbols: `45 + phi`, `3a + 2b`.

use std::collections::BTreeMap;
use std::fmt;

use num_rational::BigRational;
use num_traits::{One, Signed, Zero};

use crate::exact::fraction;

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
        let constant = Constant(fraction::plus(self.known(), other.known()));
        let mut sum = Linear { constant, symbols: self.symbols.clone() };
        for (name, coefficient) in &other.symbols {
            *sum.symbols.entry(name.clone()).or_insert_with(BigRational::zero) += coefficient;
        }
        sum.symbols.retain(|_, coefficient| !coefficient.is_zero());
        sum
    }

    /// Turns as degrees, as a person types them; the unknowns as they are.
    pub(crate) fn in_degrees(&self) -> String {
        let degrees = fraction::times(self.known(), &BigRational::from_integer(360.into()));
        match self.symbols.is_empty() {
            true => fraction::written(&degrees, fraction::MOST_PLACES),
            false => Linear { constant: Constant(degrees), symbols: self.symbols.clone() }.to_string(),
        }
    }

    /// A multiple.
    pub fn scaled(&self, by: &BigRational) -> Linear {
        let scaled = |(name, coefficient): (&String, &BigRational)| (name.clone(), fraction::times(coefficient, by));
        let symbols = self.symbols.iter().map(scaled).filter(|(_, coefficient)| !coefficient.is_zero());
        Linear { constant: Constant(fraction::times(self.known(), by)), symbols: symbols.collect() }
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
