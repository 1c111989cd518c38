//! Where does a sum point, and how long is it?

use std::cell::RefCell;
use std::sync::LazyLock;

use num_bigint::BigInt;
use num_complex::Complex;
use num_rational::BigRational;
use num_traits::{Signed, ToPrimitive, Zero};

use super::fixed::FixedPoint;
use super::memory::{self, Memory};
use crate::exact::{PhasorSum, Turn};

/// Bits behind the point that every evaluation starts with.
const FIRST_BITS: u32 = 128;

/// Its arithmetic, with 2π worked out once.
static FIRST: LazyLock<FixedPoint> = LazyLock::new(|| FixedPoint::new(FIRST_BITS));

/// Each cosine of the fixed-point arithmetic is off by less than this many units: some hundred roundings of its series.
const DOUBT: i64 = 1 << 16;

/// The sum as a complex decimal, to the full accuracy of a float, however much its terms cancel.
///
/// What is exactly zero comes out as zero: the sum, its real part, its imaginary part.
pub fn evaluate(sum: &PhasorSum) -> Complex<f64> {
    let star = memory::star(sum);
    if let Some(known) = VALUES.with_borrow(|values| values.get(&star)) {
        return known;
    }
    let value = evaluated(sum);
    VALUES.with_borrow_mut(|values| values.keep(star, value));
    value
}

thread_local! {
    static VALUES: RefCell<Memory<Complex<f64>>> = const { RefCell::new(Memory::new()) };
}

fn evaluated(sum: &PhasorSum) -> Complex<f64> {
    let mirrored = sum.conjugate();
    let re = if sum.plus(&mirrored).vanishes() { 0.0 } else { part(sum, |(cos, _)| cos) };
    let im = if sum.minus(&mirrored).vanishes() { 0.0 } else { part(sum, |(_, sin)| sin) };
    Complex::new(re, im)
}

/// An exact number as a float; not a number where no float is near it.
pub fn float(value: &BigRational) -> f64 {
    value.to_f64().unwrap_or(f64::NAN)
}

/// The length of a vector, with the same last digit on every machine.
pub fn length(vector: Complex<f64>) -> f64 {
    libm::hypot(vector.re, vector.im)
}

/// The direction of a vector in degrees, in (−180, 180], also where the decimals of one just past half a turn round to it; with the
/// same last digit on every machine.
pub fn degrees(vector: Complex<f64>) -> f64 {
    let degrees = libm::atan2(vector.im, vector.re).to_degrees();
    if degrees == -180.0 { 180.0 } else { degrees }
}

/// A unit vector in decimals.
pub fn direction(angle: &Turn) -> Complex<f64> {
    let (cos, sin) = FIRST.cos_sin(angle);
    let to_float = |scaled: BigInt| BigRational::new(scaled, BigInt::from(1) << FIRST_BITS).to_f64().unwrap_or(0.0);
    Complex::new(to_float(cos), to_float(sin))
}

/// The real or imaginary part, known not to be zero: bits are added until 64 of them are sure.
fn part(sum: &PhasorSum, choose: impl Fn((BigInt, BigInt)) -> BigInt) -> f64 {
    let terms = sum.collected();
    let mut bits = FIRST_BITS;
    loop {
        let more;
        let fixed = if bits == FIRST_BITS {
            &*FIRST
        } else {
            more = FixedPoint::new(bits);
            &more
        };
        let products = terms.iter().map(|term| {
            let cosine = BigRational::from_integer(choose(fixed.cos_sin(&term.angle)));
            &term.weight * cosine
        });
        let value = products.fold(BigRational::zero(), |sum, product| sum + product);
        let doubt = terms.iter().fold(BigRational::zero(), |sum, term| sum + term.weight.abs()) * integer(DOUBT);
        if value.abs() > doubt * BigRational::from_integer(BigInt::from(1) << 64) {
            return (value / BigRational::from_integer(BigInt::from(1) << bits)).to_f64().unwrap_or(f64::NAN);
        }
        bits *= 2;
    }
}

/// Ends that enclose the real and the imaginary part of a sum, from this many bits behind the point.
pub fn enclose(sum: &PhasorSum, bits: u32) -> [(BigRational, BigRational); 2] {
    let fixed = FixedPoint::new(bits);
    let unit = BigRational::from_integer(BigInt::from(1) << bits);
    let zero = BigRational::zero;
    let (mut re, mut im, mut doubt) = (zero(), zero(), zero());
    for term in sum.collected() {
        let (cos, sin) = fixed.cos_sin(&term.angle);
        re += &term.weight * BigRational::from_integer(cos);
        im += &term.weight * BigRational::from_integer(sin);
        doubt += term.weight.abs() * integer(DOUBT);
    }
    [re, im].map(|value| ((&value - &doubt) / &unit, (&value + &doubt) / &unit))
}

fn integer(number: i64) -> BigRational {
    BigRational::from_integer(number.into())
}
