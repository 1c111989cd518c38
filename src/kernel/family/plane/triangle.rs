//! When do three parts cancel that φ and δ turn on their own? Where they make a triangle: never, once, or in two mirror images.

use std::cmp::Ordering;

use num_complex::Complex;
use num_integer::Integer;
use num_rational::BigRational;
use num_traits::{Signed, ToPrimitive};

use super::super::angles::alternative;
use super::super::part::Part;
use crate::exact::{PhasorSum, Turn, fraction};
use crate::numbers;
use crate::proof::{AlternativeClaim, TriangleShape};

/// Three parts that cancel somewhere, or nowhere.
#[derive(Clone, Debug)]
pub struct Triangle {
    /// How many triangles have these sides, with evidence.
    pub shape: TriangleShape,
    /// How many times φ and δ turn second and third part against the first.
    pub multiples: [[BigRational; 2]; 2],
    /// What they come to in each triangle.
    pub corners: Vec<Corner>,
}

/// On which sides the solutions are.
pub(super) fn signs(shape: &TriangleShape) -> &'static [f64] {
    match shape {
        TriangleShape::Never { .. } => &[],
        TriangleShape::Flat { .. } => &[1.0],
        TriangleShape::Two { .. } => &[1.0, -1.0],
    }
}

/// What turns second and third part against the first.
#[derive(Clone, Debug)]
pub enum Corner {
    /// Rational turns.
    Exact(AlternativeClaim),
    /// In degrees from 0 to 360; no rational turns were found.
    Near([f64; 2]),
}

/// The bits of enclosures that are tried; what the checker gets has some to spare.
const BITS: [u32; 4] = [64, 128, 256, 448];
const SPARE_BITS: u32 = 32;

/// Where they cancel; `None` where the sign of the squared area is not found.
pub(in super::super) fn solve(parts: [&Part; 3]) -> Option<Triangle> {
    let [first, second, third] = parts;
    let multiples = [second, third].map(|part| [&part.phi - &first.phi, &part.delta - &first.delta]);
    if &multiples[0][0] * &multiples[1][1] == &multiples[0][1] * &multiples[1][0] {
        return None;
    }
    let shape = shape(parts.map(|part| &part.sum))?;
    let corners = signs(&shape).iter().map(|sign| corner(parts, *sign)).collect();
    Some(Triangle { shape, multiples, corners })
}

/// The sign of `2(ab + bc + ca) − a² − b² − c²`, 16 times the squared area (Heron).
fn shape(sums: [&PhasorSum; 3]) -> Option<TriangleShape> {
    let [a, b, c] = sums.map(PhasorSum::squared_modulus);
    let mixed = a.times(&b).plus(&b.times(&c)).plus(&c.times(&a)).scaled(&BigRational::from_integer(2.into()));
    let area = mixed.minus(&a.times(&a).plus(&b.times(&b)).plus(&c.times(&c)));
    sign(area)
}

/// The sign of a real sum.
pub(super) fn sign(area: PhasorSum) -> Option<TriangleShape> {
    let area = area.tidied();
    if area.vanishes() {
        return Some(TriangleShape::Flat { certificate: area.certificate() });
    }
    enclosed_sign(&area)
}

/// The sign of a real sum that has terms, where an enclosure tells it.
pub(super) fn enclosed_sign(area: &PhasorSum) -> Option<TriangleShape> {
    let total: BigRational = area.terms().iter().map(|term| term.weight.abs()).sum();
    let area = area.scaled(&total.recip());
    BITS.iter().find_map(|&bits| {
        let [area, _] = numbers::enclose(&area, bits);
        let bits = bits + SPARE_BITS;
        Some(match area.sign()? {
            Ordering::Greater => TriangleShape::Two { bits },
            Ordering::Less | Ordering::Equal => TriangleShape::Never { bits },
        })
    })
}

/// The triangle on one side of the first part, in decimals, and at rational turns where these cancel exactly.
fn corner([first, second, third]: [&Part; 3], sign: f64) -> Corner {
    let [one, two, three] = [first, second, third].map(|part| numbers::evaluate(&part.sum));
    let cosine = (three.norm_sqr() - one.norm_sqr() - two.norm_sqr()) / (2.0 * one.norm() * two.norm());
    let degrees = sign * libm::acos(cosine.clamp(-1.0, 1.0)).to_degrees();
    let to_second = numbers::degrees(one) + degrees - numbers::degrees(two);
    let (sin, cos) = libm::sincos(degrees.to_radians());
    let turned = one / one.norm() * two.norm() * Complex::new(cos, sin);
    let to_third = numbers::degrees(-one - turned) - numbers::degrees(three);
    let near = [to_second, to_third].map(|degrees| degrees.rem_euclid(360.0));
    let turn = |degrees: f64| near_turn([first, second, third].map(|part| &part.sum), 1, degrees);
    let rational = near.map(turn);
    let rational = rational[0].clone().zip(rational[1].clone());
    let rational = rational.map(|(to_second, to_third)| alternative(first, &[(second, to_second), (third, to_third)]));
    match rational.filter(|alternative| alternative.certificate.claims_zero()) {
        Some(exact) => Corner::Exact(exact),
        None => Corner::Near(near),
    }
}

/// The rational turn next to these degrees at which three sums may cancel, the second or third of them turned by it this many times: a
/// multiple of one over their conductor with the primes up to three (theory, section 16).
pub(super) fn near_turn(sums: [&PhasorSum; 3], times: u32, degrees: f64) -> Option<Turn> {
    let conductor =
        fraction::common_denominator(sums.iter().flat_map(|sum| sum.terms()).map(|term| term.angle.turns()));
    let modulus = (conductor.lcm(&6.into()) * times).to_i64().filter(|modulus| *modulus < 1_000_000_000)?;
    Some(Turn::fraction((degrees / 360.0 * modulus as f64).round() as i64, modulus))
}
