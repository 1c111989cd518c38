//! Do the numbers of `loads` agree with the verdicts beside them, and with each other?

use std::collections::BTreeSet;

use super::agreement::{agrees, check_title};
use super::audit::{Fault, refuse_if};
use super::decimals::{Decimal, Size};
use super::document::Document;
use super::engine::Masses;
use super::judged::Judged;
use super::outside::{Effect, Loads, LoadsTorque, Vector};
use super::quantity::{Quantity, Sense};

/// Every order of the evidence has its numbers: those of the force, the same of the moment, those of the torque.
pub(super) fn check_loads(loads: &Loads, evidence: &Document, judged: &[Judged]) -> Result<(), Fault> {
    check_title("title", &loads.title, evidence)?;
    let is_at_rest = check_scale(loads)?;
    let find = |quantity: Quantity, order: u32| {
        let found = judged.iter().find(|one| (one.quantity, one.order) == (quantity, order));
        found.ok_or("the evidence says nothing of it")
    };
    // The quantities of which something is left in the orders that are listed.
    let mut left = BTreeSet::new();
    for (index, entry) in loads.orders.iter().enumerate() {
        let at = |key: &str| format!("orders[{index}].{key}");
        let found = find(entry.quantity, entry.order).map_err(|why| Fault::new(at("order"), why))?;
        let mut is_zero = true;
        for (key, sense, vector) in
            [("direct", Sense::Direct, &entry.direct), ("reverse", Sense::Reverse, &entry.reverse)]
        {
            let place = found.place(Some(sense)).ok_or_else(|| Fault::new(at(key), "it has no sense"))?;
            check_vector(&at(key), vector, found.vanishes(place), is_at_rest)?;
            is_zero &= found.vanishes(place) == Some(true);
        }
        agrees(&at("largest"), entry.largest, is_zero || is_at_rest)?;
        agrees(&at("dimensionless"), entry.dimensionless, is_zero)?;
        has_no_direction(&at("direction_deg"), is_zero, entry.direction_deg)?;
        for (key, part) in [("smallest", entry.smallest), ("along", entry.along), ("across", entry.across)] {
            if (is_zero || is_at_rest) && !part.is_nothing() {
                return Err(Fault::new(at(key), "it is not what the evidence says"));
            }
        }
        if loads.scale.is_none() && entry.largest != entry.dimensionless {
            return Err(Fault::new(at("largest"), "without a scale it is the same multiple"));
        }
        if !is_zero {
            left.insert(entry.quantity);
        }
    }
    for (name, quantity, entries) in
        [("torque", Quantity::TORQUE, &loads.torque), ("roll", Quantity::ROLL, &loads.roll)]
    {
        for (index, entry) in entries.iter().enumerate() {
            let at = |key: &str| format!("{name}[{index}].{key}");
            let found = find(quantity, entry.order).map_err(|why| Fault::new(at("order"), why))?;
            let is_zero = found.vanishes(0) == Some(true);
            agrees(&at("amplitude"), entry.amplitude, is_zero || is_at_rest)?;
            agrees(&at("dimensionless"), entry.dimensionless, is_zero)?;
            has_no_direction(&at("phase_deg"), is_zero, entry.phase_deg)?;
            if !is_zero {
                left.insert(quantity);
            }
        }
    }
    // Those of which something is left in any order of the evidence.
    let is_left = |one: &&Judged| !(0..one.wholes.len()).all(|sense| one.vanishes(sense) == Some(true));
    let of_all: BTreeSet<Quantity> = judged.iter().filter(is_left).map(|one| one.quantity).collect();
    check_peaks(loads, evidence, is_at_rest, [&left, &of_all])?;
    check_orders(loads, evidence)
}

/// Newtons need a scale, in which all is 0 of an engine at rest; in multiples of m r ω² it is not. Returns whether it is at rest.
fn check_scale(loads: &Loads) -> Result<bool, Fault> {
    if loads.units.are_newtons() != Some(loads.scale.is_some()) {
        return Err(Fault::new("units", "they are newtons where there is a scale, and multiples where there is none"));
    }
    let Some(scale) = &loads.scale else { return Ok(false) };
    let is_at_rest = scale.speed_rpm.is_nothing();
    agrees("scale.mass_kg", scale.mass_kg, false)?;
    agrees("scale.crank_radius_m", scale.crank_radius_m, false)?;
    agrees("scale.angular_speed_rad_s", scale.angular_speed_rad_s, is_at_rest)?;
    agrees("scale.m_r_omega_squared_n", scale.m_r_omega_squared_n, is_at_rest)?;
    Ok(is_at_rest)
}

/// What is zero has no direction, and what is decided no bound.
fn check_vector(place: &str, vector: &Vector, vanishes: Option<bool>, is_at_rest: bool) -> Result<(), Fault> {
    let at = |key: &str| format!("{place}.{key}");
    let is_zero = vanishes == Some(true);
    agrees(&at("amplitude"), vector.amplitude, is_zero || is_at_rest)?;
    has_no_direction(&at("angle_deg"), is_zero, vector.angle_deg)?;
    match vector.below {
        None => Ok(()),
        Some(below) if vanishes.is_none() => agrees(&at("below"), below, is_at_rest),
        Some(_) => Err(Fault::new(at("below"), "what is decided has no bound")),
    }
}

