//! How are speeds, parts and torques of a shaft written?

use super::study::TorsionStudy;
use crate::page::{Piece, Text, Unit};

/// A speed, rounded to what a reader wants to know.
pub(super) fn rpm(value: f64) -> Text {
    Piece::Quantity(value, Unit::PER_MINUTE).into()
}

/// A part of the greatest length, in hundredths.
pub(super) fn part(value: f64) -> Text {
    Piece::Quantity(100.0 * value, Unit::PERCENT).into()
}

pub(super) fn torque(value: f64) -> Text {
    Piece::Quantity(value, Unit::NEWTON_METRE).into()
}

/// The discs at both ends of a shaft: `7–8`.
pub(super) fn shaft(study: &TorsionStudy, shaft: usize) -> String {
    let [one, other] = study.torsion().shafts[shaft].ends;
    format!("{}–{}", one + 1, other + 1)
}
