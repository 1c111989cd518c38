//! What are the harmonics of a centric crank as series in λ?

use std::fmt;

use num_bigint::BigInt;
use num_rational::BigRational;
use num_traits::{One, Pow, Signed, Zero};

use super::enclosure::Enclosure;

/// The first terms of the series of one harmonic `c_k(λ)` of a centric crank, with exact rational coefficients.
///
/// All terms have one sign, so a partial sum loses no accuracy and lies on the near side of the limit.
///
/// ```standalone_crate
/// # use crankstar_kernel as crankstar;
/// assert_eq!(crankstar::motion::series(2, 3).to_string(), "λ + λ³/4 + 15λ⁵/128 + …");
/// assert_eq!(crankstar::motion::series(4, 2).to_string(), "−(λ³/4 + 3λ⁵/16 + …)");
/// ```
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Series {
    order: u32,
    terms: Vec<(u32, BigRational)>,
    /// The first term that was cut off; none if nothing was.
    next: Option<(u32, BigRational)>,
}

/// The series of order k, cut off after a number of terms (theory, section 2). For odd k it is finite: 1 or 0.
///
/// `c_{2m} = (2m)² · 2(−1)^m Σ_{j≥m} (−1)^j C(½,j) C(2j,j−m) 4^{−j} λ^{2j−1}`.
pub fn series(order: u32, terms: usize) -> Series {
    if order % 2 == 1 || order == 0 {
        let constant = (order == 1).then(|| (0, BigRational::one()));
        return Series { order, terms: constant.into_iter().collect(), next: None };
    }
    let mut all: Vec<(u32, BigRational)> = vec![first_term(order)];
    for place in 0..terms {
        let (power, coefficient) = &all[place];
        all.push((power + 2, coefficient * growth(order, *power)));
    }
    let next = all.pop();
    Series { order, terms: all, next }
}

/// The term j = m: `(2m)² · 2 C(½,m) 4^{−m} λ^{2m−1}`.
fn first_term(order: u32) -> (u32, BigRational) {
    let fraction = |numerator: i64, denominator: i64| BigRational::new(numerator.into(), denominator.into());
    let square = BigRational::from_integer(BigInt::from(order) * order * 2);
    // C(½,j)/4 from C(½,j−1): (3/2 − j)/(4j).
    let factors = (1..=i64::from(order / 2)).map(|j| fraction(3 - 2 * j, 8 * j));
    (order - 1, factors.fold(square, |product, factor| product * factor))
}

/// The quotient of two neighbouring coefficients, from `λ^{2j−1}` to `λ^{2j+1}`: `(j² − ¼)/((j+1)² − m²)`.
///
/// It falls while it is above 1, and stays below 1 afterwards.
fn growth(order: u32, power: u32) -> BigRational {
    let (twice, order) = (BigInt::from(power) + 1, BigInt::from(order));
    let above = &twice * &twice - 1;
    BigRational::new(above, (&twice + 2) * (&twice + 2) - &order * &order)
}

impl Series {
    /// The order k.
    pub fn order(&self) -> u32 {
        self.order
    }

    /// The terms: a power of λ and its coefficient.
    pub fn terms(&self) -> &[(u32, BigRational)] {
        &self.terms
    }

    /// The partial sum at λ, exact.
    pub fn value(&self, ratio: &BigRational) -> BigRational {
        self.terms.iter().map(|term| at(term, ratio)).fold(BigRational::zero(), |sum, term| sum + term)
    }

    /// What is cut off at λ is at most this in size, and has the sign of the terms. None unless `0 ≤ λ < 1`.
    ///
    /// From the first term omitted on, the terms fall at least like a geometric series; where they still grow, at high
    /// orders and large λ, those that grow are added first.
    pub fn tail(&self, ratio: &BigRational) -> Option<BigRational> {
        if ratio.is_negative() || *ratio >= BigRational::one() {
            return None;
        }
        let Some((mut power, coefficient)) = self.next.clone() else { return Some(BigRational::zero()) };
        let square = ratio * ratio;
        let mut term = at(&(power, coefficient), ratio).abs();
        let mut bound = BigRational::zero();
        loop {
            let growth = growth(self.order, power);
            let quotient = growth.clone().max(BigRational::one()) * &square;
            if quotient < BigRational::one() {
                return Some(bound + term / (BigRational::one() - quotient));
            }
            bound += &term;
            term *= growth * &square;
            power += 2;
        }
    }

    /// The harmonic at λ, between the partial sum and that with its tail. None unless `0 ≤ λ < 1`.
    pub fn enclosure(&self, ratio: &BigRational) -> Option<Enclosure> {
        let (value, tail) = (self.value(ratio), self.tail(ratio)?);
        let is_negative = self.next.as_ref().is_some_and(|(_, coefficient)| coefficient.is_negative());
        Some(if is_negative {
            Enclosure { low: &value - tail, high: value }
        } else {
            Enclosure { high: &value + tail, low: value }
        })
    }

    /// The terms joined; a common minus sign stands before brackets.
    fn written(&self, dots: &str, write: impl Fn(u32, &BigRational) -> String) -> String {
        let mut pieces: Vec<String> = self.terms.iter().map(|(power, number)| write(*power, &number.abs())).collect();
        if self.next.is_some() {
            pieces.push(dots.to_owned());
        }
        if pieces.is_empty() {
            return "0".to_owned();
        }
        let sum = pieces.join(" + ");
        let is_negative = self.terms.first().is_some_and(|(_, coefficient)| coefficient.is_negative());
        let minus = if dots == "…" { "−" } else { "-" };
        if is_negative { format!("{minus}({sum})") } else { sum }
    }
}

fn at((power, coefficient): &(u32, BigRational), ratio: &BigRational) -> BigRational {
    coefficient * Pow::pow(ratio, *power)
}

impl fmt::Display for Series {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.written("…", |power, coefficient| {
            let letter = if power == 0 { String::new() } else { format!("λ{}", superscript(power)) };
            let numerator = coefficient.numer();
            let number = if numerator.is_one() && power > 0 { String::new() } else { numerator.to_string() };
            let divisor = if coefficient.is_integer() { String::new() } else { format!("/{}", coefficient.denom()) };
            number + &letter + &divisor
        }))
    }
}

/// A power as raised digits; none for the first.
fn superscript(power: u32) -> String {
    const DIGITS: [char; 10] = ['⁰', '¹', '²', '³', '⁴', '⁵', '⁶', '⁷', '⁸', '⁹'];
    if power == 1 {
        return String::new();
    }
    power.to_string().bytes().filter_map(|digit| DIGITS.get(usize::from(digit.wrapping_sub(b'0')))).collect()
}
