//! What do the terms of a sum come to? Each direction once.

use std::collections::BTreeMap;

use num_bigint::BigInt;
use num_integer::Integer;
use num_rational::BigRational;
use num_traits::Zero;

use super::audit::{Audit, steps_of_longest};
use super::refusal::Refusal;
use super::vector::Vector;

/// Collected terms: weight by angle in `[0, 1)`, no weight zero.
pub(super) type Collected = BTreeMap<BigRational, BigRational>;

/// The least common multiple, the larger number divided first: the cost is that of the smaller.
pub(super) fn common_multiple(large: &BigInt, small: &BigInt) -> BigInt {
    large * (small / (large % small).gcd(small))
}

/// The angle in `[0, 1)`.
pub(super) fn turn(angle: &BigRational) -> BigRational {
    angle - angle.floor()
}

/// Collects terms.
pub(super) fn collect(
    vectors: impl IntoIterator<Item = (BigRational, BigRational)>,
    audit: &Audit,
) -> Result<Collected, Refusal> {
    let mut collected = Collected::new();
    for (angle, weight) in vectors {
        let sum = collected.entry(turn(&angle)).or_insert_with(BigRational::zero);
        audit.spend(steps_of_longest([&angle, &weight, sum]))?;
        *sum += weight;
    }
    collected.retain(|_, weight| !weight.is_zero());
    Ok(collected)
}

/// Collects the terms of a document.
pub(super) fn collected(terms: &[Vector], audit: &Audit) -> Result<Collected, Refusal> {
    collect(terms.iter().map(|term| (term.angle.clone(), term.weight.clone())), audit)
}

/// The collected terms as a document writes them.
pub(super) fn vectors(sum: Collected) -> Vec<Vector> {
    sum.into_iter().map(|(angle, weight)| Vector { angle, weight }).collect()
}

/// `|A|² − |B|²`, where `|S|² = Σ_j Σ_l w_j w_l e^{2πi(t_j − t_l)}`.
pub(super) fn difference_of_squares(a: &Collected, b: &Collected, audit: &Audit) -> Result<Collected, Refusal> {
    for sum in [a, b] {
        let pairs = (sum.len() as u64).saturating_mul(sum.len() as u64);
        audit.spend(pairs.saturating_mul(steps_of_longest(sum.iter().flat_map(|(t, w)| [t, w]))))?;
    }
    let products = |sum: &'_ Collected, sign: i64| -> Vec<(BigRational, BigRational)> {
        let sign = BigRational::from_integer(sign.into());
        let product =
            |(s, v): (&BigRational, &BigRational), (t, w): (&BigRational, &BigRational)| (s - t, v * w * &sign);
        sum.iter().flat_map(|first| sum.iter().map(move |second| (first, second))).map(|(a, b)| product(a, b)).collect()
    };
    collect(products(a, 1).into_iter().chain(products(b, -1)), audit)
}
