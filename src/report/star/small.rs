//! How does an order look in the size of a stamp? One star without words.

use super::panel::draw_resultant;
use super::{Star, WholeStars, corners, upright};
use crate::engine::Engine;
use crate::page::figure::{Figure, Ink, Point, Stroke};
use crate::report::engine_page::{WeighedParts, Weighing};
use crate::verdict::{Judgement, OrderBalance, OrderVerdict, Verdict};

/// Width and height in millimetres.
const SIZE: f64 = 30.0;
const RADIUS: f64 = 13.0;
/// Width of the outline of the resultant in millimetres.
const OUTLINE: f64 = 0.8;
/// Height of the line that a label has, and the size of its letters.
const LABEL: f64 = 6.0;
const LETTERS: f64 = 4.0;

/// The sum that tells most of an order: the first that is left of force and moment, direct and reverse; where nothing is
/// left, the direct force.
pub fn told(order: &OrderBalance) -> &Verdict {
    let sums = [order.force.verdicts(), order.moment.verdicts()].into_iter().flatten();
    sums.into_iter().find(|verdict| !verdict.vanishes()).unwrap_or(&order.force.direct)
}

/// Every order that a moving part shows, in its order, as a star of that size.
pub fn small_stars(engine: &Engine, judged: &Judgement) -> Vec<(u32, Figure)> {
    let weighed = WeighedParts::new(engine, judged, Weighing::usual()).as_judged;
    let whole = weighed.as_ref().map(WholeStars::new);
    let star = |order: &OrderVerdict| match order.parts.as_slice() {
        [only] if only.class.is_none() => Some(Star::of(engine, told(only))),
        _ => Some(whole.as_ref()?.told(order.order)),
    };
    judged.orders.iter().filter_map(|order| Some((order.order, drawn(&star(order)?, None)))).collect()
}

/// That sum as a star of 30 mm, read at 80 pixels, with a label below it where one is given.
pub fn small_star(order: &OrderBalance, label: Option<&str>) -> Figure {
    drawn(&Star::new(told(order)), label)
}

fn drawn(star: &Star, label: Option<&str>) -> Figure {
    let below = if label.is_some() { LABEL } else { 0.0 };
    let mut figure = Figure::new(SIZE, SIZE + below).lettered(LETTERS);
    let centre = Point::new(SIZE / 2.0, SIZE / 2.0 + below);
    let reach = star.reach();
    let scale = if reach > 0.0 { RADIUS / reach } else { 0.0 };
    let mut drawing = Figure::new(SIZE, SIZE);
    drawing.circle(Point::default(), RADIUS, Stroke::solid(Ink::Light, 0.5), None);
    for (index, polygon) in star.polygons.iter().enumerate() {
        let ink = [Ink::Blue, Ink::Orange, Ink::Green][index % 3];
        let width = if polygon.sides == 2 { 2.4 } else { 1.2 };
        drawing.polygon(corners(polygon, scale), Stroke::solid(ink, width), None);
    }
    for ray in &star.rays {
        drawing.arrow(Point::default(), ray.along() * ray.length() * scale, Stroke::solid(Ink::Black, 0.7));
    }
    if let Some(resultant) = star.resultant {
        draw_resultant(&mut drawing, upright(resultant) * scale, OUTLINE);
    }
    figure.place(drawing, centre);
    if let Some(label) = label {
        figure.heading(Point::new(SIZE / 2.0, LABEL / 2.0), label);
    }
    figure
}
