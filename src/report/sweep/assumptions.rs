//! What is assumed of an engine's size, in words?

use crate::page::{Text, phrase};
use crate::sweep::Geometry;

/// The geometry behind length, breadth and height.
pub(super) fn assumptions(geometry: &Geometry) -> [Text; 4] {
    let Geometry { bore, rod_ratio, half_width, above_pin, crankcase, spacing, ends } = geometry;
    let [bore, rod_ratio, above_pin, crankcase, spacing, ends] =
        [bore, rod_ratio, above_pin, crankcase, spacing, ends].map(f64::to_string);
    let width = (2.0 * half_width).to_string();
    [
        phrase!("bore D = {} r, r the crank radius; rod ratio {} where the layout gives none", bore, rod_ratio),
        phrase!(
            "seen from the end a bank is a rectangle about its axis, {} D wide, from the shaft to {} D above the piston pin at top dead centre, which stands r + l above the shaft; the crankcase is a circle of radius {} r about the shaft",
            width,
            above_pin,
            crankcase
        ),
        "breadth and height are those of the upright rectangle round all banks and the crankcase, the bisector upright"
            .into(),
        phrase!(
            "length: from the first to the last cylinder axis, and {} D; neighbours of a bank are {} D apart where the layout gives no length",
            ends,
            spacing
        ),
    ]
}
