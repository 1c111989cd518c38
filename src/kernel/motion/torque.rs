//! What are the harmonics of one cylinder's inertia torque?
//!
//! The torque is `−m s' s'' ω² = −(½ m s'²)' ω²`, and `(½ s'²)/r²` is `½ sin²ψ − sin ψ f'/λ + f'²/(2λ²)`. The middle
//! has the harmonics of f. With `A, B, R, S, p, q` as for the root, and partial fractions of `f'² = λ² cos²ψ x²/(1−x²)`,
//! `x = λ sin ψ − δ`, the last is elementary:
//!
//! `f'² = 1 − λ² cos²ψ − ½ Σ_k (R p^{|k|} ζ^k + S q^{|k|} (−ζ)^k)`,   `ζ = −i e^{iψ}`.
//!
//! Let `c_k = [k=1] + (−i)^k g_k`, g_k real. Then the n-th harmonic is `t_n = n (−i)^n (X − iY)` with
//!
//! - `X = −½ (g_{n−1}/(n−1) + g_{n+1}/(n+1))`, without the first term if n = 1,
//! - `Y = ½ [n=2] − (R p^n + (−1)^n S q^n)/(2λ²)`.

use num_rational::BigRational;
use num_traits::{Pow, Zero};

use super::ball::Ball;
use super::enclosure::{Coefficient, Enclosure, FLOOR_BITS};
use super::offset::Factor;

/// `t_n` for n ≥ 1 and λ > 0, from the real numbers g_k of the force.
pub(super) fn harmonic(
    ratio: &BigRational,
    offset: &BigRational,
    n: u32,
    force: impl Fn(u64) -> Enclosure,
) -> Coefficient {
    let over = |k: u64| force(k).times(&BigRational::new(1.into(), k.into()));
    let mut sum = over(u64::from(n) + 1);
    if n > 1 {
        sum = sum.plus(&over(u64::from(n) - 1));
    }
    let along = sum.times(&BigRational::new((-i64::from(n)).into(), 2.into()));
    let across = across(ratio, offset, n).times(&BigRational::from_integer(n.into()));
    Coefficient::turned(&along, n).plus(&Coefficient::turned(&across, n + 1))
}

/// Y, by `R p^n/λ² = λ^{n−2} R/(A+R)^n`.
fn across(ratio: &BigRational, offset: &BigRational, n: u32) -> Enclosure {
    if offset.is_zero() && !n.is_multiple_of(2) {
        return Enclosure::zero();
    }
    let power = if n == 1 { ratio.recip() } else { Pow::pow(ratio, n - 2) };
    let factor = power / BigRational::from_integer((-2).into());
    // With an offset the two parts may cancel; without one they have one sign, or there is the ½ that is larger.
    let floor = (!offset.is_zero()).then_some(FLOOR_BITS);
    Enclosure::refine(&factor, floor, |bits| {
        let part = |offset: &BigRational| {
            let Factor { root, inverse } = Factor::new(ratio, offset, bits)?;
            Some(root.times(&inverse.power(n)))
        };
        let [first, second] = [part(offset)?, part(&-offset)?];
        let sum = if n.is_multiple_of(2) { &first + &second } else { &first - &second };
        Some(if n == 2 { &sum - &Ball::integer(1, bits) } else { sum })
    })
}
