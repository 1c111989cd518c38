//! Does a curve keep away from 0 on an arc? Whole numbers over a power of two decide, every rounding counted.
//!
//! The curve is `T(s) = Σ C_j e^{2πi m_j s}`. On an arc about s₀ with half-width r it stays within `E = ½ (2πr)² Σ m_j² |C_j|` of the
//! segment `T(s₀) + 2πi t Σ m_j C_j e^{2πi m_j s₀}`, `|t| ≤ r`, and a line that keeps this segment away from 0 decides.

use std::cell::Cell;

use num_bigint::BigInt;
use num_integer::Integer;
use num_rational::BigRational;
use num_traits::{One, Signed, Zero};

use super::polynomial::Polynomial;
use crate::exact::{PhasorSum, Term, Turn};
use crate::numbers;

/// A checker that rounds otherwise may be in doubt by more: what is decided here holds by this many times the doubt.
const SLACK: u32 = 64;

/// A complex number in units of `2^−bits`, either part off by `doubt` at most.
#[derive(Clone, Debug)]
pub(super) struct Spot {
    re: BigInt,
    im: BigInt,
    doubt: BigInt,
}

impl Spot {
    fn zero() -> Self {
        Spot { re: BigInt::zero(), im: BigInt::zero(), doubt: BigInt::zero() }
    }

    fn of(sum: &PhasorSum, bits: u32) -> Self {
        let [[re, re_end], [im, im_end]] = numbers::enclose_in_units(sum, bits);
        let doubt = (re_end - &re).max(im_end - &im);
        Spot { re, im, doubt }
    }

    fn plus(&self, other: &Spot) -> Spot {
        Spot { re: &self.re + &other.re, im: &self.im + &other.im, doubt: &self.doubt + &other.doubt }
    }

    fn scaled(&self, by: &BigInt) -> Spot {
        Spot { re: &self.re * by, im: &self.im * by, doubt: &self.doubt * by.abs() }
    }

    fn times(&self, other: &Spot, bits: u32) -> Spot {
        let re = (&self.re * &other.re - &self.im * &other.im) >> bits;
        let im = (&self.re * &other.im + &self.im * &other.re) >> bits;
        let off = |a: &Spot, b: &Spot| (a.re.abs() + a.im.abs()) * &b.doubt;
        let doubt = off(self, other) + off(other, self) + &self.doubt * &other.doubt * 2;
        Spot { re, im, doubt: (doubt >> bits) + 2 }
    }

    /// A whole number of units that its size does not exceed, its doubt omitted.
    fn size(&self) -> BigInt {
        (&self.re * &self.re + &self.im * &self.im).sqrt() + 1
    }

    /// The sign of the real part of `conj(self)·other`; `None` where the doubt, or a larger one, leaves it open.
    pub fn sign_against(&self, other: &Spot) -> Option<bool> {
        let product = &self.re * &other.re + &self.im * &other.im;
        let off = |a: &Spot, b: &Spot| (a.re.abs() + a.im.abs()) * &b.doubt;
        let doubt = off(self, other) + off(other, self) + &self.doubt * &other.doubt * 2;
        (product.abs() > doubt * SLACK).then(|| product.is_positive())
    }
}

/// A sum of rotating vectors, each turning by half of a whole number.
pub(super) struct Curve<'a> {
    ground: &'a Evaluator,
    /// `2m_j`.
    doubled: Vec<i64>,
    /// `C_j`.
    vectors: Vec<Spot>,
    /// No fewer units than `Σ (2m_j)² |C_j|`.
    bend: BigInt,
}

/// The coefficients of a polynomial, enclosed, over the sum of all weights.
pub(super) struct Evaluator {
    pub bits: u32,
    sums: Vec<Spot>,
    exponents: Vec<i64>,
    /// This many values were enclosed.
    pub spent: Cell<usize>,
}

impl Evaluator {
    pub fn new(polynomial: &Polynomial, bits: u32) -> Self {
        let scale = polynomial.total().recip();
        let sums = polynomial.sums.iter().map(|sum| Spot::of(&sum.scaled(&scale), bits)).collect();
        Evaluator { bits, sums, exponents: polynomial.exponents.clone(), spent: Cell::new(0) }
    }

