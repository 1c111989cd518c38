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
use crate::verdict::{self, Balance, OrderBalance};

/// Peaks that differ by less than this part are alike: the roundings of their decimals could not tell them apart.
const ALIKE: f64 = 1e-12;

/// One order of the force and the moment: of the pistons, which all have one coefficient, or of other masses.
pub(super) fn balance_of(engine: &Engine, order: u32, masses: Masses) -> Result<OrderBalance, String> {
    match masses {
        Masses::Reciprocating => pistons(engine, order).ok_or_else(|| "no order".to_owned()),
        Masses::Rotating | Masses::Counterweights | Masses::All => balance(engine, order, masses),
    }
}

/// One order of the pistons, which have one coefficient.
pub(super) fn pistons(engine: &Engine, order: u32) -> Option<OrderBalance> {
    let quantities = [Quantity::FORCE, Quantity::MOMENT];
    let judged = verdict::classify(engine, &[order], Masses::Reciprocating, &quantities).ok()?;
    judged.into_iter().flat_map(|verdict| verdict.parts).next()
}

/// One order of the force and the moment of these masses, in multiples of m r c_k as that of the pistons.
fn balance(engine: &Engine, order: u32, masses: Masses) -> Result<OrderBalance, String> {
    order::comparable(engine).map_err(|missing| missing.to_string())?;
    let judged = verdict::classify(engine, &[order], masses, &Quantity::PLANAR);
    let judged = judged.map_err(|number| number.to_string())?;
    let parts = judged.into_iter().flat_map(|verdict| verdict.parts);
    let has_terms = |part: &OrderBalance| {
        let verdicts = [&part.force, &part.moment].into_iter().flat_map(Balance::verdicts);
        verdicts.into_iter().any(|verdict| !verdict.sum.collected().is_empty())
    };
    // What nothing is left of counts for nothing in the others, and so does what stands before 0.
    let counts = |part: &OrderBalance| part.exists && has_terms(part);
    let (mut with, without): (Vec<OrderBalance>, Vec<OrderBalance>) = parts.partition(counts);
    match (with.pop(), with.is_empty()) {
        (Some(only), true) => Ok(OrderBalance { class: None, ..only }),
        (None, _) => {
            let nothing = without.into_iter().max_by_key(|part| !has_terms(part));
            let exists = |part: &OrderBalance| part.exists || !has_terms(part);
            nothing.map(|part| OrderBalance { exists: exists(&part), class: None, ..part }).ok_or("no order".into())
        }
        _ => Err("the masses have more than one coefficient".to_owned()),
    }
}

/// Answers a claim about the crankshaft's mass.
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
    Answer { status, finding: Finding::Mass(mass), evidence: Vec::new() }
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
        Err(reason) => Answer::nothing(&reason),
        Ok((status, loads)) => Answer { status, finding: Finding::Bearings(Box::new(loads)), evidence: Vec::new() },
    }
}
