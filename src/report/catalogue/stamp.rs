//! How does an engine look in the size of a stamp? Its cranks and cylinders beside what shakes it: force and moment, at orders 1 and 2.

use std::f64::consts::TAU;

use num_complex::Complex;

use super::super::engine_page::{Weighed, Weighing};
use super::super::figure::{Anchor, Figure, Ink, Point, Stroke};
use super::super::star::upright;
use super::KnownEngine;
use super::small::small_engine;
use crate::loads::Swing;
use crate::order::Masses;
use crate::proof::Planar;

/// Width of the drawing of the engine in millimetres, and of a field of the matrix.
const DRAWING: f64 = 26.0;
const FIELD: f64 = 19.0;
/// Size of the letters of a name, of a number, and of what a field is called.
const NAME: f64 = 6.2;
const NUMBER: f64 = 6.6;
const CALLED: f64 = 6.0;
/// Height of the line of the name.
const HEAD: f64 = 9.0;
/// Half the size of a path.
const PATH: f64 = 3.2;
/// The orders of the matrix.
const ORDERS: [u32; 2] = [1, 2];
/// What is smaller than half of the last place of a number.
const LEAST: f64 = 0.005;

/// An engine as it is on a poster.
pub(in crate::report) struct Stamp {
    name: &'static str,
    engine: Figure,
    /// Force above moment, order 1 beside order 2; none where sizes are not known.
    fields: [[Option<Swing>; 2]; 2],
}

impl Stamp {
    /// Its width in millimetres: the engine beside the matrix.
    pub const WIDTH: f64 = DRAWING + 2.0 * FIELD + 2.0;
    /// Its height: the name above two fields.
    pub const HEIGHT: f64 = HEAD + 2.0 * FIELD + 2.0;

    /// The stamp of an engine of the catalogue.
    pub fn new(known: &KnownEngine) -> Self {
        let weighed = Weighed::new(known.engine, Masses::Reciprocating, &ORDERS, Weighing::usual());
        let swing = |order, quantity| weighed.as_ref()?.swing(order, quantity).cloned();
        Stamp {
            name: known.name,
            engine: small_engine(known.engine),
            fields: Planar::BOTH.map(|quantity| ORDERS.map(|order| swing(order, quantity))),
        }
    }

    /// Draws it below this point, centred.
    pub fn draw(&self, figure: &mut Figure, top: Point) {
        let left = top - Stamp::WIDTH / 2.0;
        figure.title(top - Point::new(0.0, HEAD / 2.0), self.name, NAME, Anchor::Middle);
        let below = HEAD + FIELD + DRAWING / 2.0;
        figure.place(self.engine.clone().scaled(DRAWING / self.engine.width), left - Point::new(0.0, below));
        for (row, (letter, fields)) in ["F", "M"].into_iter().zip(&self.fields).enumerate() {
            for (column, (order, swing)) in ORDERS.into_iter().zip(fields).enumerate() {
                let x = DRAWING + 2.0 + FIELD * column as f64;
                let corner = left + Point::new(x, -HEAD - FIELD * row as f64);
                draw_field(figure, corner, &format!("{letter}{order}"), swing.as_ref());
            }
        }
    }
}

/// A field below and to the right of this corner: what it is about, and how large that is below the path that it traces.
fn draw_field(figure: &mut Figure, corner: Point, called: &str, swing: Option<&Swing>) {
    let at = |x: f64, y: f64| corner + Point::new(x, -y);
    let (gap, end) = (0.5, FIELD - 0.5);
    let corners = vec![at(gap, gap), at(end, gap), at(end, end), at(gap, end)];
    let left = swing.filter(|swing| !swing.vanishes());
    figure.polygon(corners, Stroke::solid(Ink::Grey, 0.25), left.map(|_| Ink::Light));
    figure.title(at(1.3, 3.7), called, CALLED, Anchor::Start);
    let number = at(FIELD / 2.0, FIELD - 4.4);
    let Some(left) = left else {
        let zero = if swing.is_some() { "0" } else { "?" };
        return figure.title(at(FIELD / 2.0, FIELD / 2.0 + 3.0), zero, 1.4 * NUMBER, Anchor::Middle);
    };
    let [direct, reverse] = left.amplitudes();
    let largest = left.largest();
    let point = |step: i32| {
        let turn = Complex::from_polar(1.0, f64::from(step) * TAU / 72.0);
        at(FIELD - 1.1 - PATH, 1.4 + PATH) + upright(direct * turn + reverse * turn.conj()) * (PATH / largest)
    };
    figure.path((0..=72).map(point).collect(), Stroke::solid(Ink::Red, 0.8));
    figure.title(number, size(largest), NUMBER, Anchor::Middle);
}

/// `1.17`, `21.2`.
fn size(value: f64) -> String {
    match value {
        _ if value < LEAST => "<0.01".to_owned(),
        _ if value < 9.995 => format!("{value:.2}"),
        _ if value < 99.95 => format!("{value:.1}"),
        _ => format!("{value:.0}"),
    }
}
