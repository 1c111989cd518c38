//! Which star is the longer one? Decided exactly.

use std::cmp::Ordering;

use super::{FiringPattern, FiringStar, StarOrder};
use crate::exact::PhasorSum;
use crate::numbers;

/// Compares the lengths of two sums.
pub fn by_length(a: &PhasorSum, b: &PhasorSum) -> Ordering {
    numbers::sign(&a.squared_modulus().minus(&b.squared_modulus()).tidied())
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
