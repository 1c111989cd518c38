//! How is it put for which φ and δ a sum vanishes that was cut into boxes?

use num_rational::BigRational;
use num_traits::Zero;

use super::circle_words::about;
use super::coordinate::{self, Coordinate};
use super::unknowns::{self, NEVER, zero_where};
use crate::family::Boxes;
use crate::page::Text;
use crate::proof::{BoxZeroClaim, BoxesClaim};
use crate::report::texts::family as text;

/// `0 where φ ≡ 90° and δ ≡ 60°, or φ ≈ 12.5° and δ ≈ 75.52°`, and where it is not known.
pub(super) fn condition(found: &Boxes) -> Text {
    let none = if found.claim.zeros.is_empty() { "never 0" } else { NEVER };
    zero_where(zeros(found), open(found)).unwrap_or_else(|| none.into())
}

/// The zeros; none where no zero is known.
fn zeros(found: &Boxes) -> Option<Text> {
    let times = times(found);
    let coordinates = |(zero, near): (&BoxZeroClaim, &[f64; 2])| match zero.certificate {
        Some(_) => times.iter().zip([&zero.s, &zero.t]).map(|(times, turn)| Coordinate::exact(times, turn)).collect(),
        None => times.iter().zip(near).map(|(times, turns)| Coordinate::near(times, 360.0 * turns)).collect(),
    };
    coordinate::in_words(found.claim.zeros.iter().zip(&found.near).map(coordinates))
}

/// Where it is not known.
fn open(found: &Boxes) -> impl Iterator<Item = Text> + '_ {
    let [s, t] = names(found);
    found.open.iter().map(move |[across, along]| {
        let [[a, b], [c, d]] = [across, along].map(|ends| about(ends.each_ref()));
        text::open_box(s.clone(), a, b, t.clone(), c, d)
    })
}

/// Why it vanishes there, and nowhere else.
pub(super) fn why(found: &Boxes) -> Text {
    let [s, t] = names(found);
    let lead = text::boxes(s, t, found.count(), found.claim.zeros.len());
    let so = match (zeros(found), found.is_complete()) {
        (Some(zeros), true) => text::so_zeros(zeros),
        (None, true) => text::so_none(),
        (Some(zeros), false) => text::zeros_but_in_open_boxes(zeros),
        (None, false) => text::no_zero_but_in_open_boxes(),
    };
    Text::joined([lead, so].into_iter().chain(open(found).map(text::step_limit)), " ")
}

/// s and t.
fn names(found: &Boxes) -> [String; 2] {
    unknowns::names(times(found).each_ref())
}

/// How many times φ and δ enter each.
fn times(found: &Boxes) -> [[BigRational; 2]; 2] {
    let BoxesClaim { phi, delta, .. } = &found.claim;
    [[phi.clone(), BigRational::zero()], [BigRational::zero(), delta.clone()]]
}
