//! Do three parts that two unknowns turn on their own cancel as often as is said?
//!
//! `S_1 + S_2 e^{iθ} + S_3 e^{iη} = 0` is a triangle whose sides are as long as the parts. Where its squared area is negative there
//! is none, where it is zero one, which is flat, else two: with S_1 laid down the corner opposite to it is on one side or the other.

use num_rational::BigRational;
use num_traits::{One, Signed};

use super::audit::{Audit, Reason, demand, refuse_if};
use super::check::certify;
use super::collected::{Collected, collect};
use super::decimals::{enclose, scale};
use super::enclosure::check_bits;
use super::part::{Part, check_alternative};
use super::plane::{TriangleClaim, TriangleShape};
use super::unknown::product;

/// Checks the count of triangles, and those at rational turns.
pub(super) fn check_triangle(claim: &TriangleClaim, left: &[Part<'_>], audit: &Audit) -> Result<(), Reason> {
    let [first, second, third] = left else {
        return Err(format!("{} parts do not vanish, and a triangle has three sides", left.len()).into());
    };
    let [[a, b], [c, d]] = [second, third].map(|part| part.turned_against(first));
    refuse_if(a * d == b * c, "the parts are not turned against each other by two angles on their own")?;
    let squared_area = squared_area([first, second, third].map(Part::sum), audit)?;
    let most = check_count(&squared_area, &claim.shape, audit)?;
    if claim.alternatives.len() > most {
        return Err(format!("{} triangles are named, and there are {most}", claim.alternatives.len()).into());
    }
    for alternative in &claim.alternatives {
        check_alternative(first, &[second, third], alternative, audit)?;
    }
    match claim.alternatives.as_slice() {
        [one, other] if one.conditions.iter().zip(&other.conditions).all(|(a, b)| (&a.turn - &b.turn).is_integer()) => {
            Err("the two triangles are the same".into())
        }
        _ => Ok(()),
    }
}

/// `2(ab + bc + ca) − a² − b² − c²`, 16 times the squared area (Heron).
fn squared_area(sums: [&Collected; 3], audit: &Audit) -> Result<Collected, Reason> {
    let mut squares = Vec::new();
    for sum in sums {
        squares.push(collect(product(sum, sum, audit)?, audit)?);
    }
    let mut terms = Vec::new();
    for (i, a) in squares.iter().enumerate() {
        for (j, b) in squares.iter().enumerate() {
            // A square is real, so that conj(a)·b is a·b; each mixed product comes twice.
            let sign = if i == j { -BigRational::one() } else { BigRational::one() };
            terms.extend(product(a, b, audit)?.into_iter().map(|(angle, weight)| (angle, weight * &sign)));
        }
    }
    Ok(collect(terms, audit)?)
}

/// Checks the sign of a number; returns how many triangles it leaves.
pub(super) fn check_count(number: &Collected, shape: &TriangleShape, audit: &Audit) -> Result<usize, Reason> {
    match shape {
        TriangleShape::Never { bits } => check_sign(number, false, *bits, audit).map(|()| 0),
        TriangleShape::Flat { certificate } => Ok(certify(number, true, certificate, audit).map(|()| 1)?),
        TriangleShape::Two { bits } => check_sign(number, true, *bits, audit).map(|()| 2),
    }
}

pub(super) fn check_sign(number: &Collected, is_positive: bool, bits: u32, audit: &Audit) -> Result<(), Reason> {
    check_bits(bits)?;
    let scale = scale([number], audit)?;
    let enclosed = enclose(number, &scale, &audit.circle(bits), audit)?.re;
    let has_sign = enclosed.excludes_zero() && enclosed.middle.is_positive() == is_positive;
    Ok(demand(has_sign, "the number does not have this sign, or this many bits leave it open")?)
}
