//! What are the harmonics of `√(1 − (λ sin ψ − δ)²)` with a pin offset δ?
//!
//! With `ζ = −i e^{iψ}` the root is `½ √((A+R)(B+S)) H(ζ) H(1/ζ)`, where `A = 1+δ`, `B = 1−δ`, `R = √(A²−λ²)`,
//! `S = √(B²−λ²)`, and `H(z) = √((1 − p z)(1 + q z)) = Σ h_j z^j` with `p = λ/(A+R)`, `q = λ/(B+S)`. So the harmonic of
//! `ζ^k` is `½ √((A+R)(B+S)) Σ_j h_j h_{j+k}`, a real number. H satisfies `2PH' = P'H` with `P = H²`, which is
//! `2(n+1) h_{n+1} = (q−p)(1−2n) h_n + 2pq (n−2) h_{n−1}`.
//!
//! What is cut off: the coefficients of `√(1−z)` are at most those of `2 − √(1−z)` in size, and those of
//! `(2 − √(1−z))² = 5 − z − 4√(1−z)` are at most 1. So `|h_j| ≤ t^j`, `t = max(p, q)`, and the terms from the J-th on
//! are together at most `t^{2J+k} / (1−t²)`.

use num_bigint::BigInt;
use num_rational::BigRational;
use num_traits::{Signed, ToPrimitive};

use super::ball::Ball;

/// One of the two factors of the radicand: `R = √(A² − λ²)` and `1/(A+R)`, for `A = 1 ± δ`.
pub(super) struct Factor {
    pub root: Ball,
    pub inverse: Ball,
}

impl Factor {
    /// Of `A = 1 + δ`, or of `1 − δ` with the sign of δ changed; none if the bits are too few.
    pub fn new(ratio: &BigRational, offset: &BigRational, bits: u32) -> Option<Factor> {
        let reach = BigRational::from_integer(1.into()) + offset;
        let root = Ball::rational(&((&reach - ratio) * (&reach + ratio)), bits).sqrt();
        let inverse = (&root + &Ball::rational(&reach, bits)).reciprocal()?;
        Some(Factor { root, inverse })
    }
}

/// The harmonic of `ζ^k`, k ≥ 1, with this many bits; none if they are too few.
pub(super) fn harmonic(ratio: &BigRational, offset: &BigRational, k: u64, bits: u32) -> Option<Ball> {
    let [first, second] = [Factor::new(ratio, offset, bits)?, Factor::new(ratio, &-offset, bits)?];
    let lambda = Ball::rational(ratio, bits);
    let [p, q] = [first.inverse.times(&lambda), second.inverse.times(&lambda)];
    let largest = if p.high() > q.high() { &p } else { &q };
    let terms = enough_terms(largest, k, bits);
    let h = expansion(&p, &q, terms + k as usize);
    let mut sum = Ball::integer(0, bits);
    for (one, other) in h.iter().take(terms).zip(&h[k as usize..]) {
        sum = &sum + &one.times(other);
    }
    let exponent = u32::try_from(2 * terms as u64 + k).ok()?;
    let gap = (&Ball::integer(1, bits) - &largest.times(largest)).reciprocal()?;
    let rest = largest.power(exponent).times(&gap).high();
    let scale = first.inverse.times(&second.inverse).sqrt().times_integer(2).reciprocal()?;
    Some(sum.widened(rest.max(BigInt::from(0))).times(&scale))
}

/// How many terms make the rest as small as the last bit, about: only the cost depends on it, not the guarantee.
fn enough_terms(largest: &Ball, k: u64, bits: u32) -> usize {
    let size = BigRational::new(largest.high(), BigInt::from(1) << bits).to_f64().unwrap_or(0.0);
    let bits_a_power = -size.log2();
    let powers = f64::from(bits) / bits_a_power - k as f64;
    (powers / 2.0).max(1.0).ceil() as usize + 1
}

/// `h_0 … h_{count}`.
fn expansion(p: &Ball, q: &Ball, count: usize) -> Vec<Ball> {
    let (difference, product) = (q - p, p.times(q));
    let mut h = vec![Ball::integer(1, p.bits), difference.over_integer(2)];
    for n in 1..count as i64 {
        let [.., before, last] = h.as_slice() else { break };
        let sum = &difference.times(last).times_integer(1 - 2 * n) + &product.times(before).times_integer(2 * (n - 2));
        let next = sum.over_integer(2 * n.unsigned_abs() + 2);
        h.push(next);
    }
    h
}

/// Is the crank so near to its end of reach that the expansion would take too many terms?
pub(super) fn is_too_near(sum: &BigRational) -> bool {
    let gap = BigRational::from_integer(1.into()) - sum;
    !gap.is_positive() || gap < BigRational::new(1.into(), 1_000_000.into())
}
