//! Sixty digits by a route of its own: whole numbers scaled by 10^80, square roots, and cosines by halving the angle.

use crankstar::exact::{PhasorSum, Turn};
use crankstar::numbers::{Form, Root};
use num_bigint::BigInt;
use num_rational::BigRational;

const PLACES: u32 = 80;

pub fn one() -> BigInt {
    BigInt::from(10).pow(PLACES)
}

fn scaled(value: &BigRational) -> BigInt {
    value.numer() * one() / value.denom()
}

fn times(a: &BigInt, b: &BigInt) -> BigInt {
    a * b / one()
}

pub fn root(value: &BigInt) -> BigInt {
    (value * one()).sqrt()
}

/// 2π by Størmer's formula, π/4 = 6 arctan(1/8) + 2 arctan(1/57) + arctan(1/239).
fn tau() -> BigInt {
    let arctan = |q: i64| {
        let (mut power, mut sum, mut n) = (one() * 1000 / q, BigInt::from(0), 1_i64);
        while power != BigInt::from(0) {
            let term: BigInt = &power / n;
            sum += if n % 4 == 1 { term } else { -term };
            power /= q * q;
            n += 2;
        }
        sum / 1000
    };
    (arctan(8) * 6 + arctan(57) * 2 + arctan(239)) * 8
}

/// `(cos, sin)`: the angle is halved ten times, its cosine taken from a short series, and doubled back.
pub fn cos_sin(angle: &Turn) -> (BigInt, BigInt) {
    let x = tau() * angle.turns().numer() / angle.turns().denom() / 1024;
    let square = times(&x, &x);
    let series = |first: BigInt, start: i64| {
        let (mut term, mut sum, mut n) = (first.clone(), first, start);
        while term != BigInt::from(0) {
            term = -times(&term, &square) / (n * (n + 1));
            sum += &term;
            n += 2;
        }
        sum
    };
    let (mut cos, mut sin) = (series(one(), 1), series(x.clone(), 2));
    for _ in 0..10 {
        (cos, sin) = (times(&cos, &cos) - times(&sin, &sin), times(&cos, &sin) * 2);
    }
    (cos, sin)
}

/// Real and imaginary part of a sum.
pub fn sum(sum: &PhasorSum) -> (BigInt, BigInt) {
    sum.terms().iter().fold((BigInt::from(0), BigInt::from(0)), |(re, im), term| {
        let (cos, sin) = cos_sin(&term.angle);
        (re + cos * term.weight.numer() / term.weight.denom(), im + sin * term.weight.numer() / term.weight.denom())
    })
}

pub fn modulus(value: &PhasorSum) -> BigInt {
    let (re, im) = sum(value);
    (&re * &re + &im * &im).sqrt()
}

/// The value of a form.
pub fn form(value: &Form) -> BigInt {
    value.terms().iter().map(|(root, coefficient)| times(&of_root(root), &scaled(coefficient))).sum()
}

fn of_root(of: &Root) -> BigInt {
    match of {
        Root::One => one(),
        Root::Whole(n) => root(&(n * one())),
        Root::Nested(inside) => root(&form(inside)),
        Root::Cosine(angle) => cos_sin(angle).0,
        Root::Product(first, cosines) => {
            cosines.iter().fold(of_root(first), |product, angle| times(&product, &cos_sin(angle).0))
        }
    }
}

/// Whether two values agree to 50 digits of the larger one, or of 1.
pub fn agree(a: &BigInt, b: &BigInt) -> bool {
    let size = [a.magnitude(), b.magnitude(), one().magnitude()].into_iter().max().cloned().unwrap_or_default();
    (a - b).magnitude() * num_bigint::BigUint::from(10_u32).pow(50) <= size
}
