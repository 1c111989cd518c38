//! What is an angle? A rational fraction of a turn, taken modulo 1.

use std::cmp::Ordering;
use std::fmt;
use std::ops::{Add, Neg, Sub};

use num_bigint::BigInt;
use num_integer::Integer;
use num_rational::BigRational;
use num_traits::{Signed, Zero};

use super::fraction;

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
    /// # use crankstar_kernel as crankstar;
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
        // Whole turns taken off, it is as reduced as before.
        let (numerator, denominator) = turns.into_raw();
        Turn(BigRational::new_raw(numerator.mod_floor(&denominator), denominator))
    }

    /// `numerator / denominator` of a turn.
    ///
    /// # Panics
    /// If the denominator is 0.
    pub fn fraction(numerator: i64, denominator: i64) -> Self {
        match denominator > 0 && numerator > i64::MIN {
            true => Turn::new(fraction::ratio(numerator, denominator)),
            false => Turn::new(BigRational::new(numerator.into(), denominator.into())),
        }
    }

    /// Takes an angle in degrees modulo 360.
    pub fn from_degrees(degrees: &BigRational) -> Self {
        Turn::new(fraction::over(degrees, &BigRational::from_integer(360.into())))
    }

    /// The angle in turns, in `[0, 1)`.
    pub fn turns(&self) -> &BigRational {
        &self.0
    }

    /// The angle in degrees, in `[0, 360)`.
    pub fn degrees(&self) -> BigRational {
        fraction::times(&self.0, &BigRational::from_integer(360.into()))
    }

    /// The angle taken `factor` times.
    pub fn times(&self, factor: i64) -> Self {
        match fraction::words(&self.0) {
            Some((numerator, denominator)) => {
                // The numerator has nothing in common with the denominator.
                let (factor, common) = (factor.rem_euclid(denominator), factor.gcd(&denominator));
                let product = match numerator.checked_mul(factor) {
                    Some(product) => i128::from(product % denominator),
                    None => i128::from(numerator) * i128::from(factor) % i128::from(denominator),
                };
                Turn(fraction::reduced((product / i128::from(common), i128::from(denominator / common))))
            }
            None => Turn::new(&self.0 * BigRational::from_integer(factor.into())),
        }
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
        match fraction::sum_in_machine_words(&self.0, &other.0, 1) {
            // Two turns in range make less than two whole ones.
            Some((sum, whole)) => Turn(fraction::reduced((if sum < whole { sum } else { sum - whole }, whole))),
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

impl Neg for Turn {
    type Output = Turn;
    fn neg(self) -> Turn {
        -&self
    }
}

impl Neg for &Turn {
    type Output = Turn;
    fn neg(self) -> Turn {
        if self.0.is_zero() {
            self.clone()
        } else {
            Turn(BigRational::new_raw(self.0.denom() - self.0.numer(), self.0.denom().clone()))
        }
    }
}

impl Ord for Turn {
    fn cmp(&self, other: &Turn) -> Ordering {
        fraction::compare(&self.0, &other.0)
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
