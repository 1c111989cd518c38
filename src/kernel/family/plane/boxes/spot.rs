//! What is a complex number, enclosed in machine words? Units of `2^−48`, and by how much either part may be off.

use num_bigint::BigInt;
use num_rational::BigRational;
use num_traits::{One, ToPrimitive};

use crate::exact::PhasorSum;
use crate::numbers;

/// Digits behind the point.
pub(super) const BITS: u32 = 48;
pub(super) const ONE: i128 = 1 << BITS;

/// Either part is off by `doubt` at most.
#[derive(Clone, Copy, Debug)]
pub(super) struct Spot {
    pub re: i128,
    pub im: i128,
    pub doubt: i128,
}

impl Spot {
    pub const ZERO: Spot = Spot { re: 0, im: 0, doubt: 0 };
    pub const UNIT: Spot = Spot { re: ONE, im: 0, doubt: 0 };

    /// A sum no longer than 1.
    pub fn of(sum: &PhasorSum) -> Self {
        let units = BigRational::from_integer(BigInt::one() << BITS);
        let ends = numbers::enclose(sum, BITS + 16);
        let ends = ends.map(|part| [(part.low * &units).floor(), (part.high * &units).ceil()]);
        let whole = |end: &BigRational| end.to_integer().to_i128().unwrap_or(ONE);
        let [[re, re_end], [im, im_end]] = ends.each_ref().map(|ends| ends.each_ref().map(whole));
        Spot { re, im, doubt: (re_end - re).max(im_end - im) }
    }

    pub fn plus(self, other: Spot) -> Spot {
        Spot { re: self.re + other.re, im: self.im + other.im, doubt: self.doubt + other.doubt }
    }

    pub fn times_whole(self, by: i64) -> Spot {
        let by = i128::from(by);
        Spot { re: self.re * by, im: self.im * by, doubt: self.doubt * by.abs() }
    }

    /// The product of two numbers that are no longer than some 2.
    pub fn times(self, other: Spot) -> Spot {
        let re = (self.re * other.re - self.im * other.im) >> BITS;
        let im = (self.re * other.im + self.im * other.re) >> BITS;
        let off = |a: Spot, b: Spot| (a.re.abs() + a.im.abs()) * b.doubt;
        let doubt = off(self, other) + off(other, self) + 2 * self.doubt * other.doubt;
        Spot { re, im, doubt: (doubt >> BITS) + 2 }
    }

    /// A quarter turn on.
    pub fn turned(self) -> Spot {
        Spot { re: -self.im, im: self.re, doubt: self.doubt }
    }

    /// In larger units.
    pub fn over(self, shift: u32) -> Spot {
        Spot { re: self.re >> shift, im: self.im >> shift, doubt: (self.doubt >> shift) + 2 }
    }

    /// No less than its length, its doubt among it.
    pub fn most(self) -> i128 {
        length(self.re, self.im) + 2 * self.doubt
    }

    /// Its parts with so few digits that products with them fit.
    pub fn direction(self) -> [i128; 2] {
        let size = self.re.abs().max(self.im.abs());
        let shift = (128 - size.leading_zeros()).saturating_sub(16);
        [self.re >> shift, self.im >> shift]
    }
}

/// No less than the length, of parts below `2^62`.
pub(super) fn length(x: i128, y: i128) -> i128 {
    (x * x + y * y).isqrt() + 1
}
