//! What are the weights of a remedy called, and how are their sizes written?

use super::super::typeset::{Amount, Bearing};
use crate::numbers;
use crate::order::Factor;
use crate::proof::Sense;
use crate::remedy::{Kind, Remedy, Shaft, Weight};

/// A weight and the part of the remedy that it belongs to.
pub(super) struct Part<'a> {
    /// Of the remedy.
    pub name: String,
    /// The weight.
    pub weight: &'a Weight,
}

/// All weights, in the order of [`Remedy::weights`].
pub(super) fn parts(remedy: &Remedy) -> Vec<Part<'_>> {
    let bays = remedy.bays.iter().map(|weight| Part { name: "counterweight of a bay".into(), weight });
    let crankshaft = remedy
        .crankshaft
        .iter()
        .flat_map(|shaft| shaft.weights.iter().map(|weight| Part { name: "counterweight".into(), weight }));
    let shafts = remedy.shafts.iter().enumerate().flat_map(|(index, shaft)| {
        let name = format!("{}, shaft {}", shaft_name(shaft), index + 1);
        shaft.weights.iter().map(move |weight| Part { name: name.clone(), weight })
    });
    bays.chain(crankshaft).chain(shafts).collect()
}

fn shaft_name(shaft: &Shaft) -> &'static str {
    match (shaft.lanchester, shaft.kind) {
        (true, _) => "Lanchester pair",
        (false, Kind::Force) => "one weight",
        (false, Kind::Couple) => "couple",
        (false, Kind::ForceAndMoment) => "two weights",
    }
}

/// `1×, with the crank`.
pub(super) fn speed(weight: &Weight) -> String {
    let sense = if weight.sense == Sense::Direct { "with" } else { "against" };
    format!("{}×, {sense} the crank", weight.order)
}

/// Letters of the longest closed form of a mass-radius that is shown.
const LONGEST_FORM: usize = 24;

/// The mass-radius in multiples of m r or of m r |c_k|: `= √3/4 ≈ 0.4330 m r`.
pub(super) fn size(remedy: &Remedy, weight: &Weight) -> String {
    // A form whose digits only repeat those of the layout's masses and lengths says nothing more than its decimals.
    let exact = weight.modulus().filter(|form| form.to_string().chars().count() <= LONGEST_FORM);
    let amount = |decimal: f64| Amount { exact: exact.clone(), decimal }.plain();
    match (weight.vector.only(), weight.decimals(&remedy.subject)) {
        (Some((Factor::One, sum)), _) => format!("{} m r", amount(numbers::evaluate(sum).norm())),
        (Some((_, sum)), _) => format!("{} m r |c_{}|", amount(numbers::evaluate(sum).norm()), weight.order),
        (None, Some([size, _])) => format!("{} m r", amount(size)),
        (None, None) => format!("depends on c_{}", weight.order),
    }
}

/// The direction at θ = 0.
pub(super) fn direction(remedy: &Remedy, weight: &Weight) -> String {
    let exact = weight.direction();
    let of_sum = || {
        let (factor, sum) = weight.vector.only()?;
        let value = numbers::evaluate(sum);
        let value = if factor.is_negative(weight.order)? { -value } else { value };
        Some(numbers::degrees(value))
    };
    let of_value = weight.decimals(&remedy.subject).map(|[_, degrees]| degrees);
    let Some(decimal) = of_value.or_else(of_sum) else { return format!("depends on c_{}", weight.order) };
    Bearing { exact, decimal }.plain()
}
