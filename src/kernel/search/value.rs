//! Which of two moments is larger? Squared moduli in Q(ζ_N), compared exactly.

use std::cmp::Ordering;

use num_rational::BigRational;

use crate::exact::{self, PhasorSum, Term, Turn};
use crate::numbers;

/// The square `|Σ w ζ^{kt}|²`, with whole w (twice the arms): four times the squared moment in spacings.
#[derive(Clone, Debug)]
pub(super) struct Value {
    /// Exact: the coefficient of each power of ζ_N.
    coefficients: Vec<i64>,
    /// An enclosure in units of 2^−80.
    pub low: i128,
    /// Its upper end.
    pub high: i128,
}

impl Value {
    /// The square of a sum of weighted powers of ζ, the root of unity of this order, with an enclosure of it.
    pub fn of(roots: usize, terms: &[(usize, i64)], (low, high): (i128, i128)) -> Self {
        let mut coefficients = vec![0; roots];
        for &(exponent, weight) in terms {
            for &(other, other_weight) in terms {
                coefficients[(exponent + roots - other) % roots] += weight * other_weight;
            }
        }
        let zero = low <= 0 && is_zero(&coefficients);
        Value { coefficients, low, high: if zero { 0 } else { high } }
    }

    /// Whether it is zero, by proof.
    pub fn is_zero(&self) -> bool {
        self.high == 0
    }

    /// The order of the real numbers: equal where they are, by decision and not by decimals.
    pub fn compare(&self, other: &Value) -> Ordering {
        if self.high < other.low {
            return Ordering::Less;
        }
        if self.low > other.high {
            return Ordering::Greater;
        }
        let difference: Vec<i64> = self.coefficients.iter().zip(&other.coefficients).map(|(a, b)| a - b).collect();
        if is_zero(&difference) {
            return Ordering::Equal;
        }
        // Not zero: bits are added until the sign is certain.
        if numbers::evaluate(&phasors(&difference)).re < 0.0 { Ordering::Less } else { Ordering::Greater }
    }
}

/// The enclosure of `x² + y²`, where both are off by at most `doubt`.
pub(super) fn square(x: i64, y: i64, doubt: i64) -> (i128, i128) {
    let squared = |length: i64| i128::from(length) * i128::from(length);
    let low = |x: i64| squared((x.abs() - doubt).max(0));
    let high = |x: i64| squared(x.abs() + doubt);
    (low(x) + low(y), high(x) + high(y))
}

fn is_zero(coefficients: &[i64]) -> bool {
    let terms = (0_u64..).zip(coefficients.iter().copied()).filter(|(_, coefficient)| *coefficient != 0);
    exact::vanishes(&(coefficients.len() as u64), &terms.collect::<Vec<_>>())
}

fn phasors(coefficients: &[i64]) -> PhasorSum {
    let term = |(exponent, &coefficient): (i64, &i64)| Term {
        angle: Turn::fraction(exponent, coefficients.len() as i64),
        weight: BigRational::from_integer(coefficient.into()),
    };
    PhasorSum::new((0..).zip(coefficients).map(term).collect())
}
