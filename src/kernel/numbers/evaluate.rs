//! Where does a sum point, and how long is it?

use std::cell::RefCell;
use std::cmp::Ordering;

use num_bigint::BigInt;
use num_complex::Complex;
use num_integer::Integer;
use num_rational::BigRational;
use num_traits::{One, Signed, ToPrimitive, Zero};

use super::memory::{self, Memory};
use crate::exact::{PhasorSum, Term, Turn, fraction};
use crate::motion::{DOUBT, Enclosure, FixedPoint, float};

/// Bits behind the point that every evaluation starts with.
const FIRST_BITS: u32 = 128;

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
    static DIRECTIONS: RefCell<Memory<Complex<f64>, Turn>> = const { RefCell::new(Memory::new()) };
}

fn evaluated(sum: &PhasorSum) -> Complex<f64> {
    let mirrored = sum.conjugate();
    let re = if sum.plus(&mirrored).vanishes() { 0.0 } else { part(sum, |(cos, _)| cos) };
    let im = if sum.minus(&mirrored).vanishes() { 0.0 } else { part(sum, |(_, sin)| sin) };
    Complex::new(re, im)
}

/// The length of a vector, with the same last digit on every machine.
pub fn length(vector: Complex<f64>) -> f64 {
    libm::hypot(vector.re, vector.im)
}

/// The length of a sum that is not zero; not a number where it is beyond the range of floats.
pub fn length_of(sum: &PhasorSum) -> f64 {
    let length = length(evaluate(sum));
    if length.is_normal() { length } else { f64::NAN }
}

/// The direction of a vector in degrees, in (−180, 180], also where the decimals of one just past half a turn round to it; with the
/// same last digit on every machine.
pub fn degrees(vector: Complex<f64>) -> f64 {
    let degrees = libm::atan2(vector.im, vector.re).to_degrees();
    if degrees == -180.0 { 180.0 } else { degrees }
}

/// A unit vector in decimals.
pub fn direction(angle: &Turn) -> Complex<f64> {
    if let Some(known) = DIRECTIONS.with_borrow(|directions| directions.get(angle)) {
        return known;
    }
    let (cos, sin) = FixedPoint::new(FIRST_BITS).cos_sin(angle.turns());
    let to_float = |scaled: BigInt| BigRational::new_raw(scaled, BigInt::one() << FIRST_BITS).to_f64().unwrap_or(0.0);
    let direction = Complex::new(to_float(cos), to_float(sin));
    DIRECTIONS.with_borrow_mut(|directions| directions.keep(angle.clone(), direction));
    direction
}

/// The real or imaginary part, known not to be zero: bits are added until 64 of them are sure.
fn part(sum: &PhasorSum, choose: impl Fn((BigInt, BigInt)) -> BigInt) -> f64 {
    let terms = sum.collected();
    let (weights, scale) = whole_weights(&terms);
    let doubt = doubt(&weights);
    let mut bits = FIRST_BITS;
    loop {
        let fixed = FixedPoint::new(bits);
        let value: BigInt =
            weights.iter().zip(&terms).map(|(w, term)| w * choose(fixed.cos_sin(term.angle.turns()))).sum();
        if value.abs() > &doubt << 64 {
            return float(&BigRational::new_raw(value, &scale << bits));
        }
        bits *= 2;
    }
}

/// The sign of a real sum: zero is decided exactly, and what is not zero has a sign that enough bits show.
pub fn sign(real: &PhasorSum) -> Ordering {
    if real.vanishes() {
        return Ordering::Equal;
    }
    let mut bits = FIRST_BITS;
    loop {
        let [real, _] = enclose(real, bits);
        match real.sign() {
            Some(sign) => return sign,
            None => bits *= 2,
        }
    }
}

/// The real and the imaginary part of a sum between ends, from this many bits behind the point.
pub fn enclose(sum: &PhasorSum, bits: u32) -> [Enclosure; 2] {
    let (ends, scale) = fixed_ends(sum, bits);
    let unit = scale << bits;
    ends.map(|ends| {
        let [low, high] = ends.map(|end| BigRational::new(end, unit.clone()));
        Enclosure { low, high }
    })
}

/// The same ends, rounded outwards, as whole numbers in units of `2^−bits`.
pub fn enclose_in_units(sum: &PhasorSum, bits: u32) -> [[BigInt; 2]; 2] {
    let (ends, scale) = fixed_ends(sum, bits);
    ends.map(|[low, high]| [low.div_floor(&scale), high.div_ceil(&scale)])
}

/// The same ends as whole numbers, in units of `2^−bits` over the whole number that comes with them.
pub(super) fn fixed_ends(sum: &PhasorSum, bits: u32) -> ([[BigInt; 2]; 2], BigInt) {
    let terms = sum.collected();
    let (weights, scale) = whole_weights(&terms);
    let doubt = doubt(&weights);
    let fixed = FixedPoint::new(bits);
    let (mut re, mut im) = (BigInt::zero(), BigInt::zero());
    for (weight, term) in weights.iter().zip(&terms) {
        let (cos, sin) = fixed.cos_sin(term.angle.turns());
        re += weight * cos;
        im += weight * sin;
    }
    ([re, im].map(|value| [&value - &doubt, value + &doubt]), scale)
}

/// The weights over their least common denominator, and this.
fn whole_weights(terms: &[Term]) -> (Vec<BigInt>, BigInt) {
    let scale = fraction::common_denominator(terms.iter().map(|term| &term.weight));
    (terms.iter().map(|term| term.weight.numer() * (&scale / term.weight.denom())).collect(), scale)
}

/// What the roundings of the cosines add to at most, in the units of the whole weights.
fn doubt(weights: &[BigInt]) -> BigInt {
    weights.iter().map(BigInt::abs).sum::<BigInt>() * DOUBT
}
