//! Which weight in decimals stands for one that no layout file can name? Links on a master rod move by numbers without a closed form.

use std::collections::BTreeSet;

use num_bigint::BigInt;
use num_rational::BigRational;

use super::Remedy;
use super::comparable_engine::ComparableEngine;
use super::planes::{ends, usual_planes};
use super::shafts::{shaft, without_slight};
use super::weight::Weight;
use crate::engine::{Draft, Engine, ReferencePlane};
use crate::exact::Turn;
use crate::order::Factor;
use crate::proof::Sense;

/// Decimal places of the directions, in degrees.
const PLACES: u32 = 8;
/// Significant digits of the sizes.
const DIGITS: usize = 11;

/// Whether a weight is multiplied by a number of a link, which no key of a layout file names.
pub(super) fn is_of_link(weight: &Weight) -> bool {
    weight.vector.parts().keys().any(Factor::is_of_link)
}

/// The mass-radius of a weight, in kilogram-metres or else in multiples of m r, and its direction at θ = 0, both rounded to decimals;
/// none where it is beyond them.
pub(super) fn rounded(subject: &ComparableEngine, weight: &Weight) -> Option<(BigRational, Turn)> {
    let [multiple, degrees] = weight.decimals(subject)?;
    let size = to_digits(weight.mass_radius(subject).unwrap_or(multiple))?;
    let steps = (degrees * 10_f64.powi(PLACES as i32)).round();
    let degrees = BigRational::new(BigInt::from(steps as i64), BigInt::from(10).pow(PLACES));
    Some((size, Turn::new(degrees / BigRational::from_integer(360.into()))))
}

/// A decimal of [`DIGITS`] digits, exactly.
fn to_digits(value: f64) -> Option<BigRational> {
    let text = format!("{value:.*e}", DIGITS - 1);
    let (digits, power) = text.split_once('e')?;
    let digits: BigInt = digits.replace('.', "").parse().ok()?;
    let power = power.parse::<i32>().ok()? - (DIGITS as i32 - 1);
    let ten = BigRational::from_integer(BigInt::from(10));
    Some(BigRational::from_integer(digits) * ten.pow(power))
}

/// Whether the engine as it was written leaves less than [`super::LEAST`] of the load of each order whose weights were rounded: a shaft
/// against that would be too slight to be proposed.
pub(super) fn leaves_little(remedy: &Remedy, read: &Engine) -> bool {
    // About the middle: far from it even a slight force has a large moment, and an engine with all cylinders in one plane has no moment to
    // compare that with.
    let draft = Draft { reference_plane: ReferencePlane::Middle, ..read.clone().into_draft() };
    let Ok(read) = draft.build() else { return false };
    let Ok(subject) = ComparableEngine::new(&read) else { return false };
    let (planes, ends) = (usual_planes(&read), ends(&read));
    let weights = remedy.weights();
    let rounded = weights.iter().filter(|weight| is_of_link(weight));
    let rounded: BTreeSet<(u32, Sense)> = rounded.map(|weight| (weight.order, weight.sense)).collect();
    let left = rounded.iter().filter_map(|&(order, sense)| {
        shaft(order, sense, &subject.force(order, sense), &subject.moment(order, sense), &planes, &ends)
    });
    let [needed, _] = without_slight(&subject, left.collect());
    needed.is_empty()
}
