//! What are the weights of a remedy called, and how are their sizes written?

use num_traits::ToPrimitive;

use super::super::typeset::{Amount, Bearing};
use crate::proof::Sense;
use crate::remedy::{Kind, Remedy, Shaft, Weight};

/// A weight and the part of the remedy that it belongs to.
pub(super) struct Part<'a> {
    /// Of the remedy.
    pub name: &'static str,
    /// Whether its shaft makes a Lanchester pair with another.
    pub lanchester: bool,
    /// The weight.
    pub weight: &'a Weight,
}

/// All weights, in the order of [`Remedy::weights`].
pub(super) fn parts(remedy: &Remedy) -> Vec<Part<'_>> {
    let bays = remedy.bays.iter().map(|weight| Part { name: "counterweight of a bay", lanchester: false, weight });
    let crankshaft = remedy
        .crankshaft
        .iter()
        .flat_map(|shaft| shaft.weights.iter().map(|weight| Part { name: "counterweight", lanchester: false, weight }));
    let shafts = remedy.shafts.iter().flat_map(|shaft| {
        shaft.weights.iter().map(move |weight| Part { name: shaft_name(shaft), lanchester: shaft.lanchester, weight })
    });
    bays.chain(crankshaft).chain(shafts).collect()
}

fn shaft_name(shaft: &Shaft) -> &'static str {
    match (shaft.lanchester, shaft.kind) {
        (true, _) => "Lanchester shaft",
        (false, Kind::Force) => "balancer shaft",
        (false, Kind::Couple) => "couple shaft",
        (false, Kind::ForceAndMoment) => "balancer shaft with two weights",
    }
}

/// `1×, with the crank`.
pub(super) fn speed(weight: &Weight) -> String {
    let sense = if weight.sense == Sense::Direct { "with" } else { "against" };
    format!("{}×, {sense} the crank", weight.order)
}

/// What a mass-radius is a multiple of: m r, or m r |c_k|.
pub(super) fn unit(weight: &Weight) -> String {
    match weight.vector.only() {
        Some((Some(rod), _)) if num_traits::Zero::is_zero(&rod.offset) => format!("m r |c_{}|", weight.order),
        Some((Some(_), _)) => format!("m r |c_{}|", weight.order),
        _ => "m r".to_owned(),
    }
}

/// The mass-radius as an amount; in multiples of [`unit`].
pub(super) fn size(remedy: &Remedy, weight: &Weight) -> Amount {
    match weight.vector.only() {
        Some((_, sum)) => Amount { exact: weight.modulus(), decimal: crate::numbers::evaluate(sum).norm() },
        None => Amount {
            exact: weight.modulus(),
            decimal: weight.decimals(&remedy.subject).map_or(f64::NAN, |[size, _]| size),
        },
    }
}

/// The direction at θ = 0; none where it is not known.
pub(super) fn direction(remedy: &Remedy, weight: &Weight) -> Option<Bearing> {
    let exact = weight.direction();
    let decimal = match (weight.decimals(&remedy.subject), &exact, weight.vector.only()) {
        (Some([_, degrees]), ..) => degrees,
        (None, Some(crate::numbers::Direction::Turn(turn)), _) => {
            super::super::typeset::signed_degrees(turn).to_f64().unwrap_or(f64::NAN)
        }
        (None, Some(_), Some((factor, sum))) => {
            let value = crate::numbers::evaluate(sum);
            // The sign of c_k is that of c_2 or of c_4, by turns.
            let value = if factor.is_some() && weight.order % 4 == 0 { -value } else { value };
            value.arg().to_degrees()
        }
        _ => return None,
    };
    Some(Bearing { exact, decimal })
}
