//! How is it put for which φ and δ a sum vanishes that was cut into boxes?

use num_rational::BigRational;
use num_traits::Zero;

use super::super::typeset;
use super::circle_words::about;
use super::unknowns::{NEVER, alternatives, near, unknowns, zero_where};
use crate::family::{BoxZero, Boxes, Place, is_in_range};
use crate::page::Text;
use crate::report::texts::family as text;

/// `0 where φ ≡ 90° and δ ≡ 60°, or φ ≈ 12.5° and δ ≈ 75.52°`, and where it is not known.
pub(super) fn condition(found: &Boxes) -> Text {
    let none = if found.zeros.is_empty() { "never 0" } else { NEVER };
    zero_where(zeros(found), open(found)).unwrap_or_else(|| none.into())
}

/// The zeros; none where no zero is known.
fn zeros(found: &Boxes) -> Option<Text> {
    let names = names(found);
    let zero = |zero: &BoxZero| match zero.exact() {
        Some(turns) => {
            let each = names.iter().zip(&turns);
            Text::joined(each.map(|(name, turn)| Text::label(format!("{name} ≡ {}", typeset::angle(turn)))), " and ")
        }
        None => Text::joined(names.iter().zip(zero.near).map(|(name, turns)| near(name, 360.0 * turns)), " and "),
    };
    let is_meant = |zero: &&BoxZero| {
        let times = [0, 1].map(|place| {
            let mut times = [BigRational::zero(), BigRational::zero()];
            times[place] = found.times[place].clone();
            times
        });
        let places = match zero.exact() {
            Some(turns) => [0, 1].map(|place| Place::exact(&times[place], turns[place].turns())),
            None => [0, 1].map(|place| Place::near(&times[place], 360.0 * zero.near[place])),
        };
        is_in_range(&places)
    };
    alternatives(found.zeros.iter().filter(is_meant).map(zero))
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
    let lead = text::boxes(s, t, found.count(), found.zeros.len());
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
    let none = BigRational::zero();
    [unknowns(&found.times[0], &none), unknowns(&none, &found.times[1])]
}
