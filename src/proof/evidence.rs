//! Do numbers agree with the verdicts that are beside them?
//!
//! The documents of loads and comparisons hold documents of verdicts under `evidence`, which are checked as any.
//! All else in those of loads and comparisons is numbers with their labels: a 0 is compared with the verdicts, which alone say what is zero.

use std::collections::BTreeSet;

use serde::{Serialize, Serializer};
use serde_json::Value;

use super::audit::{Audit, Fault};
use super::checked::Checked;
use super::decimals::{Decimal, Size};
use super::document::Document;
use super::document_check::judge;
use super::engine::Masses;
use super::judged::Judged;
use super::outside::{Compared, Comparison, Effect, Loads, LoadsTorque, Vector};
use super::quantity::{Quantity, Sense};
use super::reading::{Unreadable, typed};
use super::shape::Shape;

/// Numbers with verdicts as their evidence: the JSON document of `loads` or `compare`.
#[derive(Clone, Debug, PartialEq)]
pub struct EvidenceDocument {
    /// The verdicts: on the one engine of `loads`, on each of `compare`.
    pub evidence: Vec<Document>,
    outside: Outside,
    /// All of the document.
    tree: Value,
}

/// What stands outside of the evidence.
#[derive(Clone, Debug, PartialEq)]
enum Outside {
    Loads(Box<Loads>),
    Comparison(Comparison),
}

impl Serialize for EvidenceDocument {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        self.tree.serialize(serializer)
    }
}

impl EvidenceDocument {
    pub(super) fn of_loads(tree: Value) -> Result<Self, Unreadable> {
        Self::read(Outside::Loads(Box::new(typed(&tree)?)), tree)
    }

    pub(super) fn of_comparison(tree: Value) -> Result<Self, Unreadable> {
        Self::read(Outside::Comparison(typed(&tree)?), tree)
    }

    fn read(outside: Outside, tree: Value) -> Result<Self, Unreadable> {
        let list = tree.get("evidence").and_then(Value::as_array);
        let list = list.ok_or_else(|| Unreadable::Malformed("it has no list `evidence`".to_owned()))?;
        let one = |(index, entry): (usize, &Value)| {
            typed(entry).map_err(|error| Unreadable::Malformed(format!("evidence[{index}]: {error}")))
        };
        let evidence = list.iter().enumerate().map(one).collect::<Result<_, _>>()?;
        Ok(EvidenceDocument { evidence, outside, tree })
    }

    /// Its title, or that of its first engine.
    pub(super) fn title(&self) -> &str {
        let own = self.tree.get("title").and_then(Value::as_str);
        own.or_else(|| self.evidence.first().map(|document| document.title.as_str())).unwrap_or_default()
    }

    /// Checks the evidence, and what the rest says beside it.
    pub(super) fn check(&self) -> Result<Checked, Fault> {
        let audit = Audit::new();
        let mut judged = Vec::new();
        for (index, document) in self.evidence.iter().enumerate() {
            let inside = |fault: Fault| Fault { place: format!("evidence[{index}].{}", fault.place), ..fault };
            judged.push(judge(document, &audit).map_err(inside)?);
        }
        match (&self.outside, &judged[..]) {
            (Outside::Loads(loads), [only]) => check_loads(loads, &self.evidence[0], only)?,
            (Outside::Loads(_), _) => return Err(Fault::new("evidence", "loads are those of one engine")),
            (Outside::Comparison(comparison), _) => check_comparison(comparison, &self.evidence)?,
        }
        Ok(Checked::evidence(&self.evidence, audit.counts()))
    }
}

/// Every order of the evidence has its numbers: those of the force, the same of the moment, those of the torque.
fn check_loads(loads: &Loads, evidence: &Document, judged: &[Judged]) -> Result<(), Fault> {
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
    if effects.len() < loads.effects.len() {
        return Err(Fault::new("effects", "an effect is here twice"));
    }
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

fn check_comparison(comparison: &Comparison, evidence: &[Document]) -> Result<(), Fault> {
    if comparison.engines.is_empty() || comparison.engines.len() != evidence.len() {
        return Err(Fault::new("evidence", "a comparison has one document for each of its engines"));
    }
    for (index, (engine, document)) in comparison.engines.iter().zip(evidence).enumerate() {
        let at = |key: &str| format!("engines[{index}].{key}");
        check_title(&at("title"), &engine.title, document)?;
        check_compared(&at, engine, document)?;
        if document.orders != comparison.orders {
            return Err(Fault::new("orders", "these are not the orders of the evidence"));
        }
    }
    Ok(())
}

fn check_compared(at: &dyn Fn(&str) -> String, engine: &Compared, evidence: &Document) -> Result<(), Fault> {
    let right = |key: &str, orders: Vec<u32>| match orders == evidence.orders {
        true => Ok(()),
        false => Err(Fault::new(at(key), "these are not the orders of the evidence")),
    };
    right("orders", engine.orders.iter().map(|entry| entry.order).collect())?;
    if let Some(newtons) = &engine.newtons {
        right("newtons", newtons.iter().map(|entry| entry.order).collect())?;
    }
    let is_zero = |quantity: Quantity, order: u32| {
        let claim = evidence.shapes.iter().find(|claim| (claim.quantity, claim.order) == (quantity, order));
        claim.map(|claim| matches!(claim.shape, Shape::Balanced | Shape::DoesNotExist))
    };
    let agrees_with = |at: String, quantity: Quantity, order: u32, size: Size, is_at_rest: bool| {
        let is_zero = is_zero(quantity, order);
        let is_zero = is_zero.ok_or_else(|| Fault::new(at.clone(), "the evidence says nothing of it"))?;
        agrees(&at, size, is_zero || is_at_rest)
    };
    for (place, entry) in engine.orders.iter().enumerate() {
        for (quantity, said) in [(Quantity::FORCE, &entry.force), (Quantity::MOMENT, &entry.moment)] {
            let at = at(&format!("orders[{place}].{}.largest", quantity.name()));
            let has_several = evidence.wholes.iter().any(|one| (one.quantity, one.order) == (quantity, entry.order));
            match said.largest {
                Some(size) if !has_several || size.is_nothing() => agrees_with(at, quantity, entry.order, size, false)?,
                None if has_several && is_zero(quantity, entry.order) == Some(false) => {}
                Some(_) | None => {
                    return Err(Fault::new(at, "it is null where several sums are not zero, and only there"));
                }
            }
        }
    }
    let newtons = engine.newtons.as_deref().unwrap_or_default();
    let is_at_rest = newtons.iter().all(|entry| entry.force.is_nothing() && entry.moment.is_nothing());
    for (place, entry) in newtons.iter().enumerate() {
        for (quantity, size) in [(Quantity::FORCE, entry.force), (Quantity::MOMENT, entry.moment)] {
            let at = at(&format!("newtons[{place}].{}", quantity.name()));
            agrees_with(at, quantity, entry.order, size, is_at_rest)?;
        }
    }
    Ok(())
}

fn check_title(place: &str, title: &str, document: &Document) -> Result<(), Fault> {
    if title == document.title { Ok(()) } else { Err(Fault::new(place, "it is not the title of the evidence")) }
}

/// A size is 0 exactly where the evidence proves that it is.
fn agrees(place: &str, size: Size, is_zero: bool) -> Result<(), Fault> {
    match size.is_nothing() == is_zero {
        true => Ok(()),
        false => Err(Fault::new(place, "it is not what the evidence says")),
    }
}
