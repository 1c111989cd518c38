//! How does a link move its piston, beside what its master rod gives it?
//!
//! The knuckle pin of the link is at the radius a and, seen from the crankpin, at the angle Δ of its cylinder. With `κ = a/l`,
//! `z = 1 − κ e^{iΔ}` and the length L of the link, the harmonics of even order are `κ c_k(λ) e^{ikΔ} + |z| c_k(r|z|/L) e^{ik arg z}`
//! in those c_k of centric cranks: the pin of the link is off the cylinder axis by `r |z| sin(ψ + arg z)`, one sinusoid.
//!
//! The second part is `g_k z^k`, with the real number `g_k = |z|^{1−k} c_k(r|z|/L)`: z^k is an exact sum of rotating vectors, and g_k is
//! its coefficient.
//!
//! **Theorem.** For even k and finite L, g_k is not zero; it has the sign of c_k, and is the same for Δ and −Δ.
//!
//! *Proof.* `c_k(λ) = λ^{k−1} h(λ²)`, h a power series whose terms have one sign (theory, section 2), so that
//! `g_k = (r/L)^{k−1} h((r|z|/L)²)`; and `|z|² = 1 − 2κ cos Δ + κ²`. ∎
//!
//! h grows with λ², which turns bounds of |z| into bounds of g_k.

use num_bigint::BigInt;
use num_integer::Integer;
use num_rational::BigRational;
use num_traits::{One, Signed, Zero};

use super::ball::Ball;
use super::circle::cosine_and_sine;
use super::crank::SliderCrank;
use super::enclosure::Enclosure;

/// Bits behind the point that |z| is computed to.
const BITS: u32 = 256;
/// Bits that the ends of an enclosure keep.
const KEPT_BITS: i64 = 96;

/// A link that lets the crank turn round: r/L, κ = a/l and Δ in turns, exact.
#[derive(Clone, Debug)]
pub struct Linkage {
    /// r/L.
    ratio: BigRational,
    /// Below and above r|z|/L.
    ends: [SliderCrank; 2],
}

impl Linkage {
    /// None where the crank cannot turn round, or comes nearer to that than the bits tell; κ is positive.
    pub fn new(ratio: BigRational, knuckle: BigRational, turns: BigRational) -> Option<Self> {
        if ratio.is_negative() || !knuckle.is_positive() {
            return None;
        }
        let one = BigRational::one();
        let both = Ball::rational(&(&one + &knuckle * &knuckle), BITS);
        let across = Ball::rational(&knuckle, BITS).times_integer(2).times(&cosine_and_sine(&turns, BITS)[0]);
        let reach = (&both - &across).sqrt().times(&Ball::rational(&ratio, BITS));
        let unit = BigInt::one() << BITS;
        let ends = [reach.low(), reach.high()].map(|end| BigRational::new(end.max(BigInt::zero()), unit.clone()));
        // A link whose pin all but stays on the cylinder axis has |z| that no bound below tells from 0.
        if !ratio.is_zero() && ends[0].is_zero() {
            return None;
        }
        let [low, high] = ends.map(|end| SliderCrank::new(end, BigRational::zero()).ok());
        Some(Linkage { ratio, ends: [low?, high?] })
    }

    /// Whether g_k is not zero.
    pub fn exists(&self, order: u32) -> bool {
        order > 0 && order.is_multiple_of(2) && !self.ratio.is_zero()
    }

    /// g_k: exactly zero, or enclosed to a relative 2^−60.
    pub fn number(&self, order: u32) -> Enclosure {
        if !self.exists(order) {
            return Enclosure::zero();
        }
        // All have one sign, and the sizes of the second end are not below those of the first.
        let of_end = |crank: &SliderCrank| {
            let Enclosure { low, high } = crank.coefficient(order).re;
            let scale = &self.ratio / crank.ratio();
            let scales = [false, true].map(|up| power(&scale, order - 1, up));
            scales.into_iter().flat_map(move |scale| [&low * &scale, &high * scale])
        };
        let all: Vec<BigRational> = self.ends.iter().flat_map(of_end).collect();
        let least = all.iter().min().cloned().unwrap_or_else(BigRational::zero);
        let most = all.into_iter().max().unwrap_or_else(BigRational::zero);
        Enclosure { low: rounded(&least, false), high: rounded(&most, true) }
    }

    /// A bound of |z|, from above.
    pub fn distance(&self) -> BigRational {
        if self.ratio.is_zero() { BigRational::zero() } else { self.ends[1].ratio() / &self.ratio }
    }

    /// The centric crank whose harmonics, times |z|, the link adds at most.
    pub fn crank(&self) -> &SliderCrank {
        &self.ends[1]
    }
}

/// A power of a number above 0, no step of which has more than [`KEPT_BITS`] bits, rounded up or down.
fn power(number: &BigRational, exponent: u32, up: bool) -> BigRational {
    (0..u32::BITS - exponent.leading_zeros()).rev().fold(BigRational::one(), |power, bit| {
        let square = rounded(&(&power * &power), up);
        if exponent >> bit & 1 == 1 { rounded(&(square * number), up) } else { square }
    })
}

/// The number with [`KEPT_BITS`] bits, rounded up or down.
fn rounded(number: &BigRational, up: bool) -> BigRational {
    let shift = KEPT_BITS - number.numer().bits() as i64 + number.denom().bits() as i64;
    let [finer, coarser] = [shift.max(0), (-shift).max(0)].map(|bits| BigInt::one() << bits);
    let (above, below) = (number.numer() * &finer, number.denom() * &coarser);
    let whole = if up { above.div_ceil(&below) } else { above.div_floor(&below) };
    BigRational::new(whole * coarser, finer)
}
