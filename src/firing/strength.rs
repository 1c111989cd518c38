//! Which star is the longer one? Decided exactly.

use std::cmp::Ordering;

use num_traits::Signed;

use super::{FiringPattern, FiringStar, StarOrder};
use crate::exact::PhasorSum;
use crate::numbers;

/// Bits behind the point at the first attempt.
const FIRST_BITS: u32 = 128;

/// Compares the lengths of two sums: that they are equal is decided, and unequal ones are distinguished by an enclosure of
/// `|A|² − |B|²` that is narrowed until it excludes zero.
pub fn by_length(a: &PhasorSum, b: &PhasorSum) -> Ordering {
    let difference = a.squared_modulus().minus(&b.squared_modulus()).tidied();
    if difference.vanishes() {
        return Ordering::Equal;
    }
    let mut bits = FIRST_BITS;
    loop {
        let [(low, high), _] = numbers::enclose(&difference, bits);
        match (low.is_positive(), high.is_negative()) {
            (true, _) => return Ordering::Greater,
            (_, true) => return Ordering::Less,
            (false, false) => bits *= 2,
        }
    }
}

impl FiringPattern {
    /// The minor orders with the longest star, rising, of those that have no mirror image below ([`FiringPattern::half`]); none where
    /// no minor order is left, or where the cylinders are of several classes, whose stars have no common measure.
    pub fn strongest_minor(&self) -> Vec<&StarOrder> {
        let minor = self.half().filter(|order| !order.vanishes() && !order.is_major());
        let stars: Option<Vec<(&StarOrder, &FiringStar)>> = minor.map(|order| Some((order, order.only()?))).collect();
        let mut strongest: Vec<(&StarOrder, &FiringStar)> = Vec::new();
        for (order, star) in stars.unwrap_or_default() {
            match strongest.first().map(|(_, longest)| by_length(&star.sum, &longest.sum)) {
                None | Some(Ordering::Equal) => strongest.push((order, star)),
                Some(Ordering::Greater) => strongest = vec![(order, star)],
                Some(Ordering::Less) => {}
            }
        }
        strongest.into_iter().map(|(order, _)| order).collect()
    }
}
