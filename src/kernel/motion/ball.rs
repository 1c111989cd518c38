//! How is a real number computed with so that the error is known? As a ball: a middle and a radius.

use std::ops::{Add, Neg, Sub};

use num_bigint::BigInt;
use num_integer::Integer;
use num_rational::BigRational;
use num_traits::{One, Signed, Zero};

/// All real numbers within `radius` of `middle`, both in units of `2^−bits`; sums and products round the radius up.
#[derive(Clone, Debug)]
pub(super) struct Ball {
    pub middle: BigInt,
    pub radius: BigInt,
    pub bits: u32,
}

impl Ball {
    pub fn integer(number: i64, bits: u32) -> Self {
        Ball { middle: BigInt::from(number) << bits, radius: BigInt::zero(), bits }
    }

    pub fn rational(number: &BigRational, bits: u32) -> Self {
        let (middle, rest) = (number.numer() << bits).div_mod_floor(number.denom());
        Ball { middle, radius: if rest.is_zero() { BigInt::zero() } else { BigInt::one() }, bits }
    }

    /// The ball around an interval, its ends in units of `2^−bits`.
    pub fn between(low: BigInt, high: BigInt, bits: u32) -> Self {
        let middle: BigInt = (&low + &high) >> 1;
        Ball { radius: high - &middle, middle, bits }
    }

    pub fn low(&self) -> BigInt {
        &self.middle - &self.radius
    }

    pub fn high(&self) -> BigInt {
        &self.middle + &self.radius
    }

    pub fn times(&self, other: &Ball) -> Ball {
        let doubt = self.middle.abs() * &other.radius + (other.middle.abs() + &other.radius) * &self.radius;
        // One unit for each of the two shifts, which round down.
        let radius = (doubt >> self.bits) + 2;
        Ball { middle: (&self.middle * &other.middle) >> self.bits, radius, bits: self.bits }
    }

    pub fn times_integer(&self, factor: i64) -> Ball {
        Ball { middle: &self.middle * factor, radius: &self.radius * factor.abs(), bits: self.bits }
    }

    /// Divided by a positive whole number.
    pub fn over_integer(&self, divisor: u64) -> Ball {
        Ball { middle: &self.middle / divisor, radius: &self.radius / divisor + 2, bits: self.bits }
    }

    /// Powers by squaring.
    pub fn power(&self, exponent: u32) -> Ball {
        let mut power = Ball::integer(1, self.bits);
        for place in (0..u32::BITS - exponent.leading_zeros()).rev() {
            power = power.times(&power);
            if exponent >> place & 1 == 1 {
                power = power.times(self);
            }
        }
        power
    }

    /// The square root of a number that is known not to be negative, even where the ball reaches below zero.
    pub fn sqrt(&self) -> Ball {
        let root = |number: BigInt| (number.max(BigInt::zero()) << self.bits).sqrt();
        Ball::between(root(self.low()), root(self.high()) + 1, self.bits)
    }

    /// The reciprocal of a positive number; none where the ball reaches zero.
    pub fn reciprocal(&self) -> Option<Ball> {
        if !self.low().is_positive() {
            return None;
        }
        let one = BigInt::one() << (2 * self.bits);
        Some(Ball::between(&one / self.high(), &one / self.low() + 1, self.bits))
    }

    /// The same ball with a larger radius, by a number of units.
    pub fn widened(mut self, units: BigInt) -> Ball {
        self.radius += units;
        self
    }
}

impl Add for &Ball {
    type Output = Ball;
    fn add(self, other: &Ball) -> Ball {
        Ball { middle: &self.middle + &other.middle, radius: &self.radius + &other.radius, bits: self.bits }
    }
}

impl Sub for &Ball {
    type Output = Ball;
    fn sub(self, other: &Ball) -> Ball {
        Ball { middle: &self.middle - &other.middle, radius: &self.radius + &other.radius, bits: self.bits }
    }
}

impl Neg for Ball {
    type Output = Ball;
    fn neg(self) -> Ball {
        Ball { middle: -self.middle, radius: self.radius, bits: self.bits }
    }
}
