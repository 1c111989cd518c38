//! How is a crankshaft drawn from the side? Journals, webs, pins, counterweights and bearings, towards the reader or away.

use num_rational::BigRational;
use num_traits::ToPrimitive;

use super::super::figure::{Dash, Figure, Ink, Point, Stroke};
use super::super::star::towards;
use super::scale::Scale;
use crate::engine::{Convention, Engine, SeenFrom, Throw, throws};
use crate::exact::Turn;

/// The largest crank radius in millimetres; the axis of the crankshaft is at the height 0.
pub(super) const RADIUS: f64 = 9.0;
/// Half the height of a pin, a journal, a counterweight.
const PIN: f64 = 1.1;
const JOURNAL: f64 = 0.9;
const WEIGHT: f64 = 1.5;
/// How far a web reaches over the middle of its pin.
const WEB: f64 = 1.7;
/// Half the length of a throw on the page, where there is room.
const LONGEST: f64 = 3.6;
const SHORTEST: f64 = 0.5;
/// Counterweights without a crank radius to compare with are drawn this far out.
const USUAL_WEIGHT: f64 = 0.8;

/// Where something stands that turns with the crank, seen from the side.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(super) enum Side {
    Away,
    InPlane,
    Near,
}

impl Side {
    /// The free end is at the left and direction 0 up: direction 270° points at the reader, and 90° where angles are seen
    /// from the flywheel.
    pub fn of(angle: &Turn, convention: Convention) -> Self {
        let side = match convention.turns_anticlockwise_from() {
            SeenFrom::FreeEnd => 1.0,
            SeenFrom::Flywheel => -1.0,
        };
        match side * towards(angle).re {
            x if x > 1e-9 => Side::Near,
            x if x < -1e-9 => Side::Away,
            _ => Side::InPlane,
        }
    }

    /// Filled, grey or hollow; the outline of what is behind is dashed.
    pub fn style(self, ink: Ink) -> (Stroke, Ink) {
        match self {
            Side::Near => (Stroke::solid(ink, 0.3), ink),
            Side::InPlane => (Stroke::solid(ink, 0.3), Ink::Shade(20)),
            Side::Away => (Stroke { ink, width: 0.3, dash: Dash::Dashed }, Ink::Shade(0)),
        }
    }
}

/// A throw as it is drawn.
pub(super) struct Drawn {
    pub throw: Throw,
    pub side: Side,
    /// Its middle and half its length on the page.
    pub x: f64,
    pub half: f64,
    /// Height of its pin.
    height: f64,
}

/// The throws with their places: those at one position beside each other.
pub(super) fn drawn_throws(engine: &Engine, scale: &Scale) -> Vec<Drawn> {
    let throws = throws(engine);
    let radius = |throw: &Throw| throw.crank_radius.to_f64().unwrap_or(1.0);
    let largest = throws.iter().map(|throw| radius(throw).abs()).fold(0.0, f64::max);
    let unit = if largest > 0.0 { RADIUS / largest } else { 0.0 };
    let place = |throw: &Throw| throws.iter().filter(|other| other.position == throw.position).collect::<Vec<_>>();
    let drawn = |throw: &Throw| {
        let beside = place(throw);
        let index = beside.iter().position(|other| *other == throw).unwrap_or(0);
        let xs = throw.cylinders.iter().map(|&cylinder| scale.x(&engine.cylinders()[cylinder].position));
        let middle = scale.x(&throw.position);
        let reach = xs.map(|x| (x - middle).abs() + 1.5).fold(0.0, f64::max);
        let whole = LONGEST.max(reach).min(0.36 * scale.throws_apart).max(SHORTEST);
        let half = whole / beside.len() as f64;
        Drawn {
            side: Side::of(&throw.angle, engine.convention()),
            x: middle - whole + half * (2 * index + 1) as f64,
            half,
            height: unit * radius(throw) * towards(&throw.angle).im,
            throw: throw.clone(),
        }
    };
    throws.iter().map(drawn).collect()
}

/// A rectangle around a point.
fn block(figure: &mut Figure, at: Point, half: Point, stroke: Stroke, fill: Ink) {
    let corner = |x: f64, y: f64| at + Point::new(half.re * x, half.im * y);
    figure.polygon(
        vec![corner(-1.0, -1.0), corner(1.0, -1.0), corner(1.0, 1.0), corner(-1.0, 1.0)],
        stroke,
        Some(fill),
    );
}

