//! What is an angle? A rational fraction of a turn, taken modulo 1.

use std::fmt;
use std::ops::{Add, Neg, Sub};

use num_bigint::BigInt;
use num_rational::BigRational;
use num_traits::Zero;

/// An angle as a fraction of a turn, always in `[0, 1)`: 45° is `1/8`.
///
/// Turns form the group Q/Z: they add, and an integer multiplies them, but two turns have no product.
#[derive(Clone, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct Turn(BigRational);

impl Turn {
    /// The angle 0.
    pub fn zero() -> Self {
        Turn(BigRational::zero())
    }

    /// Takes a number of turns modulo 1.
    ///
    /// ```standalone_crate
    /// use crankstar::exact::Turn;
    /// use num_rational::BigRational;
    /// let nine_eighths = BigRational::new(9.into(), 8.into());
    /// assert_eq!(Turn::new(nine_eighths), Turn::fraction(1, 8));
    /// ```
    pub fn new(turns: BigRational) -> Self {
        let whole = turns.floor();
        Turn(turns - whole)
    }

    /// `numerator / denominator` of a turn.
    ///
    /// # Panics
    /// If the denominator is 0.
    pub fn fraction(numerator: i64, denominator: i64) -> Self {
        Turn::new(BigRational::new(numerator.into(), denominator.into()))
    }

    /// Takes an angle in degrees modulo 360.
    pub fn from_degrees(degrees: &BigRational) -> Self {
        Turn::new(degrees / BigRational::from_integer(360.into()))
    }

    /// The angle in turns, in `[0, 1)`.
    pub fn turns(&self) -> &BigRational {
        &self.0
    }

    /// The angle in degrees, in `[0, 360)`.
    pub fn degrees(&self) -> BigRational {
        &self.0 * BigRational::from_integer(360.into())
    }

    /// The angle taken `factor` times.
    pub fn times(&self, factor: i64) -> Self {
        Turn::new(&self.0 * BigRational::from_integer(factor.into()))
    }

    /// The opposite direction.
    pub fn opposite(&self) -> Self {
        self + &Turn::fraction(1, 2)
    }

    /// The smallest `n` with `n` times the angle a whole number of turns.
    pub fn denominator(&self) -> &BigInt {
        self.0.denom()
    }
}

impl Add for &Turn {
    type Output = Turn;
    fn add(self, other: &Turn) -> Turn {
        Turn::new(&self.0 + &other.0)
    }
}

impl Sub for &Turn {
    type Output = Turn;
    fn sub(self, other: &Turn) -> Turn {
        Turn::new(&self.0 - &other.0)
    }
}

impl Neg for &Turn {
    type Output = Turn;
    fn neg(self) -> Turn {
        Turn::new(-&self.0)
    }
}

impl fmt::Debug for Turn {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{} turn", self.0)
    }
}
