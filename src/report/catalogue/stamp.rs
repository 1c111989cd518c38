//! How does an engine look in the size of a stamp? The star of the lowest order left, its name, what is left.

use num_traits::ToPrimitive;

use super::super::calculation::plain;
use super::super::figure::{Anchor, Figure, Ink, Mark, Point, Stroke};
use super::super::residual;
use super::super::star::{Star, towards, upright};
use super::Known;
use crate::page::{Text, phrase};
use crate::verdict::{Balance, OrderBalance, Verdict};

/// Width and height of a star in millimetres.
const STAR: f64 = 30.0;
const RADIUS: f64 = 13.0;
const NAME: f64 = 3.8;

/// An engine as it stands on a poster.
pub(in crate::report) struct Stamp {
    name: &'static str,
    lines: [String; 2],
    star: Figure,
}

impl Stamp {
    /// Its height in millimetres: the star, the name, a line on the force and one on the moment.
    pub const HEIGHT: f64 = STAR + 12.5;

    /// The stamp of an engine of the catalogue.
    pub fn new(known: &Known) -> Self {
        Stamp {
            name: known.name,
            lines: lines(known).map(plain),
            star: known.drawn().map_or_else(|| Figure::new(STAR, STAR), |order| small_star(&order)),
        }
    }

    /// Draws it below this point, centred.
    pub fn draw(&self, figure: &mut Figure, top: Point) {
        place(figure, &self.star, top - Point::new(STAR / 2.0, STAR));
        let below = |millimetres: f64| top - Point::new(0.0, STAR + millimetres);
        figure.title(below(2.0), self.name, NAME, Anchor::Middle);
        for (index, line) in self.lines.iter().enumerate() {
            figure.text(below(6.4 + 4.0 * index as f64), line.clone(), Anchor::Middle);
        }
    }
}

/// What is left first of the force and of the moment.
fn lines(known: &Known) -> [Text; 2] {
    let Some([force, moment]) = known.first() else { return ["not stated of every order".into(), Text::default()] };
    let shape = |first: &Balance| residual::shape_name(first.shape);
    let force = match force {
        Some(first) => phrase!("force {}, {}", first.direct.order, shape(first)),
        None => "no force".into(),
    };
    let moment = match moment {
        Some(first) => phrase!("moment {}, {}", first.direct.order, shape(first)),
        None => "no moment".into(),
    };
    [force, moment]
}

/// The sum that tells most of an order: the first that is left of force and moment, direct and reverse; where nothing is
/// left, the direct force.
fn told(order: &OrderBalance) -> &Verdict {
    let sums = [order.force.verdicts(), order.moment.verdicts()].into_iter().flatten();
    sums.into_iter().find(|verdict| !verdict.vanishes()).unwrap_or(&order.force.direct)
}

/// That sum as a star without words.
fn small_star(order: &OrderBalance) -> Figure {
    let star = Star::new(told(order));
    let mut figure = Figure::new(STAR, STAR);
    let centre = Point::new(STAR / 2.0, STAR / 2.0);
    let reach = star.reach();
    let scale = if reach > 0.0 { RADIUS / reach } else { 0.0 };
    figure.circle(centre, RADIUS, Stroke::solid(Ink::Light, 0.5), None);
    for (index, polygon) in star.polygons.iter().enumerate() {
        let corner = |j: u64| {
            let step = num_rational::BigRational::new(j.into(), polygon.sides.into());
            let along = towards(&crate::exact::Turn::new(&polygon.rotation + step));
            centre + along * polygon.weight.to_f64().unwrap_or(0.0) * scale
        };
        let ink = [Ink::Blue, Ink::Orange, Ink::Green][index % 3];
        figure.polygon((0..polygon.sides).map(corner).collect(), Stroke::solid(ink, 1.0), None);
    }
    for ray in &star.rays {
        let tip = centre + towards(&ray.angle) * ray.total().to_f64().unwrap_or(0.0) * scale;
        figure.arrow(centre, tip, Stroke::solid(Ink::Black, 0.4));
    }
    if let Some(resultant) = star.resultant {
        figure.arrow(centre, centre + upright(resultant) * scale, Stroke::solid(Ink::Red, 0.9));
    }
    figure
}

/// Puts a drawing upon another, its lower left corner here.
fn place(figure: &mut Figure, drawing: &Figure, corner: Point) {
    let moved = drawing.marks.iter().cloned().map(|mut mark| {
        match &mut mark {
            Mark::Line { from, to, .. } => {
                *from += corner;
                *to += corner;
            }
            Mark::Circle { centre: at, .. } | Mark::Text { at, .. } | Mark::Title { at, .. } => *at += corner,
            Mark::Polygon { corners: points, .. } | Mark::Path { points, .. } => {
                points.iter_mut().for_each(|point| *point += corner);
            }
            Mark::Rectangles { corners, .. } => corners.iter_mut().for_each(|(low, high)| {
                *low += corner;
                *high += corner;
            }),
        }
        mark
    });
    figure.marks.extend(moved);
}