/// Draws journals, then throws and counterweights, those farther from the reader first.
pub(super) fn draw_crankshaft(figure: &mut Figure, engine: &Engine, scale: &Scale, throws: &[Drawn]) {
    let mut ordered: Vec<&Drawn> = throws.iter().collect();
    ordered.sort_by(|a, b| a.x.total_cmp(&b.x));
    let (left, right) = ends(scale, throws);
    let mut start = left;
    for throw in &ordered {
        journal(figure, start, throw.x - throw.half);
        start = throw.x + throw.half;
    }
    journal(figure, start, right);
    for bearing in engine.bearings() {
        draw_bearing(figure, Point::new(scale.x(bearing), 0.0));
    }
    for side in [Side::Away, Side::InPlane, Side::Near] {
        for throw in ordered.iter().filter(|throw| throw.side == side) {
            draw_throw(figure, throw);
        }
        draw_counterweights(figure, engine, scale, side);
    }
}

/// How far the shaft reaches on the page.
pub(super) fn ends(scale: &Scale, throws: &[Drawn]) -> (f64, f64) {
    let left = throws.iter().map(|throw| throw.x - throw.half).fold(0.0, f64::min);
    let right = throws.iter().map(|throw| throw.x + throw.half).fold(scale.span, f64::max);
    (left - 3.0, right + 3.0)
}

fn journal(figure: &mut Figure, from: f64, to: f64) {
    if to > from {
        let at = Point::new((from + to) / 2.0, 0.0);
        block(figure, at, Point::new((to - from) / 2.0, JOURNAL), Stroke::solid(Ink::Grey, 0.25), Ink::Light);
    }
}

/// The webs at both ends of the pin, and the pin between them.
fn draw_throw(figure: &mut Figure, throw: &Drawn) {
    let web = (throw.half * 0.28).min(0.8);
    let (low, high) = (throw.height.min(0.0) - WEB, throw.height.max(0.0) + WEB);
    for side in [-1.0, 1.0] {
        let at = Point::new(throw.x + side * (throw.half - web), (low + high) / 2.0);
        let outline = Stroke::solid(Ink::Blue, 0.2);
        block(figure, at, Point::new(web, (high - low) / 2.0), outline, Ink::Light);
    }
    let (stroke, fill) = throw.side.style(Ink::Blue);
    let half = Point::new((throw.half - 2.0 * web).max(0.3), PIN);
    block(figure, Point::new(throw.x, throw.height), half, stroke, fill);
}

fn draw_counterweights(figure: &mut Figure, engine: &Engine, scale: &Scale, side: Side) {
    let unit = engine.dimensions().crank_radius.as_ref().and_then(BigRational::to_f64).filter(|radius| *radius > 0.0);
    let weights =
        engine.crankshaft().counterweights.iter().filter(|weight| Side::of(&weight.angle, engine.convention()) == side);
    for weight in weights {
        let radius = weight.radius.to_f64().zip(unit).map_or(USUAL_WEIGHT, |(radius, unit)| radius / unit);
        let direction = towards(&weight.angle).im;
        let reach = RADIUS * radius.clamp(0.3, 1.3);
        let (x, y) = (scale.x(&weight.position), reach * direction);
        let (stroke, fill) = side.style(Ink::Black);
        figure.line(Point::new(x, 0.0), Point::new(x, y), Stroke::solid(Ink::Black, 0.5));
        block(figure, Point::new(x, y), Point::new(0.9, WEIGHT), stroke, fill);
    }
}

/// The two halves of a bearing, below and above the shaft.
pub(super) fn draw_bearing(figure: &mut Figure, at: Point) {
    for side in [-1.0, 1.0] {
        let middle = at + Point::new(0.0, side * (JOURNAL + 0.7));
        block(figure, middle, Point::new(1.2, 0.5), Stroke::solid(Ink::Black, 0.2), Ink::Shade(70));
    }
}

/// The sign of a side in the legend.
pub(super) fn sign(figure: &mut Figure, at: Point, side: Side, ink: Ink) {
    let (stroke, fill) = side.style(ink);
    block(figure, at, Point::new(if ink == Ink::Black { 0.9 } else { 1.7 }, PIN), stroke, fill);
}
