//! What are cosine and sine of a turn, to any precision? Whole numbers scaled by a power of two.
//!
//! Nothing of the platform's mathematics library enters, so the digits are the same on every machine.

use std::cell::RefCell;
use std::collections::BTreeMap;

use num_bigint::BigInt;
use num_rational::BigRational;
use num_traits::{One, ToPrimitive, Zero};

use super::ball::Ball;

/// Each cosine is off by less than this many units of the last bit: some hundred roundings of its series.
pub const DOUBT: i64 = 1 << 16;

/// Fixed-point arithmetic: a number `x` is held as the whole number nearest `x · 2^bits`, up to a few units.
pub struct FixedPoint {
    bits: u32,
    tau: BigInt,
}

/// The cosine of a number of turns, and its sine.
pub(super) fn cosine_and_sine(turns: &BigRational, bits: u32) -> [Ball; 2] {
    let (cos, sin) = FixedPoint::new(bits).cos_sin(&(turns - turns.floor()));
    [cos, sin].map(|middle| Ball { middle, radius: DOUBT.into(), bits })
}

impl FixedPoint {
    /// Arithmetic with this many bits behind the point.
    pub fn new(bits: u32) -> Self {
        // Machin's formula costs more than a cosine: it is asked for once per precision and thread.
        let tau = TAUS.with_borrow_mut(|taus| taus.entry(bits).or_insert_with(|| tau(bits)).clone());
        FixedPoint { bits, tau }
    }

    /// `(cos, sin)` of an angle from 0 to a turn.
    pub fn cos_sin(&self, turns: &BigRational) -> (BigInt, BigInt) {
        // Eighths of a turn: within the last half of a quarter, measure back from the next axis.
        let eighth = (turns.numer() * 8_u32 / turns.denom()).to_u32().unwrap_or(0);
        let axis = eighth.div_ceil(2);
        let from_axis = turns.numer() * 4_u32 - turns.denom() * axis;
        let x = &self.tau * from_axis / (turns.denom() * 4_u32);
        let (cos, sin) = self.taylor(&x);
        match axis % 4 {
            0 => (cos, sin),
            1 => (-sin, cos),
            2 => (-cos, -sin),
            _ => (sin, -cos),
        }
    }

    /// Sums the two Taylor series of an angle `|x| ≤ π/4`, in radians, until their terms are below the last bit.
    fn taylor(&self, x: &BigInt) -> (BigInt, BigInt) {
        let mut sums = [BigInt::zero(), BigInt::zero()];
        let mut term = BigInt::one() << self.bits;
        let mut n = 0_u32;
        while !term.is_zero() {
            // 1, x, −x²/2, −x³/6, …: even powers make the cosine, odd ones the sine.
            let sum = &mut sums[(n % 2) as usize];
            if n % 4 < 2 {
                *sum += &term
            } else {
                *sum -= &term
            }
            n += 1;
            term = ((&term * x) >> self.bits) / n;
            if term == -BigInt::one() {
                term = BigInt::zero();
            }
        }
        let [cos, sin] = sums;
        (cos, sin)
    }
}

thread_local! {
    static TAUS: RefCell<BTreeMap<u32, BigInt>> = const { RefCell::new(BTreeMap::new()) };
}

/// 2π by Machin's formula, π/4 = 4 arctan(1/5) − arctan(1/239).
fn tau(bits: u32) -> BigInt {
    let guard = 16;
    let arctan_of_inverse = |q: u32| {
        let mut power = (BigInt::one() << (bits + guard)) / q;
        let (mut sum, mut n) = (BigInt::zero(), 1_u32);
        while !power.is_zero() {
            let term = &power / n;
            if n % 4 == 1 {
                sum += term
            } else {
                sum -= term
            }
            power /= q * q;
            n += 2;
        }
        sum
    };
    (arctan_of_inverse(5) * 32_u32 - arctan_of_inverse(239) * 8_u32) >> guard
}
