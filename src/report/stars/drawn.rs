//! How do minimal stars look beside each other? In rows, each with its polygons and a number.

use num_traits::Signed;

use crate::exact::MinimalStar;
use crate::page::figure::{Anchor, Dash, Figure, Ink, Point, Stroke};
use crate::proof::Certificate;
use crate::report::star::{corners, towards};

/// The side of the field of a star, its radius, and the height of its number, in millimetres.
const FIELD: f64 = 32.0;
const RADIUS: f64 = 13.0;
const LABEL: f64 = 5.0;
/// So many stars are in a row.
const IN_A_ROW: usize = 6;

/// The stars with their numbers.
pub(super) fn stars(stars: &[(String, &MinimalStar)]) -> Figure {
    let columns = stars.len().min(IN_A_ROW);
    let rows = stars.len().div_ceil(IN_A_ROW);
    let height = rows as f64 * (FIELD + LABEL);
    let mut figure = Figure::new(columns as f64 * FIELD, height);
    for (index, (label, star)) in stars.iter().enumerate() {
        let left = (index % IN_A_ROW) as f64 * FIELD;
        let top = height - (index / IN_A_ROW) as f64 * (FIELD + LABEL);
        let centre = Point::new(left + FIELD / 2.0, top - FIELD / 2.0);
        figure.place(drawing(star), centre);
        figure.text(Point::new(centre.re, top - FIELD - LABEL / 2.0), label.clone(), Anchor::Middle);
    }
    figure
}

/// A star about the origin: ring, polygons, vectors.
fn drawing(star: &MinimalStar) -> Figure {
    let mut drawing = Figure::new(0.0, 0.0);
    drawing.circle(Point::default(), RADIUS, Stroke::solid(Ink::Light, 0.25), None);
    if let Certificate::Polygons { polygons } = star.sum().certificate() {
        for polygon in &polygons {
            let dash = if polygon.weight.is_negative() { Dash::Dashed } else { Dash::Solid };
            // A polygon that is taken away is drawn where it is.
            let corners = corners(polygon, if polygon.weight.is_negative() { -RADIUS } else { RADIUS });
            match corners[..] {
                [one, other] => drawing.line(one, other, Stroke { ink: Ink::Grey, width: 0.9, dash }),
                _ => drawing.polygon(corners, Stroke { ink: ink(polygon.sides), width: 0.6, dash }, None),
            }
        }
    }
    for angle in star.angles() {
        drawing.arrow(Point::default(), towards(&angle) * RADIUS, Stroke::solid(Ink::Black, 0.35));
    }
    drawing
}

/// Polygons of as many sides have one colour.
fn ink(sides: u64) -> Ink {
    match sides {
        3 => Ink::Orange,
        5 => Ink::Green,
        _ => Ink::Blue,
    }
}
