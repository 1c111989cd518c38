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
    judged.orders.iter().filter_map(|order| Some((order.order, drawn(&star(order)?)))).collect()
}

/// That sum as a star of 30 mm, read at 80 pixels.
pub fn small_star(order: &OrderBalance) -> Figure {
    drawn(&Star::new(told(order)))
}

fn drawn(star: &Star) -> Figure {
    let reach = star.reach();
    let scale = if reach > 0.0 { RADIUS / reach } else { 0.0 };
    let mut figure = Figure::new(SIZE, SIZE);
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
    figure.place(drawing, Point::new(SIZE / 2.0, SIZE / 2.0));
    figure
}
