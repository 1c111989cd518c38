//! Which orders of a long pattern may be zero at all? All others are left, by a lemma of conductors.
//!
//! In a sum of n rays with rational weights that vanishes every ray i has a partner j with `R·(angle_i − angle_j)` whole, R the product
//! of the primes up to n (the lemma in `src/kernel/proof/README.md`).

use num_bigint::BigInt;
use num_integer::Integer;
use num_rational::BigRational;
use num_traits::{One, ToPrimitive};

use super::rays::Ray;

/// More orders than this that may be zero are not judged, of one factor and parity.
pub const MOST_CANDIDATES: usize = 1000;

/// `k·step + start ≡ 0` modulo `modulus`: when two rays are partners.
struct Partners {
    modulus: u64,
    step: u64,
    start: u64,
}

impl Partners {
    /// None where they never are.
    fn of(one: &Ray, other: &Ray, times: &BigRational) -> Option<Self> {
        let per_order = (one.per_order.turns() - other.per_order.turns()) * times;
        let over = BigRational::from_integer(per_order.denom().clone());
        let start = (one.fixed.turns() - other.fixed.turns()) * times * &over;
        if !start.is_integer() {
            return None;
        }
        let modulus = per_order.denom();
        let word = |number: &BigInt| number.mod_floor(modulus).to_u64();
        Some(Partners { modulus: modulus.to_u64()?, step: word(per_order.numer())?, start: word(start.numer())? })
    }

    fn at(&self, order: u64) -> bool {
        (u128::from(order) * u128::from(self.step) + u128::from(self.start)).is_multiple_of(u128::from(self.modulus))
    }
}

/// The orders of one period from the first on, every other one, that may be zero; none where there are too many of them.
pub(super) fn candidates(rays: &[Ray], first_order: u32, period: u32) -> Option<Vec<u32>> {
    let is_prime = |number: &usize| (2..*number).all(|divisor| !usize::is_multiple_of(*number, divisor));
    let product = (2..=rays.len()).filter(is_prime).fold(BigInt::one(), |product, prime| product * prime);
    let times = BigRational::from_integer(product);
    let partners: Vec<Vec<Partners>> = rays
        .iter()
        .enumerate()
        .map(|(place, one)| {
            let others = rays.iter().enumerate().filter(|(other, _)| *other != place);
            others.filter_map(|(_, other)| Partners::of(one, other, &times)).collect()
        })
        .collect();
    let may_be_zero =
        |order: &u32| partners.iter().all(|partners| partners.iter().any(|partner| partner.at(u64::from(*order))));
    let orders = (0..period / 2).map(|index| first_order + 2 * index).filter(may_be_zero);
    let found: Vec<u32> = orders.take(MOST_CANDIDATES + 1).collect();
    (found.len() <= MOST_CANDIDATES).then_some(found)
}
