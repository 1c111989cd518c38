//! Between which bounds does a number lie? Whole numbers over a power of two, and by how much they may be off.

use num_bigint::BigInt;
use num_integer::Integer;
use num_rational::BigRational;
use num_traits::{Signed, Zero};

/// What is known of a number, in units of `2^−bits`: it differs from `middle` by at most `doubt`.
#[derive(Clone, Debug)]
pub(super) struct Ball {
    pub middle: BigInt,
    pub doubt: BigInt,
}

impl Ball {
    /// Exactly this many units.
    pub fn exact(middle: BigInt) -> Self {
        Ball { middle, doubt: BigInt::zero() }
    }

    pub fn rational(number: &BigRational, bits: u32) -> Self {
        Ball { middle: (number.numer() << bits).div_floor(number.denom()), doubt: 1.into() }
    }

    pub fn plus(&self, other: &Ball) -> Ball {
        Ball { middle: &self.middle + &other.middle, doubt: &self.doubt + &other.doubt }
    }

    pub fn minus(&self, other: &Ball) -> Ball {
        self.plus(&other.negated())
    }

    pub fn negated(&self) -> Ball {
        Ball { middle: -&self.middle, doubt: self.doubt.clone() }
    }

    /// The product: what each is off counts as often as the other is large; two units cover both roundings.
    pub fn times(&self, other: &Ball, bits: u32) -> Ball {
        let doubt = self.middle.abs() * &other.doubt + (other.middle.abs() + &other.doubt) * &self.doubt;
        Ball { middle: (&self.middle * &other.middle) >> bits, doubt: (doubt >> bits) + 2 }
    }

    pub fn scaled(&self, by: &BigRational) -> Ball {
        let doubt = (&self.doubt * by.numer().abs()).div_floor(by.denom()) + 2;
        Ball { middle: (&self.middle * by.numer()).div_floor(by.denom()), doubt }
    }

    /// The square root of a number that is known to be positive.
    pub fn root(&self, bits: u32) -> Option<Ball> {
        let low = &self.middle - &self.doubt;
        if !low.is_positive() {
            return None;
        }
        let low = (low << bits).sqrt();
        let high = ((&self.middle + &self.doubt) << bits).sqrt() + 1;
        let middle: BigInt = (low + &high) >> 1;
        let doubt = high - &middle;
        Some(Ball { middle, doubt })
    }

    /// The quotient by a number that is known not to be zero.
    pub fn over(&self, other: &Ball, bits: u32) -> Option<Ball> {
        let least = other.middle.abs() - &other.doubt;
        if !least.is_positive() {
            return None;
        }
        let middle: BigInt = (&self.middle << bits) / &other.middle;
        let doubt: BigInt = (&self.doubt << bits) + (middle.abs() + 1) * &other.doubt;
        Some(Ball { middle, doubt: doubt / least + 2 })
    }

    /// The same number in units that are larger by a power of two.
    pub fn rounded(&self, shift: u32) -> Ball {
        Ball { middle: &self.middle >> shift, doubt: (&self.doubt >> shift) + 2 }
    }

    /// The least and the largest size it can have.
    pub fn sizes(&self) -> [BigInt; 2] {
        let size = self.middle.abs();
        [(&size - &self.doubt).max(BigInt::zero()), size + &self.doubt]
    }

    /// Whether it is known not to be zero.
    pub fn excludes_zero(&self) -> bool {
        self.middle.abs() > self.doubt
    }
}

/// A complex number, by its real and imaginary part.
#[derive(Clone, Debug)]
pub(super) struct Complex {
    pub re: Ball,
    pub im: Ball,
}

impl Complex {
    pub fn zero() -> Self {
        Complex::real(Ball::exact(BigInt::zero()))
    }

    pub fn real(re: Ball) -> Self {
        Complex { re, im: Ball::exact(BigInt::zero()) }
    }

    pub fn plus(&self, other: &Complex) -> Complex {
        Complex { re: self.re.plus(&other.re), im: self.im.plus(&other.im) }
    }

    pub fn times(&self, other: &Complex, bits: u32) -> Complex {
        let re = self.re.times(&other.re, bits).minus(&self.im.times(&other.im, bits));
        let im = self.re.times(&other.im, bits).plus(&self.im.times(&other.re, bits));
        Complex { re, im }
    }

    pub fn conjugate(&self) -> Complex {
        Complex { re: self.re.clone(), im: self.im.negated() }
    }

    /// `(−i)^quarters` times the number.
    pub fn turned_back(&self, quarters: u32) -> Complex {
        let Complex { re, im } = self;
        match quarters % 4 {
            0 => self.clone(),
            1 => Complex { re: im.clone(), im: re.negated() },
            2 => Complex { re: re.negated(), im: im.negated() },
            _ => Complex { re: im.negated(), im: re.clone() },
        }
    }

    pub fn scaled(&self, by: &BigRational) -> Complex {
        Complex { re: self.re.scaled(by), im: self.im.scaled(by) }
    }

    /// No less than the length.
    pub fn longest(&self) -> BigInt {
        let [[_, re], [_, im]] = [self.re.sizes(), self.im.sizes()];
        (&re * &re + &im * &im).sqrt() + 1
    }

    /// Whether a line keeps 0 away from all that is within `bend` of a plane: from here on, so far along each of these.
    pub fn keeps_away(&self, along: &[(&Complex, &BigRational)], bend: &BigInt) -> bool {
        let across = along.iter().map(|(vector, _)| vector.turned_back(1));
        across.chain([self.clone()]).any(|direction| self.is_beyond(&direction, along, bend))
    }

    /// The same of a line across this direction.
    fn is_beyond(&self, direction: &Complex, along: &[(&Complex, &BigRational)], bend: &BigInt) -> bool {
        let (x, y) = (&direction.re.middle, &direction.im.middle);
        let ahead = |vector: &Complex| {
            let doubt = x.abs() * &vector.re.doubt + y.abs() * &vector.im.doubt;
            (&vector.re.middle * x + &vector.im.middle * y, doubt)
        };
        let (at, doubt) = ahead(self);
        let sides = along.iter().map(|(vector, reach)| {
            let (along, doubt) = ahead(vector);
            BigRational::from_integer(along.abs() + doubt) * *reach
        });
        let sides: BigRational = sides.sum();
        let length: BigInt = (x * x + y * y).sqrt() + 1;
        BigRational::from_integer(at.abs() - doubt - length * bend) > sides
    }

    /// `|z|²`, in the same units.
    pub fn square(&self, bits: u32) -> Ball {
        self.re.times(&self.re, bits).plus(&self.im.times(&self.im, bits))
    }

    /// Whether it is known not to be zero.
    pub fn excludes_zero(&self) -> bool {
        self.re.excludes_zero() || self.im.excludes_zero()
    }
}
