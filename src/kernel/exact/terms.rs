//! What does a decision work on? Vectors with whole exponents and whole weights, in machine words or in big integers.

use std::collections::BTreeMap;
use std::ops::{AddAssign, SubAssign};

use num_bigint::{BigInt, BigUint};
use num_integer::Integer;
use num_traits::{Signed, ToPrimitive};
use smallvec::SmallVec;

/// Whole numbers that can be an exponent: machine words where they fit, big integers where they do not.
pub trait Exponent: Clone + Integer + From<u32> + ToPrimitive + Into<BigUint> {}

impl Exponent for u64 {}

impl Exponent for BigUint {}

/// Whole numbers that can be a weight.
pub trait Weight: Clone + Integer + Signed + AddAssign + SubAssign + Into<BigInt> {
    /// The remainder modulo a prime, from 0 on.
    fn modulo(&self, prime: u64) -> u64;
}

impl Weight for i64 {
    fn modulo(&self, prime: u64) -> u64 {
        let remainder = self.unsigned_abs() % prime;
        if *self < 0 && remainder > 0 { prime - remainder } else { remainder }
    }
}

impl Weight for BigInt {
    fn modulo(&self, prime: u64) -> u64 {
        let remainder = self.mod_floor(&BigInt::from(prime)).to_u64();
        remainder.unwrap_or_else(|| unreachable!("a remainder is below its modulus"))
    }
}

/// Terms `(exponent, weight)`; engines of up to 16 cylinders stay on the stack.
pub(super) type Terms<E, W> = SmallVec<[(E, W); 16]>;

/// The terms by the remainder of their exponent.
pub(super) fn classes<E: Exponent, W: Weight>(terms: &[(E, W)], modulus: &E) -> BTreeMap<E, Terms<E, W>> {
    let mut classes: BTreeMap<E, Terms<E, W>> = BTreeMap::new();
    for (exponent, weight) in terms {
        classes.entry(exponent.clone() % modulus.clone()).or_default().push((exponent.clone(), weight.clone()));
    }
    classes
}
