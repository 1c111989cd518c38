//! What are the harmonics of the side force that the inertia of one piston makes?
//!
//! The rod stands askew by the angle whose sine is `x = λ sin ψ − δ`, so that the force `F = −m s̈` of the piston pushes the
//! crankpin with F along the axis and with `−F x/w`, `w = √(1−x²)`, across it, towards ψ = 90°. Differentiating w twice,
//!
//! `F x/(w m r ω²) = −w'/λ + sin ψ (1 − 1/w²) + ½ cos ψ (1/w²)' = Re Σ −i n_k e^{ikψ}`.
//!
//! The first term has the harmonics of the root, and so of the force: `(c_k − [k=1])/k` in n_k. The others are elementary. With
//! `A, B, R, S, p, q` and `ζ = −i e^{iψ}` as for the root, by partial fractions
//!
//! `1/w² = ½ Σ_k (p^{|k|}/R + (−q)^{|k|}/S) ζ^k`,
//!
//! and their part of n_k is `u_k = i (−i)^k E_k` with the real numbers
//!
//! - `E_k = [k=1] − ¼ (h_k(p, R) − (−1)^k h_k(q, S))`, `h_k(p, R) = p^{k−1} ((k+1) − (k−1) p²)/R`, for k ≥ 1,
//! - `E_0 = −¼ (p/R − q/S)`, a constant force.
//!
//! **Theorem.** For λ > 0 and an offset no u_k is zero; without an offset exactly those of odd k are not zero.
//!
//! *Proof.* `h_k > 0`, and `∂h_k/∂p = (k²−1) p^{k−2} (1−p²)/R > 0` for k > 1. For δ > 0 is p < q and R > S, so that `h_k(p, R) <
//! h_k(q, S)`, and likewise for k = 0: at even k the difference is not zero. At odd k > 1 the sum is not. `E_1 = 1 − (1/R +
//! 1/S)/2` is one less the mean of 1/w², and w < 1 but for single angles. For δ = 0 both parts are equal. ∎

use num_rational::BigRational;
use num_traits::{One, Pow, Zero};

use super::ball::Ball;
use super::enclosure::{Enclosure, rational_root};
use super::offset::Factor;

/// Whether E_k is not zero.
pub(super) fn exists(ratio: &BigRational, offset: &BigRational, k: u32) -> bool {
    if ratio.is_zero() {
        return k == 1 && !offset.is_zero();
    }
    !offset.is_zero() || !k.is_multiple_of(2)
}

/// E_k: exact where both roots are rational, else enclosed.
pub(super) fn harmonic(ratio: &BigRational, offset: &BigRational, k: u32) -> Enclosure {
    if !exists(ratio, offset, k) {
        return Enclosure::zero();
    }
    if let Some(number) = rational(ratio, offset, k) {
        return Enclosure::point(number);
    }
    let power = Pow::pow(ratio, k.abs_diff(1)) / BigRational::from_integer((-4).into());
    Enclosure::refine(&power, None, |bits| {
        let part = |offset: &BigRational| {
            let Factor { root, inverse } = Factor::new(ratio, offset, bits)?;
            let fall = Ball::rational(ratio, bits).times(&inverse).power(2);
            let bracket = match i64::from(k) {
                0 => Ball::integer(1, bits),
                k => &Ball::integer(k + 1, bits) - &fall.times_integer(k - 1),
            };
            Some(inverse.power(k.abs_diff(1)).times(&bracket).times(&root.reciprocal()?))
        };
        let [first, second] = [part(offset)?, part(&-offset)?];
        let sum = if k.is_multiple_of(2) { &first - &second } else { &first + &second };
        // The one beside order 1 is four times that, for the factor before the sum.
        Some(if k == 1 { &sum - &Ball::integer(4, bits) } else { sum })
    })
}

/// E_k where R and S are rational, as without an offset for λ = 3/5 or 7/25.
pub(super) fn rational(ratio: &BigRational, offset: &BigRational, k: u32) -> Option<BigRational> {
    let part = |offset: &BigRational| {
        let reach = BigRational::one() + offset;
        let root = rational_root(&((&reach - ratio) * (&reach + ratio))).filter(|root| !root.is_zero())?;
        let fall = ratio / (reach + &root);
        let whole = |number: i64| BigRational::from_integer(number.into());
        let k = i64::from(k);
        let bracket = if k == 0 { whole(1) } else { whole(k + 1) - whole(k - 1) * &fall * &fall };
        Some(Pow::pow(fall, k.unsigned_abs().abs_diff(1)) * bracket / root)
    };
    let [first, second] = [part(offset)?, part(&-offset)?];
    let sum = if k.is_multiple_of(2) { first - second } else { first + second };
    let one = if k == 1 { BigRational::one() } else { BigRational::zero() };
    Some(one - sum / BigRational::from_integer(4.into()))
}
