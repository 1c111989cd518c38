//! What is a harmonic of a centric crank whose rod is very long? A few terms of its series, with a rigorous tail.
//!
//! The general way needs as many bits as λ^{k−1} has zeros; here that power is put aside, and only its product with
//! the sum of a few terms is rounded.

use num_bigint::BigInt;
use num_integer::Integer;
use num_rational::BigRational;
use num_traits::{One, Pow};

use super::enclosure::Enclosure;
use super::series::series;

/// Terms that are added: each is below 2⁻¹⁸ of the one before, where the shortcut is taken.
const TERMS: usize = 6;
/// `k λ²` is at most one in this many.
const LEAST: u32 = 1 << 16;

/// `c_k` for even k ≥ 2 and `0 < λ`, as sure as the general way has it; none where λ is not so small.
pub(super) fn harmonic(ratio: &BigRational, order: u32) -> Option<Enclosure> {
    let square = ratio * ratio;
    if square * BigRational::from_integer(BigInt::from(order) * LEAST) > BigRational::one() {
        return None;
    }
    // Σ_j a_j λ^{k−1+2j} = λ^{k−1} Σ_j a_j λ^{2j}: the terms fall by 2⁻¹⁸ and have one sign, so that all after the sixth are
    // together less than 2⁻¹⁰⁰ of the first.
    let known = series(order, TERMS);
    let lowest = order - 1;
    let terms = known.terms().iter().map(|(power, coefficient)| coefficient * Pow::pow(ratio, *power - lowest));
    let sum: BigRational = terms.sum();
    let rest = BigRational::new(BigInt::one(), BigInt::one() << 100_u32);
    let more = &sum * (BigRational::one() + rest);
    let power = (Pow::pow(ratio.numer(), lowest), Pow::pow(ratio.denom(), lowest));
    let scaled = |number: &BigRational| (number.numer() * &power.0, number.denom() * &power.1);
    Some(outward(scaled(&sum), scaled(&more)))
}

/// The numbers between two fractions, either of which may be the larger, rounded outward to 96 bits.
fn outward(one: (BigInt, BigInt), other: (BigInt, BigInt)) -> Enclosure {
    let shift = 96 + one.1.bits().saturating_sub(one.0.bits());
    let unit = BigInt::one() << shift;
    let low = |(numerator, denominator): &(BigInt, BigInt)| (numerator * &unit).div_floor(denominator);
    let (first, second) = (low(&one), low(&other));
    let (low, high) = if first <= second { (first, second) } else { (second, first) };
    Enclosure { low: BigRational::new(low, unit.clone()), high: BigRational::new(high + 1, unit) }
}
