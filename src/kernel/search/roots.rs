//! How long is a sum of weighted roots of unity of any order? An exact square with its enclosure.

use super::value::{self, Value};
use crate::exact::Turn;
use crate::numbers;

/// All roots of unity of an order in fixed point, each off by less than one unit.
pub(super) struct Roots(Vec<[i64; 2]>);

impl Roots {
    /// Those of this order, which is above 0.
    pub fn new(order: usize) -> Self {
        let angle = |exponent| Turn::fraction(exponent, order as i64);
        let quarter = Turn::fraction(1, 4);
        Roots((0..order as i64).map(|e| [cosine(&angle(e)), cosine(&(&angle(e) - &quarter))]).collect())
    }

    /// Their number.
    pub fn order(&self) -> usize {
        self.0.len()
    }

    /// The square of a sum of powers with weights, the sum of whose moduli is below 2^20.
    pub fn square(&self, terms: &[(usize, i64)]) -> Value {
        let sum = |part: usize| terms.iter().map(|(exponent, weight)| weight * self.0[*exponent][part]).sum::<i64>();
        let doubt = terms.iter().map(|(_, weight)| weight.abs()).sum();
        Value::of(self.order(), terms, value::square(sum(0), sum(1), doubt))
    }
}

/// Bits behind the point.
pub(super) const BITS: u32 = 40;

/// The cosine in units of 2^−40, off by less than one: the decimal is good to 2^−52, and rounding adds a half.
pub(super) fn cosine(angle: &Turn) -> i64 {
    (numbers::direction(angle).re * (1_i64 << BITS) as f64).round() as i64
}
