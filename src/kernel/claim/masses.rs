//! Is it true, what is said about other masses than the pistons: rotating ones, counterweights, bearings, the crankshaft?

use num_traits::{Signed, Zero};

use super::answer::{Answer, Status};
use super::compare::half_width;
use super::finding::Finding;
use super::statement::{Tolerance, Value};
use crate::engine::Engine;
use crate::loads::{self, BearingLoads, Method};
use crate::order::{self, Masses};
use crate::proof::Quantity;
use crate::verdict::{self, OrderBalance, OrderVerdict};

/// Peaks that differ by less than this part are alike: the roundings of their decimals could not tell them apart.
const ALIKE: f64 = 1e-12;

/// One order of these masses, the sums of other masses in multiples of m r c_k as those of the pistons.
pub(super) fn judged(engine: &Engine, order: u32, masses: Masses) -> Result<OrderVerdict, String> {
    if masses != Masses::Reciprocating {
        order::comparable(engine).map_err(|missing| missing.to_string())?;
    }
    let judged = verdict::classify(engine, &[order], masses, &Quantity::PLANAR).map_err(|number| number.to_string())?;
    judged.into_iter().next().ok_or("no order".to_owned())
}

/// The one sum that the order is, where it is one. Order 1 of centric rods and of links is, whatever the rods are, and an order that does not exist.
pub(super) fn one_sum(engine: &Engine, whole: &OrderVerdict, masses: Masses) -> Option<OrderBalance> {
    match masses {
        // A crank that turns faster has not every order.
        _ if engine.faster_crank().is_some() && whole.exists() => only(&whole.parts),
        Masses::Reciprocating if whole.parts.len() > 1 && whole.exists() => None,
        Masses::Reciprocating => whole.parts.first().cloned(),
        Masses::Rotating | Masses::Counterweights | Masses::All => only(&whole.parts),
    }
}

/// The only part that has terms; what nothing is left of counts for nothing in the others, and so does a multiple of 0.
fn only(parts: &[OrderBalance]) -> Option<OrderBalance> {
    let has_terms = |part: &OrderBalance| {
        let verdicts = [part.force.verdicts(), part.moment.verdicts()].concat();
        verdicts.iter().any(|verdict| !verdict.sum.collected().is_empty())
    };
    let (with, without): (Vec<_>, Vec<_>) = parts.iter().partition(|part| part.exists && has_terms(part));
    match with.as_slice() {
        [only] => Some(OrderBalance { class: None, ..(*only).clone() }),
        [] => {
            let nothing = without.into_iter().max_by_key(|part| !has_terms(part))?;
            Some(OrderBalance { exists: nothing.exists || !has_terms(nothing), class: None, ..nothing.clone() })
        }
        _ => None,
    }
}

/// One order of the pistons, which have one coefficient.
pub(super) fn pistons(engine: &Engine, order: u32) -> Option<OrderBalance> {
    one_sum(engine, &judged(engine, order, Masses::Reciprocating).ok()?, Masses::Reciprocating)
}

/// Answers a claim about the crankshaft's mass, of several crankshafts about that of all.
pub(super) fn crankshaft(engine: &Engine, value: &Value) -> Answer {
    let Some(mass) = engine.crankshaft_mass() else {
        return Answer::nothing("the mass of the crankshaft needs the masses and the crank radius");
    };
    let Some(claimed) = value.form.as_rational() else { return Answer::nothing("a mass is a rational number") };
    let off = (&mass - &claimed).abs();
    let status = match &value.tolerance {
        _ if off.is_zero() => Status::True,
        Tolerance::Within(within) if off <= *within => Status::True,
        Tolerance::Part(part) if off <= part * &claimed => Status::True,
        Tolerance::Exact { rounding: Some(half) } if off <= *half => Status::TrueAsRounded,
        _ => Status::False,
    };
    Answer { status, finding: Finding::Mass(mass, engine.crankshafts()), evidence: Vec::new() }
}

/// Answers a claim about which main bearings feel the most: each of them more than any that is not named. Whether those
/// named feel alike is not claimed.
pub(super) fn worst_bearings(engine: &Engine, claimed: &[usize]) -> Answer {
    of_bearings(engine, |loads| {
        if let Some(none) = claimed.iter().find(|number| **number > loads.bearings.len()) {
            return Err(format!("there is no main bearing {none}"));
        }
        let is_named = |index: &usize| claimed.contains(&(index + 1));
        let (named, others): (Vec<usize>, Vec<usize>) = (0..loads.bearings.len()).partition(is_named);
        let peaks = |of: Vec<usize>| of.into_iter().map(|index| loads.bearings[index].peak.value);
        let least = peaks(named).fold(f64::INFINITY, f64::min);
        let most = peaks(others).fold(0.0, f64::max);
        Ok(Status::of(least > most * (1.0 + ALIKE)))
    })
}

/// Answers a claim about that force: decimals, which are compared within the tolerance or the digits given.
pub(super) fn bearing_load(engine: &Engine, value: &Value) -> Answer {
    of_bearings(engine, |loads| {
        let peak = loads.worst.first().map_or(0.0, |index| loads.bearings[*index].peak.value);
        let peak = match (&loads.scale, value.unit) {
            (Some(scale), Some(_)) => peak * scale.force(),
            (None, Some(_)) => return Err("a value in N needs the masses, the crank radius and the speed".to_owned()),
            (_, None) => peak,
        };
        decimal(value, peak)
    })
}

/// Whether a largest load is the claimed one, within the tolerance or the digits given.
pub(super) fn decimal(value: &Value, peak: f64) -> Result<Status, String> {
    let claimed = value.form.to_float();
    let lack = "the largest load is known in decimals: give decimals, or give a tolerance";
    let within = half_width(value).ok_or(lack)?;
    Ok(Status::of((claimed - peak).abs() <= within))
}

/// Solves the main bearings at the orders of the layout file, and judges.
fn of_bearings(engine: &Engine, judge: impl Fn(&BearingLoads) -> Result<Status, String>) -> Answer {
    let loads = loads::bearing_loads(engine, &loads::usual_bearing_orders(engine), Method::Continuous);
    match loads.map_err(|missing| missing.to_string()).and_then(|loads| Ok((judge(&loads)?, loads))) {
        Err(reason) => Answer::nothing(reason),
        Ok((status, loads)) => Answer { status, finding: Finding::Bearings(Box::new(loads)), evidence: Vec::new() },
    }
}
