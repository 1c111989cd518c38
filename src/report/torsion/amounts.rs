//! How are speeds, parts and torques of a shaft written?

use super::study::TorsionStudy;
use crate::page::{Piece, Setting, Text, Unit, number};

/// A speed, rounded to what a reader wants to know.
pub(super) fn rpm(value: f64) -> Text {
    Piece::Quantity(value, Unit::PER_MINUTE).into()
}

/// The speed that the numbers are for, as it is given.
pub(super) fn given_rpm(value: f64) -> Text {
    let whole = |value: f64| match value.to_string() {
        short if short.len() <= LONGEST_GIVEN => short,
        _ => number::sensible(value),
    };
    Text::set_in(value, Unit::PER_MINUTE, Setting::Fixed(whole))
}

/// Longer speeds, such as 1000/3, are rounded.
const LONGEST_GIVEN: usize = 10;

/// Two speeds of a range, in hundredths where they would look alike.
pub(super) fn range([from, to]: [f64; 2]) -> [Text; 2] {
    let hundredths = |value| Text::set_in(value, Unit::PER_MINUTE, Setting::Fixed(|value| format!("{value:.2}")));
    if to - from < NARROW * to { [from, to].map(hundredths) } else { [from, to].map(rpm) }
}

/// A range that is narrower than this part of its speeds is told in hundredths.
const NARROW: f64 = 0.02;

/// A part of the greatest length, in hundredths.
pub(super) fn part(value: f64) -> Text {
    Piece::Quantity(100.0 * value, Unit::PERCENT).into()
}

pub(super) fn torque(value: f64) -> Text {
    Piece::Quantity(value, Unit::NEWTON_METRE).into()
}

/// The discs at both ends of a shaft: `7–8`.
pub(super) fn shaft(study: &TorsionStudy, shaft: usize) -> String {
    let [one, other] = ends(study, shaft);
    format!("{one}–{other}")
}

/// The same in a drawing, whole: the pattern of another language has both places.
pub(super) fn shaft_drawn(study: &TorsionStudy, shaft: usize) -> String {
    let [one, other] = ends(study, shaft);
    format!("shaft {}–{}", one, other)
}

fn ends(study: &TorsionStudy, shaft: usize) -> [usize; 2] {
    study.torsion().shafts[shaft].ends.map(|disc| disc + 1)
}
