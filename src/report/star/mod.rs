//! What does the vector star look like? Rays of vectors, and the polygons or the resultant drawn on them.

mod labels;
mod legend;
mod names;
mod panel;
mod sheet;
mod small;

pub(super) use legend::{firing_legend, star_legend, torque_legend};
pub(super) use names::shortened;
pub(super) use panel::Panel;
pub(super) use sheet::firing_figure;
pub(super) use sheet::{Scale, Sheet, WIDTH};
pub use sheet::{star_figure, torque_figure};
pub use small::{small_star, told};

use std::collections::BTreeMap;

use num_complex::Complex;
use num_rational::BigRational;
use num_traits::{Signed, ToPrimitive, Zero};

use super::argument;
use super::figure::Point;
use crate::exact::{Turn, fraction};
use crate::numbers;
use crate::order::Source;
use crate::proof::Polygon;
use crate::verdict::JudgedStar;

/// The vectors of one sum as they are drawn: all of positive length, those of negative weight turned by 180°.
pub(super) struct Star {
    /// The directions, angles rising.
    pub rays: Vec<Ray>,
    /// Where the sum vanishes: the polygons that the rays are made of.
    pub polygons: Vec<Polygon>,
    /// Where it does not: the sum in decimals.
    pub resultant: Option<Complex<f64>>,
    /// Whether some vector was turned because its weight is negative.
    pub has_turned: bool,
}

/// The vectors of one direction, laid end to end.
pub(super) struct Ray {
    /// The direction.
    pub angle: Turn,
    /// Sources with the lengths of their vectors.
    pub members: Vec<(Source, BigRational)>,
}

impl Ray {
    /// Length of the vectors together.
    pub fn total(&self) -> BigRational {
        self.members.iter().map(|(_, length)| length).sum()
    }

    /// The same as far as a drawing can tell; 0 for what is too long for it.
    pub fn length(&self) -> f64 {
        decimal(&self.total())
    }
}

fn decimal(length: &BigRational) -> f64 {
    length.to_f64().filter(|length| length.is_finite()).unwrap_or(0.0)
}

impl Star {
    /// A star as it is drawn.
    pub fn new<'a>(judged: impl Into<JudgedStar<'a>>) -> Self {
        let judged = judged.into();
        let mut by_angle: BTreeMap<Turn, Vec<(Source, BigRational)>> = BTreeMap::new();
        let terms = judged.sources.iter().zip(judged.sum.terms());
        for (source, term) in terms.filter(|(_, term)| !term.weight.is_zero()) {
            let angle = if term.weight.is_negative() { term.angle.opposite() } else { term.angle.clone() };
            by_angle.entry(angle).or_default().push((*source, term.weight.abs()));
        }
        let rays: Vec<Ray> = by_angle.into_iter().map(|(angle, members)| Ray { angle, members }).collect();
        Star {
            rays,
            polygons: argument::polygons_shown(judged),
            resultant: (!judged.vanishes()).then(|| numbers::evaluate(judged.sum)),
            has_turned: judged.sum.terms().iter().any(|term| term.weight.is_negative()),
        }
    }

    /// The greatest length in it.
    pub(super) fn reach(&self) -> f64 {
        let lengths = self.rays.iter().map(Ray::length).chain(self.resultant.map(|sum| sum.norm()));
        lengths.filter(|length| length.is_finite()).fold(0.0, f64::max)
    }
}

/// Angle 0 points up in every drawing.
pub(super) fn upright(vector: Complex<f64>) -> Point {
    vector * Point::i()
}

/// A unit vector of the drawing.
pub(super) fn towards(angle: &Turn) -> Point {
    upright(numbers::direction(angle))
}

/// The corners of a polygon at so many millimetres a unit.
fn corners(polygon: &Polygon, scale: f64) -> Vec<Point> {
    let radius = decimal(&polygon.weight) * scale;
    let corner = |j: u64| {
        let step = BigRational::new(j.into(), polygon.sides.into());
        towards(&Turn::new(fraction::plus(&polygon.rotation, &step))) * radius
    };
    (0..polygon.sides).map(corner).collect()
}
