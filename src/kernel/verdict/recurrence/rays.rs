//! Are the banks alike? Then the sum of an order is the star of one bank times the star of the banks, at every order.

use std::collections::BTreeMap;

use num_rational::BigRational;
use num_traits::Zero;

use crate::exact::{Term, Turn};
use crate::proof::RayClaim;

/// A term that turns on by the same angle from order to order: at order k it is at `k·per_order + fixed`.
pub(super) struct Ray {
    /// `β − α` in direct sums, `α − β` in reverse ones.
    pub per_order: Turn,
    /// The bank angle α.
    pub fixed: Turn,
    /// Its weight.
    pub weight: BigRational,
}

impl Ray {
    /// The same as data.
    pub(super) fn claim(self) -> RayClaim {
        let [per_order, fixed] = [self.per_order, self.fixed].map(|turn| turn.turns().clone());
        RayClaim { per_order, fixed, weight: self.weight }
    }

    /// The term of an order.
    pub(super) fn at(&self, order: u32) -> Term {
        Term { angle: &self.per_order.times(order.into()) + &self.fixed, weight: self.weight.clone() }
    }
}

/// The rays of one bank: weights by the turn from order to order.
type Bank = BTreeMap<Turn, BigRational>;

/// Rays with each direction once.
pub(super) enum Factors {
    /// As they are.
    One(Vec<Ray>),
    /// As a product.
    Banks { bank: Vec<Ray>, banks: Vec<Ray> },
}

/// The rays, as a product where they are one.
pub(super) fn factors(rays: Vec<Ray>) -> Factors {
    let mut banks: BTreeMap<Turn, Bank> = BTreeMap::new();
    for ray in rays {
        *banks.entry(ray.fixed).or_default().entry(ray.per_order).or_insert_with(BigRational::zero) += ray.weight;
    }
    for bank in banks.values_mut() {
        bank.retain(|_, weight| !weight.is_zero());
    }
    banks.retain(|_, bank| !bank.is_empty());
    product(&banks).unwrap_or_else(|| {
        let of_bank = |(fixed, bank): (Turn, Bank)| {
            bank.into_iter().map(move |(per_order, weight)| Ray { per_order, fixed: fixed.clone(), weight })
        };
        Factors::One(banks.into_iter().flat_map(of_bank).collect())
    })
}

/// The star of a bank, and that of the banks, where each bank is the first one turned on and weighed.
fn product(banks: &BTreeMap<Turn, Bank>) -> Option<Factors> {
    let (_, star) = banks.first_key_value()?;
    if banks.len() < 2 || star.len() < 2 {
        return None;
    }
    let of_bank = |(fixed, bank): (&Turn, &Bank)| {
        let (per_order, weight) = copied(star, bank)?;
        Some(Ray { per_order, fixed: fixed.clone(), weight })
    };
    let of_banks = banks.iter().map(of_bank).collect::<Option<Vec<Ray>>>()?;
    let of_star = |(per_order, weight): (&Turn, &BigRational)| Ray {
        per_order: per_order.clone(),
        fixed: Turn::zero(),
        weight: weight.clone(),
    };
    Some(Factors::Banks { bank: star.iter().map(of_star).collect(), banks: of_banks })
}

/// By which turn and weight the star becomes the bank.
fn copied(star: &Bank, bank: &Bank) -> Option<(Turn, BigRational)> {
    let (first, weight) = star.first_key_value()?;
    let is_copy = |turn: &Turn, times: &BigRational| {
        star.iter().all(|(at, weight)| bank.get(&(at + turn)).is_some_and(|other| *other == weight * times))
    };
    let moves = bank.iter().map(|(at, other)| (at - first, other / weight));
    // Of several turns that do, as an even star has them, the one that repeats first.
    let copies = moves.filter(|(turn, times)| star.len() == bank.len() && is_copy(turn, times));
    copies.min_by_key(|(turn, _)| turn.denominator().clone())
}
