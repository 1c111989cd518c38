//! What is the mean of all conjugates of a sum? Rational, and the sum itself where that is rational.

use std::collections::BTreeMap;

use num_integer::Integer;
use num_rational::BigRational;
use num_traits::{ToPrimitive, Zero};

use crate::exact::{PhasorSum, fraction, modulo};

/// Means are taken up to this conductor.
const LARGEST_CONDUCTOR: u64 = 1000;

/// The mean of all conjugates of a sum: rational, and the sum itself where that is rational; `None` for conductors
/// above 1000.
pub fn mean_of_conjugates(sum: &PhasorSum) -> Option<BigRational> {
    let terms = sum.collected();
    let conductor = fraction::common_denominator(terms.iter().map(|term| term.angle.turns()));
    conductor.to_u64().filter(|&n| n <= LARGEST_CONDUCTOR)?;
    let mut by_order: BTreeMap<u64, BigRational> = BTreeMap::new();
    for term in terms {
        let order = term.angle.denominator().to_u64()?;
        *by_order.entry(order).or_insert_with(BigRational::zero) += term.weight;
    }
    Some(by_order.into_iter().map(|(order, weight)| weight * of_roots(order)).sum())
}

/// The same of `Σ weight · e^{2πi·exponent/conductor}`.
pub(super) fn of_terms(conductor: u64, terms: &[(u64, i64)]) -> BigRational {
    let mut by_order: BTreeMap<u64, i64> = BTreeMap::new();
    for (exponent, weight) in terms {
        *by_order.entry(conductor / conductor.gcd(exponent)).or_insert(0) += weight;
    }
    by_order.into_iter().map(|(order, weight)| BigRational::from_integer(weight.into()) * of_roots(order)).sum()
}

/// The mean of the roots of unity of exact order n: `μ(n)/φ(n)`.
fn of_roots(order: u64) -> BigRational {
    let units = (1..=order).filter(|a| a.gcd(&order) == 1).count();
    BigRational::new(moebius(order).into(), units.into())
}

fn moebius(number: u64) -> i64 {
    let primes = modulo::prime_divisors(number);
    match primes.iter().product::<u64>() == number {
        true if primes.len().is_multiple_of(2) => 1,
        true => -1,
        false => 0,
    }
}
