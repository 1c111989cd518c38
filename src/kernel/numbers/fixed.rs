//! What are cosine and sine of a turn, to any precision? Whole numbers scaled by a power of two.
//!
//! Nothing of the platform's mathematics library enters, so the digits are the same on every machine.

use std::cell::RefCell;
use std::collections::BTreeMap;

use num_bigint::BigInt;
use num_traits::{One, ToPrimitive, Zero};

use crate::exact::{Turn, fraction};

/// Fixed-point arithmetic: a number `x` is held as the whole number nearest `x · 2^bits`, up to a few units.
pub(super) struct FixedPoint {
    bits: u32,
    tau: BigInt,
}

impl FixedPoint {
    /// Arithmetic with this many bits behind the point.
    pub fn new(bits: u32) -> Self {
        // Machin's formula costs more than a cosine: it is asked for once per precision and thread.
        let tau = TAUS.with_borrow_mut(|taus| taus.entry(bits).or_insert_with(|| tau(bits)).clone());
        FixedPoint { bits, tau }
    }

    /// `(cos, sin)` of an angle.
    pub fn cos_sin(&self, angle: &Turn) -> (BigInt, BigInt) {
        // Eighths of a turn: within the last half of a quarter, measure back from the next axis.
        let turns = angle.turns();
        let eighth = (turns.numer() * 8_u32 / turns.denom()).to_u32().unwrap_or(0);
        let axis = eighth.div_ceil(2);
        let from_axis = fraction::minus(turns, &fraction::ratio(axis.into(), 4));
        let x = &self.tau * from_axis.numer() / from_axis.denom();
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