fn has_no_direction(place: &str, is_zero: bool, angle: Option<Decimal>) -> Result<(), Fault> {
    if is_zero && angle.is_some() { Err(Fault::new(place, "what is zero has no direction")) } else { Ok(()) }
}

/// The peaks are those of the listed orders, and the largest of all orders: neither is 0 where something is left in these, of an engine
/// that moves.
fn check_peaks(
    loads: &Loads,
    evidence: &Document,
    is_at_rest: bool,
    [left, left_of_all]: [&BTreeSet<Quantity>; 2],
) -> Result<(), Fault> {
    let (peaks, largest) = (&loads.peaks, &loads.largest);
    let effects: BTreeSet<Effect> = loads.effects.iter().copied().collect();
    refuse_if(effects.len() < loads.effects.len(), Fault::new("effects", "an effect is here twice"))?;
    let is_alone = loads.effects.len() == 1;
    if !effects.contains(&Effect::Reciprocating) || is_alone != (evidence.masses == Masses::Reciprocating) {
        return Err(Fault::new("effects", "these are not those of the masses that the evidence is about"));
    }
    for (quantity, peak, largest, effects) in [
        (Quantity::FORCE, Some(&peaks.force), Some(&largest.force), &loads.effects[..]),
        (Quantity::MOMENT, Some(&peaks.moment), Some(&largest.moment), &loads.effects[..]),
        (Quantity::TORQUE, peaks.torque.as_ref(), largest.inertia_torque.as_ref(), &[]),
    ] {
        let name = quantity.name();
        if peak.is_some() != evidence.quantities.contains(&quantity) || peak.is_none() && largest.is_some() {
            return Err(Fault::new(
                format!("peaks.{name}"),
                "it is here where the evidence is about it, and only there",
            ));
        }
        if let Some(peak) = peak {
            agrees(&format!("peaks.{name}.value"), peak.value, is_at_rest || !left.contains(&quantity))?;
            if !peak.effects.iter().map(|(effect, _)| effect).eq(effects) {
                return Err(Fault::new(format!("peaks.{name}.effects"), "these are not the effects of the loads"));
            }
        }
        let is_wrong = |value: Size| match value.is_nothing() {
            true => !is_at_rest && left_of_all.contains(&quantity),
            false => is_at_rest,
        };
        if largest.is_some_and(|largest| is_wrong(largest.value)) {
            return Err(Fault::new(format!("largest.{name}"), "it is not what the evidence says"));
        }
    }
    Ok(())
}

fn check_orders(loads: &Loads, evidence: &Document) -> Result<(), Fault> {
    let said: Vec<(Quantity, u32)> = loads.orders.iter().map(|entry| (entry.quantity, entry.order)).collect();
    let shaking: Vec<u32> =
        said.iter().filter(|(quantity, _)| *quantity == Quantity::FORCE).map(|(_, order)| *order).collect();
    let orders = |entries: &[LoadsTorque]| entries.iter().map(|entry| entry.order).collect();
    let [torque, roll]: [Vec<u32>; 2] = [orders(&loads.torque), orders(&loads.roll)];
    let numbered: Vec<u32> = loads.coefficients.iter().map(|entry| entry.order).collect();
    let of = |quantity: Quantity| shaking.iter().map(move |order| (quantity, *order));
    let mut all = [&shaking[..], &torque].concat();
    all.sort_unstable();
    all.dedup();
    let rise = |orders: &[u32]| orders.windows(2).all(|pair| pair[0] < pair[1]);
    let are_due = said.into_iter().eq(of(Quantity::FORCE).chain(of(Quantity::MOMENT)));
    if !are_due || all != evidence.orders || !rise(&shaking) || !rise(&torque) {
        return Err(Fault::new("orders", "these are not the orders of the evidence, force and then moment, each once"));
    }
    let of_roll = if evidence.quantities.contains(&Quantity::ROLL) { &torque[..] } else { &[] };
    if roll != of_roll {
        return Err(Fault::new("roll", "it has the orders of the torque where the evidence is about it, else none"));
    }
    if !rise(&numbered) || !numbered.iter().all(|order| shaking.contains(order)) {
        return Err(Fault::new("coefficients", "these are of orders that are listed, rising"));
    }
    match &loads.auto {
        Some(auto) if auto.kept != shaking || auto.torque_kept != torque => {
            Err(Fault::new("auto", "the orders that are kept are those that are listed"))
        }
        Some(auto)
            if auto.dropped.iter().any(|order| shaking.contains(order))
                || auto.torque_dropped.iter().any(|order| torque.contains(order)) =>
        {
            Err(Fault::new("auto", "an order is kept and dropped"))
        }
        Some(_) | None => Ok(()),
    }
}
