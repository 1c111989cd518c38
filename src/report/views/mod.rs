//! What does the engine look like? From its free end, and from the side.

mod below;
mod caption;
mod crankshaft;
mod crop;
mod end_view;
mod linkage;
mod names;
mod rows;
mod scale;
mod side_view;

pub(super) use caption::{end_view_caption, side_view_caption};
pub use end_view::end_view;
pub(super) use linkage::axes;
pub use side_view::side_view;

use num_traits::Signed;

use super::plot::number::text_width;
use super::typeset;
use crate::exact::Turn;

/// More pins or pistons than this are drawn without labels.
const MOST_LABELS: usize = 48;

/// `+45°`, `−60°`, `0°`, as bank angles are spoken of.
fn signed_angle(turn: &Turn) -> String {
    let degrees = typeset::signed_degrees(turn);
    let sign = if degrees.is_positive() { "+" } else { "" };
    format!("{sign}{}", typeset::degrees(&degrees))
}

/// A text in lines of about this width at most, broken after letters that stay at the end of its line.
fn wrapped(text: &str, after: &[char], width: f64) -> Vec<String> {
    let mut lines: Vec<String> = Vec::new();
    for piece in text.split_inclusive(after) {
        match lines.last_mut() {
            Some(line) if text_width(line) + text_width(piece) <= width => line.push_str(piece),
            _ => lines.push(piece.to_owned()),
        }
    }
    lines
}
