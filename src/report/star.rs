//! What does the vector star look like? Rays of vectors, and the polygons or the resultant drawn on them.

use std::collections::BTreeMap;

use num_complex::Complex;
use num_rational::BigRational;
use num_traits::{Signed, ToPrimitive, Zero};

use super::figure::{Anchor, Dash, Figure, Ink, Point, Stroke};
use super::typeset;
use crate::engine::Engine;
use crate::exact::Turn;
use crate::numbers;
use crate::order::Source;
use crate::proof::{Polygon, Quantity};
use crate::verdict::{Balance, OrderBalance, Verdict};

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

    /// What the sources are called: cylinders by their names, then what turns.
    pub fn names(&self, engine: &Engine) -> String {
        source_names(engine, self.members.iter().map(|(source, _)| *source))
    }
}

/// More masses that turn than this have no room beside a vector.
const MOST_LABELLED: usize = 2;

/// The same in little room: `1, 5, rod 1`, `1, 5, +6`.
fn source_labels(engine: &Engine, sources: impl Iterator<Item = Source>) -> String {
    listed(engine, sources, |others| match others.len() {
        0..=MOST_LABELLED => others.iter().map(|source| source.label(engine)).collect(),
        many => vec![format!("+{many}")],
    })
}

/// What sources are called: cylinders by their names, then what turns.
pub(super) fn source_names(engine: &Engine, sources: impl Iterator<Item = Source>) -> String {
    listed(engine, sources, |others| others.iter().map(|source| source.name(engine)).collect())
}

/// Cylinders by their names, then what turns, in the words given.
fn listed(
    engine: &Engine,
    sources: impl Iterator<Item = Source>,
    turning: impl Fn(&[Source]) -> Vec<String>,
) -> String {
    let (pistons, others): (Vec<Source>, Vec<Source>) = sources.partition(|source| matches!(source, Source::Piston(_)));
    let pistons: Vec<String> = pistons.into_iter().map(|source| source.name(engine)).collect();
    let cylinders = typeset::names(&pistons.iter().map(String::as_str).collect::<Vec<_>>());
    (!cylinders.is_empty()).then_some(cylinders).into_iter().chain(turning(&others)).collect::<Vec<_>>().join(", ")
}

impl Star {
    /// The star of a verdict.
    pub fn new(verdict: &Verdict) -> Self {
        let mut by_angle: BTreeMap<Turn, Vec<(Source, BigRational)>> = BTreeMap::new();
        let terms = verdict.sources.iter().zip(verdict.sum.terms());
        for (source, term) in terms.filter(|(_, term)| !term.weight.is_zero()) {
            let angle = if term.weight.is_negative() { term.angle.opposite() } else { term.angle.clone() };
            by_angle.entry(angle).or_default().push((*source, term.weight.abs()));
        }
        let rays: Vec<Ray> = by_angle.into_iter().map(|(angle, members)| Ray { angle, members }).collect();
        Star {
            rays,
            polygons: super::argument::polygons_shown(verdict),
            resultant: (!verdict.vanishes()).then(|| numbers::evaluate(&verdict.sum)),
            has_turned: verdict.sum.terms().iter().any(|term| term.weight.is_negative()),
        }
    }

    /// The length that fills the panel.
    pub(super) fn reach(&self) -> f64 {
        let rays = self.rays.iter().map(|ray| ray.total().to_f64().unwrap_or(0.0));
        rays.chain(self.resultant.map(|sum| sum.norm())).fold(0.0, f64::max)
    }
}

/// Size of the panel of one star, and where things stand in it, in millimetres.
pub(super) const PANEL: (f64, f64) = (74.0, 68.0);
const CENTRE: Point = Point::new(37.0, 32.0);
const RADIUS: f64 = 19.0;
const LABELS: f64 = RADIUS + 3.2;
/// Labels that are closer than this go to a second ring.
const LABEL_HEIGHT: f64 = 3.4;
/// More rays than this are drawn without labels.
const MOST_LABELS: usize = 36;

/// The stars of one order: force above moment, direct beside reverse; the moment only where an arm is not zero.
pub(super) fn star_figure(engine: &Engine, order: &OrderBalance) -> Figure {
    let with_moment = order.moment.direct.sum.terms().iter().any(|term| !term.weight.is_zero());
    let rows: Vec<&Balance> = if with_moment { vec![&order.moment, &order.force] } else { vec![&order.force] };
    let mut figure = Figure::new(2.0 * PANEL.0, rows.len() as f64 * PANEL.1);
    for (row, balance) in rows.iter().enumerate() {
        for (column, verdict) in balance.verdicts().into_iter().enumerate() {
            let corner = Point::new(column as f64 * PANEL.0, row as f64 * PANEL.1);
            draw(&mut figure, corner, engine, verdict);
        }
    }
    figure
}

/// The stars of the inertia torque, two beside each other, the first above.
pub(super) fn torque_figure(engine: &Engine, verdicts: &[&Verdict]) -> Figure {
    let rows = verdicts.len().div_ceil(2);
    let mut figure = Figure::new(2.0 * PANEL.0, rows as f64 * PANEL.1);
    for (index, verdict) in verdicts.iter().enumerate() {
        let row = rows - 1 - index / 2;
        draw(&mut figure, Point::new((index % 2) as f64 * PANEL.0, row as f64 * PANEL.1), engine, verdict);
    }
    figure
}

