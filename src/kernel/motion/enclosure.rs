//! Between which numbers does a coefficient lie? Two rationals, rounded outward.

use std::cmp::Ordering;

use num_bigint::BigInt;
use num_complex::Complex;
use num_integer::Integer;
use num_rational::BigRational;
use num_traits::{Signed, ToPrimitive, Zero};

use super::ball::Ball;

/// Bits of a computed value that are sure: the radius is at most `2^−67` of it.
const SURE_BITS: u32 = 67;
/// Bits that the rounded ends of an enclosure keep.
const KEPT_BITS: i64 = 96;
/// Bits behind the point that every computation starts with.
const FIRST_BITS: u32 = 192;
/// A value that might be exactly zero is computed to this many bits behind the point, if it does not show itself before.
pub(super) const FLOOR_BITS: u32 = 256;

/// An exact number as a float; not a number where no float is near it.
pub fn float(value: &BigRational) -> f64 {
    value.to_f64().unwrap_or(f64::NAN)
}

/// The square root of a number, where it is rational.
pub fn rational_root(square: &BigRational) -> Option<BigRational> {
    let whole = |number: &BigInt| Some(number.sqrt()).filter(|root| root * root == *number);
    if square.is_negative() {
        return None;
    }
    Some(BigRational::new_raw(whole(square.numer())?, whole(square.denom())?))
}

/// A real number that is guaranteed to lie in `low ..= high`. An exactly known number is a point.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Enclosure {
    /// The number is at least this.
    pub low: BigRational,
    /// The number is at most this.
    pub high: BigRational,
}

impl Enclosure {
    /// An exactly known number.
    pub fn point(number: BigRational) -> Self {
        Enclosure { low: number.clone(), high: number }
    }

    /// The whole number zero, exactly.
    pub fn zero() -> Self {
        Enclosure::point(BigRational::zero())
    }

    /// May the number be zero? It is exactly zero if the enclosure is a point besides.
    pub fn contains_zero(&self) -> bool {
        !self.low.is_positive() && !self.high.is_negative()
    }

    /// Does a number lie inside?
    pub fn contains(&self, number: &BigRational) -> bool {
        self.low <= *number && *number <= self.high
    }

    /// The distance of the ends; 0 for a point.
    pub fn width(&self) -> BigRational {
        &self.high - &self.low
    }

    /// No number of it is larger in size.
    pub fn largest(&self) -> BigRational {
        self.low.abs().max(self.high.abs())
    }

    /// No number of it is smaller in size.
    pub fn smallest(&self) -> BigRational {
        if self.contains_zero() { BigRational::zero() } else { self.low.abs().min(self.high.abs()) }
    }

    /// How all its numbers compare with zero; none where they differ.
    pub fn sign(&self) -> Option<Ordering> {
        match (self.low.is_positive(), self.high.is_negative()) {
            (true, _) => Some(Ordering::Greater),
            (_, true) => Some(Ordering::Less),
            (false, false) => None,
        }
    }

    /// The float nearest the middle: for a coefficient within one unit in the last place of the number.
    pub fn to_float(&self) -> f64 {
        let (low, high) = (&self.low, &self.high);
        let twice = low.numer() * high.denom() + high.numer() * low.denom();
        // A float needs no lowest terms.
        float(&BigRational::new_raw(twice, (low.denom() * high.denom()) << 1))
    }

    /// The sum of two numbers.
    pub fn plus(&self, other: &Enclosure) -> Enclosure {
        Enclosure { low: &self.low + &other.low, high: &self.high + &other.high }
    }

    /// The product of two numbers: its ends are among the products of their ends.
    pub fn product(&self, other: &Enclosure) -> Enclosure {
        let [one, two] = [self.times(&other.low), self.times(&other.high)];
        Enclosure { low: one.low.min(two.low), high: one.high.max(two.high) }
    }

    /// The number times a rational one.
    pub fn times(&self, factor: &BigRational) -> Enclosure {
        let (one_end, other_end) = (&self.low * factor, &self.high * factor);
        if factor.is_negative() {
            Enclosure { low: other_end, high: one_end }
        } else {
            Enclosure { low: one_end, high: other_end }
        }
    }

    /// Computes a ball with more and more bits until 64 bits of it are sure, and multiplies it by a factor.
    ///
    /// Without a `floor` the value must not be zero, or this does not end; with it, an error below `2^−floor` is enough.
    pub(super) fn refine(factor: &BigRational, floor: Option<u32>, attempt: impl Fn(u32) -> Option<Ball>) -> Enclosure {
        let mut bits = FIRST_BITS;
        loop {
            if let Some(ball) = attempt(bits) {
                let is_sure = (&ball.radius << SURE_BITS) <= ball.middle.abs();
                let is_small =
                    floor.is_some_and(|floor| (factor.numer().abs() * &ball.radius) << floor <= factor.denom() << bits);
                if is_sure || is_small {
                    return Enclosure::rounded(&ball, factor);
                }
            }
            bits *= 2;
        }
    }

    /// A ball times a factor, its ends rounded outward to a few bits more than are sure.
    fn rounded(ball: &Ball, factor: &BigRational) -> Enclosure {
        let ends = [ball.low() * factor.numer(), ball.high() * factor.numer()];
        let denominator = factor.denom() << ball.bits;
        let size = ends.iter().map(BigInt::bits).max().unwrap_or(0) as i64 - denominator.bits() as i64;
        let shift = KEPT_BITS - size;
        let scale = |number: &BigInt| if shift > 0 { number << shift } else { number.clone() };
        let divisor = if shift < 0 { denominator << -shift } else { denominator };
        let unscale = |number: BigInt| {
            if shift > 0 {
                BigRational::new(number, BigInt::from(1) << shift)
            } else {
                BigRational::from_integer(number << -shift)
            }
        };
        let [one_end, other_end] = ends.map(|end| scale(&end));
        let (low, high) = if one_end <= other_end { (one_end, other_end) } else { (other_end, one_end) };
        Enclosure { low: unscale(low.div_floor(&divisor)), high: unscale(high.div_ceil(&divisor)) }
    }
}

/// A complex amplitude: the order it belongs to contributes `Re(c e^{ikψ}) = re·cos kψ − im·sin kψ`.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Coefficient {
    /// The amplitude of the cosine.
    pub re: Enclosure,
    /// Minus the amplitude of the sine.
    pub im: Enclosure,
}

impl Coefficient {
    /// Exactly zero.
    pub fn zero() -> Self {
        Coefficient { re: Enclosure::zero(), im: Enclosure::zero() }
    }

    /// The sum of two amplitudes.
    pub fn plus(&self, other: &Coefficient) -> Coefficient {
        Coefficient { re: self.re.plus(&other.re), im: self.im.plus(&other.im) }
    }

    /// In decimals, each part by [`Enclosure::to_float`].
    pub fn to_complex(&self) -> Complex<f64> {
        Complex::new(self.re.to_float(), self.im.to_float())
    }

    /// A real number times `(−i)^turns`.
    pub(super) fn turned(real: &Enclosure, turns: u32) -> Coefficient {
        let negated = || real.times(&BigRational::from_integer((-1).into()));
        let (re, im) = match turns % 4 {
            0 => (real.clone(), Enclosure::zero()),
            1 => (Enclosure::zero(), negated()),
            2 => (negated(), Enclosure::zero()),
            _ => (Enclosure::zero(), real.clone()),
        };
        Coefficient { re, im }
    }
}