    fn curve(&self, doubled: impl Fn(i64) -> i64, factor: impl Fn(i64) -> BigInt) -> Curve<'_> {
        let each = self.exponents.iter().zip(&self.sums);
        let (doubled, vectors): (Vec<i64>, Vec<Spot>) =
            each.map(|(&exponent, sum)| (doubled(exponent), sum.scaled(&factor(exponent)))).unzip();
        let bend = doubled.iter().zip(&vectors).map(|(m, vector)| {
            let squared = BigInt::from(*m) * *m;
            (vector.size() + &vector.doubt * SLACK) * squared
        });
        let bend = bend.sum();
        Curve { ground: self, doubled, vectors, bend }
    }

    /// The i-th derivative of the polynomial along the circle, up to a factor.
    pub fn derivative(&self, i: u32) -> Curve<'_> {
        self.curve(|exponent| 2 * exponent, |exponent| BigInt::from(exponent).pow(i))
    }

    /// `e^{−idu/2}` times the polynomial, which stays on a line where it is its own mirror image.
    pub fn centred(&self) -> Curve<'_> {
        let degree = self.exponents.last().copied().unwrap_or(0);
        self.curve(|exponent| 2 * exponent - degree, |_| BigInt::one())
    }

    /// The derivative of that.
    pub fn slope(&self) -> Curve<'_> {
        let degree = self.exponents.last().copied().unwrap_or(0);
        self.curve(|exponent| 2 * exponent - degree, |exponent| BigInt::from(2 * exponent - degree))
    }
}

impl Curve<'_> {
    fn units(&self, at: &BigRational) -> impl Iterator<Item = (i64, Spot)> + '_ {
        self.ground.spent.set(self.ground.spent.get() + 1);
        let half = at / BigRational::from_integer(2.into());
        self.doubled.iter().zip(&self.vectors).map(move |(&m, vector)| {
            let angle = Turn::new(&half * BigRational::from_integer(m.into()));
            let unit = PhasorSum::new(vec![Term { angle, weight: BigRational::one() }]);
            (m, vector.times(&Spot::of(&unit, self.ground.bits), self.ground.bits))
        })
    }

    /// Its value at a turn.
    pub fn at(&self, at: &BigRational) -> Spot {
        self.units(at).fold(Spot::zero(), |sum, (_, spot)| sum.plus(&spot))
    }

    /// Whether it is shown not to pass 0 between two turns, the ends among them.
    pub fn is_free(&self, [low, high]: [&BigRational; 2]) -> bool {
        let two = BigRational::from_integer(2.into());
        let (middle, half) = ((low + high) / &two, (high - low) / &two);
        let (value, slope) = self.units(&middle).fold((Spot::zero(), Spot::zero()), |(value, slope), (m, spot)| {
            (value.plus(&spot), slope.plus(&spot.scaled(&m.into())))
        });
        // 2π m = π (2m) and ½π² < 5, with 355/113 just above π.
        let reach = &half * BigRational::new(355.into(), 113.into());
        let beyond = |factor: BigRational, units: &BigInt| (factor * BigRational::from_integer(units.clone())).ceil();
        let bend = beyond(&half * &half * BigRational::from_integer(5.into()), &self.bend);
        let off = bend + beyond(reach.clone(), &(&slope.doubt * SLACK));
        let off = off.to_integer() + &value.doubt * SLACK + 1;
        // The derivative points along i times the slope.
        let along = (-&slope.im, slope.re.clone());
        let parallel = (&value.re * &along.0 + &value.im * &along.1).abs();
        let apart = (&along.0 * &value.im - &along.1 * &value.re).abs();
        if apart > slope.size() * &off {
            return true;
        }
        let length = &value.re * &value.re + &value.im * &value.im;
        length * reach.denom() > reach.numer() * parallel + reach.denom() * value.size() * off
    }
}

/// A rational turn well inside an arc, with few binary digits.
pub(super) fn inside([low, high]: [&BigRational; 2]) -> BigRational {
    let quarter = (high - low) / BigRational::from_integer(4.into());
    let digits = (quarter.denom() / quarter.numer()).bits() + 1;
    let units = BigRational::from_integer(BigInt::one() << digits);
    let middle = (low + high) / BigRational::from_integer(2.into());
    let middle = (middle * &units + BigRational::new(1.into(), 2.into())).floor();
    middle / units
}

/// The multiples of `1/modulus` from the first turn to the second: the first and the last numerator, where there is one.
pub(super) fn multiples([low, high]: [&BigRational; 2], modulus: &BigInt) -> Option<[BigInt; 2]> {
    let first = (low.numer() * modulus).div_ceil(low.denom());
    let last = (high.numer() * modulus).div_floor(high.denom());
    (first <= last).then_some([first, last])
}
