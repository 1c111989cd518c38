//! Why does it vanish, or not? The reason that a person would give first.

mod left;
mod plainest;
mod symmetry;

use num_traits::{Signed, Zero};

use super::JudgedStar;
use crate::engine::Engine;
use crate::exact::{PhasorSum, Term, Turn};
use crate::proof::{Certificate, Polygon, Quantity};
pub use plainest::{Component, Reason, Size};
pub use symmetry::{mirror_axis, mirror_partners, opposed_partners};

/// The plainest reason for a verdict on a star of this engine.
pub fn reason<'a>(engine: &Engine, star: impl Into<JudgedStar<'a>>) -> Reason {
    let star = star.into();
    let sum = star.sum;
    match star.certificate {
        Certificate::Polygons { .. } if sum.terms().iter().all(|term| term.weight.is_zero()) => Reason::NoWeight,
        Certificate::Polygons { .. } if is_moment_of_pistons(star) && mirror_partners(engine).is_some() => {
            Reason::Mirror
        }
        Certificate::Polygons { polygons } if polygons.is_empty() => Reason::Cancels,
        Certificate::Polygons { polygons } => of_polygons(sum, polygons),
        Certificate::Residue(_) | Certificate::Splitting { .. } => left::reason(sum),
    }
}

/// Whether a mirror plane of the cylinders is one of all that the sum is about.
fn is_moment_of_pistons(star: JudgedStar<'_>) -> bool {
    star.quantity == Quantity::MOMENT && star.sources.iter().all(|source| source.piston().is_some())
}

/// Pairs are named where the certificate is pairs; else a symmetry comes before the polygons.
fn of_polygons(sum: &PhasorSum, polygons: &[Polygon]) -> Reason {
    match polygons.iter().all(|polygon| polygon.sides == 2) {
        true if opposed_partners(sum).is_some() => Reason::OpposedPairs,
        true => Reason::Polygons,
        false => match symmetry::fold(&sum.positive().collected()) {
            Some(fold) => Reason::Rotation { fold },
            None => Reason::Polygons,
        },
    }
}

/// Polygons that make up the star as it is drawn, the vectors of negative weight turned by half a turn; none where it is not
/// zero.
///
/// They are those of the certificate, and pairs that cancel beside them: a polygon of negative weight with an odd number of
/// sides is the one of positive weight turned by half a turn.
pub fn drawn_polygons<'a>(star: impl Into<JudgedStar<'a>>) -> Vec<Polygon> {
    let star = star.into();
    let Certificate::Polygons { polygons } = star.certificate else { return Vec::new() };
    let drawn = star.sum.positive();
    let mut shown: Vec<Polygon> = Vec::new();
    // Pairs are counted anew, from what is left.
    for polygon in polygons.iter().filter(|polygon| polygon.sides != 2) {
        let one = if polygon.weight.is_negative() { turned(polygon) } else { polygon.clone() };
        // One that is turned may have the corners of another: they are one polygon.
        match shown.iter_mut().find(|other| (other.sides, &other.rotation) == (one.sides, &one.rotation)) {
            Some(other) => other.weight += one.weight,
            None => shown.push(one),
        }
    }
    let left = shown.iter().fold(drawn.clone(), |left, polygon| left.minus(&corners(polygon)));
    // What is left is equal in opposite directions.
    let pairs = left.collected().into_iter().filter(|term| term.angle < Turn::fraction(1, 2));
    let pair = |term: Term| Polygon { sides: 2, rotation: term.angle.turns().clone(), weight: term.weight };
    let (positive, negative): (Vec<Polygon>, Vec<Polygon>) =
        pairs.map(pair).partition(|pair| pair.weight.is_positive());
    let is_plain = negative.is_empty();
    shown.extend(positive.into_iter().chain(negative));
    match drawn.certificate() {
        Certificate::Polygons { polygons } if !is_plain && polygons.iter().all(|one| one.weight.is_positive()) => {
            polygons
        }
        _ => shown,
    }
}

/// A polygon of an odd number of sides with the sign of its weight changed.
fn turned(polygon: &Polygon) -> Polygon {
    // The least of its corners, as in every list of polygons.
    let sides = num_rational::BigRational::from_integer(polygon.sides.into());
    let rotation = Turn::new((&polygon.rotation + Turn::fraction(1, 2).turns()) * &sides).turns() / &sides;
    Polygon { sides: polygon.sides, rotation, weight: -&polygon.weight }
}

/// The corners of a polygon as a sum.
pub fn corners(polygon: &Polygon) -> PhasorSum {
    let corner = |j: u64| {
        let step = num_rational::BigRational::new(j.into(), polygon.sides.into());
        Term { angle: Turn::new(&polygon.rotation + step), weight: polygon.weight.clone() }
    };
    PhasorSum::new((0..polygon.sides).map(corner).collect())
}
