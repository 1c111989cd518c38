//! Between which bounds do cosine and sine of a turn lie? Whole numbers over a power of two, without floats.

use std::ops::RangeInclusive;

use num_bigint::BigInt;
use num_rational::BigRational;
use num_traits::{One, ToPrimitive, Zero};

use super::ball::{Ball, Complex};

/// The bits that a document may ask for: fewer are not worth it, more are not computed.
const ASKED: RangeInclusive<u32> = 32..=512;

/// Checks the bits that a document asks for.
pub(super) fn check_bits(bits: u32) -> Result<(), String> {
    let (fewest, most) = (ASKED.start(), ASKED.end());
    if ASKED.contains(&bits) { Ok(()) } else { Err(format!("an enclosure has {fewest} to {most} bits")) }
}

/// Bits that are computed beyond those that are answered for.
const GUARD: u32 = 32;

/// Cosines and sines, each to less than two units of the last of its bits.
#[derive(Debug)]
pub(super) struct Circle {
    bits: u32,
    /// 2π with the guard bits, to within 2^8 of their units.
    tau: BigInt,
}

impl Circle {
    /// Up to some ten thousand bits; each of the fewer than 2^16 roundings below is then covered by the guard bits.
    pub fn new(bits: u32) -> Self {
        // Hutton: π/4 = 2 arctan(1/3) + arctan(1/7).
        let tau = arctan_of_inverse(3, bits + GUARD) * 16 + arctan_of_inverse(7, bits + GUARD) * 8;
        Circle { bits, tau }
    }

    pub fn bits(&self) -> u32 {
        self.bits
    }

    /// What one angle costs in steps.
    pub fn steps(&self) -> u64 {
        let words = u64::from(self.bits / 64 + 1);
        u64::from(self.bits / 6) * (words * words / 8 + 4) / 32 + 1
    }

    /// e^{2πi·turns}, in units of `2^−bits`.
    pub fn direction(&self, turns: &BigRational) -> Complex {
        let (cos, sin) = self.cos_sin(turns);
        let part = |middle| Ball { middle, doubt: 2.into() };
        Complex { re: part(cos), im: part(sin) }
    }

    /// `(cos, sin)` times `2^bits`, each off by less than 2.
    pub fn cos_sin(&self, turns: &BigRational) -> (BigInt, BigInt) {
        // Measured from the nearest quarter turn, |x| ≤ π/4.
        let half = BigRational::new(1.into(), 2.into());
        let quarter = (turns * BigRational::from_integer(4.into()) + half).floor();
        let from_quarter = turns - &quarter / BigRational::from_integer(4.into());
        let x = &self.tau * from_quarter.numer() / from_quarter.denom();
        let (cos, sin) = self.series(&x);
        let quarter: BigInt = quarter.to_integer() & BigInt::from(3);
        match quarter.to_u8() {
            Some(0) => (cos, sin),
            Some(1) => (-sin, cos),
            Some(2) => (-cos, -sin),
            _ => (sin, -cos),
        }
    }

    /// Both series at once: term n is `xⁿ/n!`, with signs + + − − in turn; what follows the last term is smaller than it.
    fn series(&self, x: &BigInt) -> (BigInt, BigInt) {
        let scale = self.bits + GUARD;
        let (mut cos, mut sin) = (BigInt::zero(), BigInt::zero());
        let mut term = BigInt::one() << scale;
        for n in 0_u32.. {
            if term.magnitude().is_one() || term.is_zero() {
                break;
            }
            match n % 4 {
                0 => cos += &term,
                1 => sin += &term,
                2 => cos -= &term,
                _ => sin -= &term,
            }
            term = ((&term * x) >> scale) / (n + 1);
        }
        (cos >> GUARD, sin >> GUARD)
    }
}

/// `arctan(1/q)` times `2^bits`: an alternating series whose terms fall.
fn arctan_of_inverse(q: u32, bits: u32) -> BigInt {
    let mut power = (BigInt::one() << bits) / q;
    let mut sum = BigInt::zero();
    for n in 0_u32.. {
        if power.is_zero() {
            break;
        }
        let term = &power / (2 * n + 1);
        if n % 2 == 0 {
            sum += term;
        } else {
            sum -= term;
        }
        power /= q * q;
    }
    sum
}
