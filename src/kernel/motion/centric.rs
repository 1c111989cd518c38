//! What are the harmonics of `√(1 − λ² sin²ψ)`, however near λ is to 0 or 1?
//!
//! `√(1 − λ² sin²ψ) = a_0 + 2 Σ a_m cos 2mψ`. The first two come from the complete elliptic integrals by the
//! arithmetic-geometric mean M of 1 and κ' = √(1−λ²) (Gauss; Abramowitz and Stegun, 17.6): with `κ_0 = λ` and
//! `κ_{n+1}` half the difference of the n-th pair,
//!
//! - `a_0 = (2/π) E(λ) = (1 − Σ 2^{n−1} κ_n²) / M`,
//! - `a_1 = ((2 − λ²) a_0 − 2 (1 − λ²)/M) / (3λ²)`;
//!
//! the others from `(2n+3) a_{n+1} = −(8/λ² − 4) n a_n − (2n−3) a_{n−1}`. This recurrence loses bits at every step, for the
//! a_m are its solution that falls; the balls see the loss, and the caller asks again with more bits.

use num_bigint::BigInt;
use num_rational::BigRational;

use super::ball::Ball;

/// `a_m` for 0 < λ < 1 with this many bits; none if they are too few to tell λ from 1.
pub(super) fn harmonic(ratio: &BigRational, m: u64, bits: u32) -> Option<Ball> {
    let square = ratio * ratio;
    let integer = |number: i64| BigRational::from_integer(number.into());
    let complement = Ball::rational(&(integer(1) - &square), bits);
    let (inverse_mean, first) = first_two(&square, &complement, bits)?;
    if m == 0 {
        return Some(first);
    }
    let two_less = Ball::rational(&(integer(2) - &square), bits);
    let difference = &two_less.times(&first) - &complement.times(&inverse_mean).times_integer(2);
    let second = difference.times(&Ball::rational(&(integer(1) / (integer(3) * &square)), bits));
    let middle = Ball::rational(&(integer(8) / &square - integer(4)), bits);
    let mut pair = (first, second);
    for n in 1..m as i64 {
        let sum = &middle.times(&pair.1).times_integer(n) + &pair.0.times_integer(2 * n - 3);
        let next = -sum.over_integer(2 * n.unsigned_abs() + 3);
        pair = (pair.1, next);
    }
    Some(pair.1)
}

/// `1/M` and `a_0`.
fn first_two(square: &BigRational, complement: &Ball, bits: u32) -> Option<(Ball, Ball)> {
    let (mut larger, mut smaller) = (Ball::integer(1, bits), complement.sqrt());
    smaller.reciprocal()?;
    let mut sum = Ball::rational(&(square / BigRational::from_integer(2.into())), bits);
    let mut doublings = 0_u32;
    loop {
        let half = (&larger - &smaller).over_integer(2);
        let next = (&larger + &smaller).over_integer(2);
        smaller = larger.times(&smaller).sqrt();
        larger = next;
        let term = half.times(&half).times_integer(1 << doublings);
        sum = &sum + &term;
        doublings += 1;
        // Each pair is at most half as far apart as the one before, so all later terms together are at most this one.
        if half.middle <= half.radius || doublings > 60 {
            let rest = term.high();
            let mean = Ball::between(smaller.low(), larger.high(), bits);
            let inverse_mean = mean.reciprocal()?;
            let first = (&Ball::integer(1, bits) - &sum).widened(rest.max(BigInt::from(0))).times(&inverse_mean);
            return Some((inverse_mean, first));
        }
    }
}
