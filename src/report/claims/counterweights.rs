//! Which counterweights do what is claimed to be possible? Their places, masses and angles in a sentence.

use super::super::{residual, typeset};
use crate::claim::{Status, Witness};
use crate::page::{Text, Unit, phrase};
use crate::remedy::Weight;
use crate::report::texts::claims as text;

/// The counterweights that were found, with their masses where the layout gives numbers; that there are none where the claim is not so.
pub(super) fn found(found: &Witness, status: &Status) -> Text {
    let is_undecided = found.crankshaft_mass.is_some() && *status == Status::NotDecided;
    if !status.holds() && !is_undecided {
        return text::no_counterweights();
    }
    let mass = |index: usize| found.masses.as_ref().and_then(|masses| masses.get(index)).copied();
    let each = found.weights.iter().enumerate().map(|(index, weight)| one(weight, mass(index)));
    let told = match found.weights.is_empty() {
        true => text::no_counterweight_needed(),
        false => text::counterweights(Text::joined(each, "; ")),
    };
    match found.crankshaft_mass {
        Some(mass) if is_undecided => text::crankshaft_mass_undecided(told, found.crankshafts == 1, kilograms(mass)),
        Some(mass) => text::crankshaft_mass_then(told, found.crankshafts == 1, kilograms(mass)),
        None => told,
    }
}

fn kilograms(mass: f64) -> Text {
    phrase!("{} {}", Text::measured(mass, Unit::KILOGRAM), Unit::KILOGRAM)
}

fn one(weight: &Weight, mass: Option<f64>) -> Text {
    let at = typeset::number(&weight.position);
    match (mass, weight.vector.only()) {
        (Some(mass), Some((_, sum))) => text::mass_at_angle(at, kilograms(mass), residual::bearing(sum)),
        (Some(mass), None) => text::mass(at, kilograms(mass)),
        (None, Some((_, sum))) => text::mass_radius(at, residual::modulus_of(sum), residual::bearing(sum)),
        (None, None) => text::no_mass(at),
    }
}
