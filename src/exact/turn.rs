//! What is an angle? A rational fraction of a turn, taken modulo 1.

use std::cmp::Ordering;
use std::fmt;
use std::ops::{Add, Neg, Sub};

use num_bigint::BigInt;
use num_integer::Integer;
use num_rational::BigRational;
use num_traits::{One, Signed, ToPrimitive, Zero};

/// An angle as a fraction of a turn, always in `[0, 1)`: 45° is `1/8`.
///
/// Turns form the group Q/Z: they add, and an integer multiplies them, but two turns have no product.
#[derive(Clone, PartialEq, Eq, Hash)]
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
        // By far the most angles are in range already.
        if !turns.is_negative() && turns.numer() < turns.denom() {
            return Turn(turns);
        }
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
        match self.in_words() {
            Some((numerator, denominator)) => {
                let product = numerator * u128::from(factor.unsigned_abs()) % denominator;
                Turn::from_words(if factor < 0 { (denominator - product) % denominator } else { product }, denominator)
            }
            None => Turn::new(&self.0 * BigRational::from_integer(factor.into())),
        }
    }

    /// The opposite direction.
    pub fn opposite(&self) -> Self {
        self + &Turn::fraction(1, 2)
    }

    /// Numerator and denominator in words, where twice the product of two such fits into a long word.
    fn in_words(&self) -> Option<(u128, u128)> {
        let word = |number: &BigInt| number.to_u64().filter(|&word| word < 1 << 62).map(u128::from);
        Some((word(self.0.numer())?, word(self.0.denom())?))
    }

    /// A fraction below 1 that is not reduced.
    fn from_words(numerator: u128, denominator: u128) -> Turn {
        let common = numerator.gcd(&denominator);
        Turn(BigRational::new_raw((numerator / common).into(), (denominator / common).into()))
    }

    /// The smallest `n` with `n` times the angle a whole number of turns.
    pub fn denominator(&self) -> &BigInt {
        self.0.denom()
    }
}

impl Add for &Turn {
    type Output = Turn;
    fn add(self, other: &Turn) -> Turn {
        match self.in_words().zip(other.in_words()) {
            Some(((a, b), (c, d))) => Turn::from_words((a * d + c * b) % (b * d), b * d),
            None => Turn::new(&self.0 + &other.0),
        }
    }
}

impl Sub for &Turn {
    type Output = Turn;
    fn sub(self, other: &Turn) -> Turn {
        self + &-other
    }
}

impl Neg for &Turn {
    type Output = Turn;
    fn neg(self) -> Turn {
        if self.0.is_zero() { self.clone() } else { Turn(BigRational::one() - &self.0) }
    }
}

impl Ord for Turn {
    fn cmp(&self, other: &Turn) -> Ordering {
        match self.in_words().zip(other.in_words()) {
            Some(((a, b), (c, d))) => (a * d).cmp(&(c * b)),
            None => self.0.cmp(&other.0),
        }
    }
}

impl PartialOrd for Turn {
    fn partial_cmp(&self, other: &Turn) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}

impl fmt::Debug for Turn {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{} turn", self.0)
    }
}