fn draw(figure: &mut Figure, corner: Point, engine: &Engine, verdict: &Verdict) {
    let star = Star::new(verdict);
    let scale = scale(star.reach());
    draw_star(figure, corner, engine, verdict, &star, (scale, RESULTANT));
}

/// Width of a resultant in millimetres.
pub(super) const RESULTANT: f64 = 1.3;

/// Millimetres a unit, where this length fills a panel.
pub(super) fn scale(reach: f64) -> f64 {
    if reach > 0.0 { RADIUS / reach } else { 1.0 }
}

/// One panel: the star at so many millimetres a unit, its resultant in a line of this width.
pub(super) fn draw_star(
    figure: &mut Figure,
    corner: Point,
    engine: &Engine,
    verdict: &Verdict,
    star: &Star,
    (scale, width): (f64, f64),
) {
    let centre = corner + CENTRE;
    figure.heading(corner + Point::new(PANEL.0 / 2.0, PANEL.1 - 5.0), heading(verdict));
    figure.circle(centre, RADIUS, Stroke::solid(Ink::Light, 0.25), None);
    figure.line(
        centre,
        centre + Point::new(0.0, RADIUS + 1.0),
        Stroke { ink: Ink::Grey, width: 0.15, dash: Dash::Dashed },
    );
    for (index, polygon) in star.polygons.iter().enumerate() {
        draw_polygon(figure, centre, scale, polygon, index);
    }
    if let Some(resultant) = star.resultant {
        figure.arrow(centre, centre + upright(resultant) * scale, Stroke::solid(Ink::Red, width));
    }
    for ray in &star.rays {
        draw_ray(figure, centre, scale, ray);
    }
    if star.rays.len() <= MOST_LABELS {
        draw_labels(figure, centre, engine, star);
    }
    let place = corner + Point::new(PANEL.0 / 2.0, 3.6);
    let modulus = super::residual::modulus(verdict);
    let name = if verdict.vanishes() { "sum" } else { "length" };
    figure.formula(place, format!("{name} {}", modulus.plain()), format!("{name} {}", modulus.prose()));
}

fn heading(verdict: &Verdict) -> String {
    let quantity = match verdict.quantity {
        Quantity::Force => "Force",
        Quantity::Moment => "Moment",
        Quantity::Torque => "Torque",
    };
    let sense = verdict.sense.map(|sense| format!(", {}", sense.name())).unwrap_or_default();
    format!("{quantity}{sense}, order {}", verdict.order)
}

/// Angle 0 points up in every drawing.
pub(super) fn upright(vector: Complex<f64>) -> Point {
    vector * Point::i()
}

/// A unit vector of the drawing.
pub(super) fn towards(angle: &Turn) -> Point {
    upright(numbers::direction(angle))
}

fn draw_ray(figure: &mut Figure, centre: Point, scale: f64, ray: &Ray) {
    let along = towards(&ray.angle);
    let mut start = centre;
    for (_, length) in &ray.members {
        let end = start + along * length.to_f64().unwrap_or(0.0) * scale;
        figure.arrow(start, end, Stroke::solid(Ink::Black, 0.35));
        start = end;
    }
}

fn draw_polygon(figure: &mut Figure, centre: Point, scale: f64, polygon: &Polygon, index: usize) {
    let inks = [Ink::Blue, Ink::Orange, Ink::Green];
    let dashes = [Dash::Solid, Dash::Dashed, Dash::Dotted];
    let ink = inks[index % inks.len()];
    let dash = dashes[index / inks.len() % dashes.len()];
    let radius = polygon.weight.to_f64().unwrap_or(0.0) * scale;
    let corner = |j: u64| {
        let step = BigRational::new(j.into(), polygon.sides.into());
        centre + towards(&Turn::new(&polygon.rotation + step)) * radius
    };
    let corners: Vec<Point> = (0..polygon.sides).map(corner).collect();
    let width = if polygon.sides == 2 { 1.6 } else { 0.8 };
    figure.polygon(corners.clone(), Stroke { ink, width, dash }, None);
    for corner in corners {
        figure.circle(corner, 0.9, Stroke::solid(ink, 0.3), Some(ink));
    }
}

/// Names of the cylinders on a ring, tied to their vectors; close neighbours on a second ring.
fn draw_labels(figure: &mut Figure, centre: Point, engine: &Engine, star: &Star) {
    let mut last: Option<Point> = None;
    let mut first: Option<Point> = None;
    let mut ring = 0;
    for ray in &star.rays {
        let along = towards(&ray.angle);
        let place = centre + along * LABELS;
        let too_close = |other: Option<Point>| other.is_some_and(|other| (place - other).norm() < LABEL_HEIGHT);
        ring = if too_close(last) || too_close(first) { (ring + 1) % 3 } else { 0 };
        let at = place + along * (f64::from(ring) * LABEL_HEIGHT);
        let anchor = match along.re {
            x if x > 0.2 => Anchor::Start,
            x if x < -0.2 => Anchor::End,
            _ => Anchor::Middle,
        };
        figure.text(at, source_labels(engine, ray.members.iter().map(|(source, _)| *source)), anchor);
        last = Some(place);
        first = first.or(Some(place));
    }
}
