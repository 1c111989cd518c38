//! What does the vector star look like? Rays of vectors, and the polygons or the resultant drawn on them.

mod labels;
mod legend;
mod names;
mod panel;
mod scale;
mod sheet;
mod small;
mod whole;

pub(super) use legend::{legend_of_one_scale, short_names_in_tables, star_legend};
pub(super) use names::{short_names, shortened, source_names};
pub(super) use panel::Panel;
pub(super) use sheet::{Sheet, firing_figure, sized_star_figure};
pub use sheet::{star_figure, torque_figure};
pub use small::{small_star, small_stars, told};
pub(super) use whole::{WholeStars, whole_legend, whole_star_figure};

use num_complex::Complex;
use num_rational::BigRational;
use num_traits::ToPrimitive;

use super::argument::{ExactRay, ExactStar};
use super::figure::Point;
use crate::engine::{Engine, GearedCrank};
use crate::exact::{PhasorSum, Term, Turn, fraction};
use crate::numbers;
use crate::order::Source;
use crate::proof::{Polygon, Quantity};
use crate::verdict::{JudgedStar, Verdict};

pub(super) use scale::{Scale, WIDTH};

/// The vectors of one sum as they are drawn: all of positive length, those of negative weight turned by 180°.
///
/// Force and moment of an order are half of each of two sums that turn against each other, so their vectors are drawn halved: the
/// resultant is what the engine feels.
pub(in crate::report) struct Star {
    /// The directions, angles rising.
    pub rays: Vec<Ray>,
    /// Where the sum vanishes: the polygons that the rays are made of.
    pub polygons: Vec<Polygon>,
    /// Where it does not: the sum in decimals.
    pub resultant: Option<Complex<f64>>,
    /// Whether some vector was turned because its weight is negative.
    pub has_turned: bool,
    /// Whether a ray is the resultant of a whole crankshaft.
    pub by_crank: bool,
}

/// Stars of several crankshafts with more directions than this are drawn crankshaft by crankshaft.
const MOST_OF_CRANKS: usize = 6;

/// The vectors of one direction, laid end to end.
pub(in crate::report) struct Ray {
    /// The direction, of length 1.
    pub direction: Complex<f64>,
    /// Sources with the lengths of their vectors.
    pub members: Vec<(Source, f64)>,
    /// What it is called, where it is not by its members.
    pub name: Option<String>,
}

impl Ray {
    /// Length of the vectors together.
    pub fn length(&self) -> f64 {
        self.members.iter().map(|(_, length)| length).sum()
    }

    /// Where it points on the drawing.
    pub fn along(&self) -> Point {
        upright(self.direction)
    }
}

/// What a drawing can tell of a length; 0 for what is too long for it.
fn decimal(length: &BigRational) -> f64 {
    length.to_f64().filter(|length| length.is_finite()).unwrap_or(0.0)
}

/// The part of a sum that the engine feels.
pub(in crate::report) fn part_felt(quantity: Quantity) -> BigRational {
    match quantity {
        Quantity::Planar(_) => BigRational::new(1.into(), 2.into()),
        Quantity::Axial(_) => BigRational::from_integer(1.into()),
    }
}

impl Star {
    /// A star as it is drawn.
    pub fn new<'a>(judged: impl Into<JudgedStar<'a>>) -> Self {
        let judged = judged.into();
        let part = part_felt(judged.quantity);
        let exact = ExactStar::new(judged);
        let member = |(source, length): (Source, BigRational)| (source, decimal(&(length * &part)));
        let ray = |ray: ExactRay| Ray {
            direction: numbers::direction(&ray.angle),
            members: ray.members.into_iter().map(member).collect(),
            name: None,
        };
        let halved = |polygon: Polygon| Polygon { weight: polygon.weight * &part, ..polygon };
        Star {
            rays: exact.rays.into_iter().map(ray).collect(),
            polygons: exact.polygons.into_iter().map(halved).collect(),
            resultant: (!judged.vanishes()).then(|| numbers::evaluate(judged.sum) * decimal(&part)),
            has_turned: exact.has_turned,
            by_crank: false,
        }
    }

    /// The star of an engine: where several crankshafts would fill it with vectors, the resultant of each.
    pub fn of(engine: &Engine, verdict: &Verdict) -> Self {
        let star = Star::new(verdict);
        let cranks = engine.geared_cranks();
        let is_piston = |source: &Source| source.piston().is_some();
        if cranks.len() < 2 || star.rays.len() <= MOST_OF_CRANKS || !verdict.sources.iter().all(is_piston) {
            return star;
        }
        let part = decimal(&part_felt(verdict.quantity));
        let ray = |(index, crank): (usize, &GearedCrank)| {
            let on_it =
                |source: &Source| source.piston().is_some_and(|piston| engine.cylinders()[piston].crank == index);
            let terms = verdict.sources.iter().zip(verdict.sum.terms()).filter(|(source, _)| on_it(source));
            let (sources, terms): (Vec<Source>, Vec<Term>) =
                terms.map(|(source, term)| (*source, term.clone())).unzip();
            let sum = PhasorSum::new(terms);
            let first = *sources.first()?;
            (!sum.vanishes()).then(|| {
                let value = numbers::evaluate(&sum);
                let length = value.norm();
                Ray { direction: value / length, members: vec![(first, length * part)], name: Some(crank.name.clone()) }
            })
        };
        let rays = cranks.iter().enumerate().filter_map(ray).collect();
        Star { rays, polygons: Vec::new(), has_turned: false, by_crank: true, ..star }
    }

    /// What is in the place of vectors where there are none.
    pub(super) fn nothing(&self) -> &'static str {
        if self.by_crank { "each crankshaft: 0" } else { "no vectors" }
    }

    /// The greatest length in it.
    pub(super) fn reach(&self) -> f64 {
        let lengths = self.rays.iter().map(Ray::length).chain(self.resultant.map(|sum| sum.norm()));
        lengths.filter(|length| length.is_finite()).fold(0.0, f64::max)
    }
}

/// Angle 0 points up in every drawing.
pub(in crate::report) fn upright(vector: Complex<f64>) -> Point {
    vector * Point::i()
}

/// A unit vector of the drawing.
pub(in crate::report) fn towards(angle: &Turn) -> Point {
    upright(numbers::direction(angle))
}

/// The corners of a polygon at this many millimetres a unit.
pub(in crate::report) fn corners(polygon: &Polygon, scale: f64) -> Vec<Point> {
    let radius = decimal(&polygon.weight) * scale;
    let corner = |j: u64| {
        let step = BigRational::new(j.into(), polygon.sides.into());
        towards(&Turn::new(fraction::plus(&polygon.rotation, &step))) * radius
    };
    (0..polygon.sides).map(corner).collect()
}
