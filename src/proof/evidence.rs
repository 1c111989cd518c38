//! Do numbers agree with the verdicts that are beside them?
//!
//! The documents of loads and comparisons hold documents of verdicts under `evidence`, which are checked as any.
//! All else in those of loads and comparisons is numbers with their labels: a 0 is compared with the verdicts, which alone say what is zero.

use serde::{Serialize, Serializer};
use serde_json::Value;

use super::audit::{Audit, Fault};
use super::checked::Checked;
use super::decimals::Decimal;
use super::document::Document;
use super::document_check::judge;
use super::judged::Judged;
use super::outside::{Compared, Comparison, Loads};
use super::quantity::{Quantity, Sense};
use super::reading::{Unreadable, typed};
use super::shape::{Shape, ShapeClaim};

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
    let find =
        |quantity: Quantity, order: u32| judged.iter().find(|one| (one.quantity, one.order) == (quantity, order));
    // In newtons all is 0 of an engine at rest, in multiples of m r ω² it is not.
    let is_at_rest = loads.scale.as_ref().is_some_and(|scale| is_nothing(scale.m_r_omega_squared_n));
    for (index, entry) in loads.orders.iter().enumerate() {
        let at = |key: &str| format!("orders[{index}].{key}");
        let found = find(entry.quantity, entry.order);
        let of = |sense: Sense| {
            let place = found.and_then(|one| one.place(Some(sense)).map(|place| one.vanishes(place)));
            place.ok_or_else(|| Fault::new(at("order"), "the evidence says nothing of it"))
        };
        let [direct, reverse] = [of(Sense::Direct)?, of(Sense::Reverse)?].map(|is_zero| is_zero == Some(true));
        agrees(&at("direct.amplitude"), entry.direct.amplitude, direct || is_at_rest)?;
        agrees(&at("reverse.amplitude"), entry.reverse.amplitude, reverse || is_at_rest)?;
        agrees(&at("largest"), entry.largest, direct && reverse || is_at_rest)?;
        agrees(&at("dimensionless"), entry.dimensionless, direct && reverse)?;
    }
    for (index, entry) in loads.torque.iter().enumerate() {
        let at = |key: &str| format!("torque[{index}].{key}");
        let found = find(Quantity::TORQUE, entry.order).map(|one| one.vanishes(0));
        let found = found.ok_or_else(|| Fault::new(at("order"), "the evidence says nothing of it"))?;
        agrees(&at("amplitude"), entry.amplitude, found == Some(true) || is_at_rest)?;
        agrees(&at("dimensionless"), entry.dimensionless, found == Some(true))?;
    }
    let said: Vec<(Quantity, u32)> = loads.orders.iter().map(|entry| (entry.quantity, entry.order)).collect();
    let shaking: Vec<u32> =
        said.iter().filter(|(quantity, _)| *quantity == Quantity::FORCE).map(|(_, order)| *order).collect();
    let torque: Vec<u32> = loads.torque.iter().map(|entry| entry.order).collect();
    let of = |quantity: Quantity| shaking.iter().map(move |order| (quantity, *order));
    let mut all = [&shaking[..], &torque].concat();
    all.sort_unstable();
    all.dedup();
    let rise = |orders: &[u32]| orders.windows(2).all(|pair| pair[0] < pair[1]);
    let are_due = said.into_iter().eq(of(Quantity::FORCE).chain(of(Quantity::MOMENT)));
    if !are_due || all != evidence.orders || !rise(&shaking) || !rise(&torque) {
        return Err(Fault::new("orders", "these are not the orders of the evidence, force and then moment, each once"));
    }
    Ok(())
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
    for (place, entry) in engine.orders.iter().enumerate() {
        for (quantity, said) in [(Quantity::FORCE, &entry.force), (Quantity::MOMENT, &entry.moment)] {
            let at = at(&format!("orders[{place}].{}.largest", quantity.name()));
            let is_it = |claim: &&ShapeClaim| (claim.quantity, claim.order) == (quantity, entry.order);
            let claim = evidence.shapes.iter().find(is_it);
            let claim = claim.ok_or_else(|| Fault::new(at.clone(), "the evidence says nothing of it"))?;
            let is_zero = matches!(claim.shape, Shape::Balanced | Shape::DoesNotExist);
            // Null where several sums make up the order.
            agrees(&at, said.largest.unwrap_or(Decimal::INFINITY), is_zero)?;
        }
    }
    Ok(())
}

fn check_title(place: &str, title: &str, document: &Document) -> Result<(), Fault> {
    if title == document.title { Ok(()) } else { Err(Fault::new(place, "it is not the title of the evidence")) }
}

/// A size is 0 exactly where the evidence proves that it is.
fn agrees(place: &str, size: Decimal, is_zero: bool) -> Result<(), Fault> {
    match is_nothing(size) == is_zero {
        true => Ok(()),
        false => Err(Fault::new(place, "it is not what the evidence says")),
    }
}

/// 0 is written for what is proved to be zero, and for nothing else.
fn is_nothing(size: Decimal) -> bool {
    size == 0.0
}
