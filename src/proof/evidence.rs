//! Do numbers agree with the verdicts that stand beside them?
//!
//! The documents of loads, comparisons and sweeps hold documents of verdicts under `evidence`, which are checked as any.
//! All else in those of loads and comparisons is numbers with their labels: a 0 is compared with the verdicts, which alone say what is zero.

use serde::de::DeserializeOwned;
use serde::{Deserialize, Serialize, Serializer};
use serde_json::Value;

use super::audit::{Audit, Fault};
use super::checked::Checked;
use super::decimals::Decimal;
use super::document::Document;
use super::document_check::judge;
use super::engine::{Quantity, Sense};
use super::judged::Judged;
use super::outside;
use super::reading::{Format, Unreadable, typed};
use super::shape::{Shape, ShapeClaim};

/// Numbers with verdicts as their evidence: the JSON document of `loads`, `compare` or `sweep`.
#[derive(Clone, Debug, PartialEq)]
pub struct EvidenceDocument {
    /// Which of the three it is.
    pub format: Format,
    /// The verdicts: on the one engine of `loads`, on each of `compare`, on some of `sweep`.
    pub evidence: Vec<Document>,
    /// All of the document.
    tree: Value,
}

impl Serialize for EvidenceDocument {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        self.tree.serialize(serializer)
    }
}

/// One order of force or moment in `loads`.
#[derive(Deserialize)]
struct LoadsOrder {
    quantity: Quantity,
    order: u32,
    direct: Amplitude,
    reverse: Amplitude,
}

/// One order of the torque.
#[derive(Deserialize)]
struct LoadsTorque {
    order: u32,
    amplitude: Option<Decimal>,
}

#[derive(Deserialize)]
struct Amplitude {
    amplitude: Option<Decimal>,
}

#[derive(Deserialize)]
struct Loads {
    title: String,
    orders: Vec<LoadsOrder>,
    torque: Vec<LoadsTorque>,
}

#[derive(Deserialize)]
struct Compared {
    orders: Vec<u32>,
    engines: Vec<ComparedEngine>,
}

#[derive(Deserialize)]
struct ComparedEngine {
    title: String,
    orders: Vec<ComparedOrder>,
}

#[derive(Deserialize)]
struct ComparedOrder {
    order: u32,
    force: ComparedAmount,
    moment: ComparedAmount,
}

#[derive(Deserialize)]
struct ComparedAmount {
    largest: Option<Decimal>,
}

impl EvidenceDocument {
    pub(super) fn read(format: Format, tree: Value) -> Result<Self, Unreadable> {
        outside::check(format, &tree)?;
        let list = tree.get("evidence").and_then(Value::as_array);
        let list = list.ok_or_else(|| Unreadable::Malformed("it has no list `evidence`".to_owned()))?;
        let one = |(index, entry): (usize, &Value)| {
            typed(entry).map_err(|error| Unreadable::Malformed(format!("evidence[{index}]: {error}")))
        };
        let evidence = list.iter().enumerate().map(one).collect::<Result<_, _>>()?;
        Ok(EvidenceDocument { format, evidence, tree })
    }

    /// Its title, or that of its first engine.
    pub(super) fn title(&self) -> &str {
        let own = self.tree.get("title").and_then(Value::as_str);
        own.or_else(|| self.evidence.first().map(|document| document.title.as_str())).unwrap_or_default()
    }

    /// Checks the evidence, and what the rest repeats of it.
    pub(super) fn check(&self) -> Result<Checked, Fault> {
        let audit = Audit::new();
        let mut judged = Vec::new();
        for (index, document) in self.evidence.iter().enumerate() {
            let inside = |fault: Fault| Fault { place: format!("evidence[{index}].{}", fault.place), ..fault };
            judged.push(judge(document, &audit).map_err(inside)?);
        }
        match (self.format, &judged[..]) {
            (Format::Loads, [only]) => check_loads(&self.rest()?, &self.evidence[0], only)?,
            (Format::Loads, _) => return Err(Fault::new("evidence", "loads are those of one engine")),
            (Format::Compare, _) => self.check_compared(&self.rest()?)?,
            (_, []) => return Err(Fault::new("evidence", "the list is empty, there is nothing to check")),
            _ => (),
        }
        Ok(Checked::evidence(self.format, &self.evidence, audit.counts()))
    }

    fn rest<T: DeserializeOwned>(&self) -> Result<T, Fault> {
        T::deserialize(&self.tree).map_err(|error| Fault::new("the numbers", error.to_string()))
    }

    fn check_compared(&self, compared: &Compared) -> Result<(), Fault> {
        if compared.engines.is_empty() || compared.engines.len() != self.evidence.len() {
            return Err(Fault::new("evidence", "a comparison has one document for each of its engines"));
        }
        for (index, (engine, document)) in compared.engines.iter().zip(&self.evidence).enumerate() {
            let at = |key: &str| format!("engines[{index}].{key}");
            check_title(at("title"), &engine.title, document)?;
            let told: Vec<u32> = engine.orders.iter().map(|entry| entry.order).collect();
            if told != document.orders || told != compared.orders {
                return Err(Fault::new(at("orders"), "these are not the orders of the evidence"));
            }
            for (place, entry) in engine.orders.iter().enumerate() {
                for (quantity, said) in [(Quantity::Force, &entry.force), (Quantity::Moment, &entry.moment)] {
                    let is_it = |claim: &&ShapeClaim| (claim.quantity, claim.order) == (quantity, entry.order);
                    let shape = document.shapes.iter().find(is_it).map(|claim| claim.shape);
                    let is_zero = match shape {
                        Some(Shape::Balanced | Shape::DoesNotExist) => Some(Some(true)),
                        Some(Shape::NotDecided) => Some(None),
                        Some(Shape::Rotating | Shape::CounterRotating | Shape::Planar | Shape::Elliptical) => {
                            Some(Some(false))
                        }
                        None => None,
                    };
                    agrees(at(&format!("orders[{place}].{}.largest", quantity.name())), said.largest, is_zero)?;
                }
            }
        }
        Ok(())
    }
}

fn check_title(place: String, title: &str, document: &Document) -> Result<(), Fault> {
    if title == document.title { Ok(()) } else { Err(Fault::new(place, "it is not the title of the evidence")) }
}

/// A size is 0 exactly where the evidence proves that it is; where that is not decided any number may stand.
#[expect(clippy::float_cmp, reason = "0 is written for what is proved to be zero, and for nothing else")]
fn agrees(place: String, size: Option<Decimal>, is_zero: Option<Option<bool>>) -> Result<(), Fault> {
    match is_zero {
        None => Err(Fault::new(place, "the evidence says nothing of it")),
        Some(Some(is_zero)) if is_zero != (size == Some(0.0)) => {
            Err(Fault::new(place, "it is not what the evidence says"))
        }
        Some(_) => Ok(()),
    }
}

/// Every order of the evidence has its numbers, those of force and moment together.
fn check_loads(loads: &Loads, evidence: &Document, judged: &[Judged]) -> Result<(), Fault> {
    check_title("title".to_owned(), &loads.title, evidence)?;
    let find =
        |quantity: Quantity, order: u32| judged.iter().find(|one| (one.quantity, one.order) == (quantity, order));
    for (index, entry) in loads.orders.iter().enumerate() {
        let at = |key: &str| format!("orders[{index}].{key}");
        let found = find(entry.quantity, entry.order).filter(|one| one.quantity.senses().len() == 2);
        let of = |sense: Sense| found.and_then(|one| one.place(Some(sense)).map(|place| one.vanishes(place)));
        agrees(at("direct.amplitude"), entry.direct.amplitude, of(Sense::Direct))?;
        agrees(at("reverse.amplitude"), entry.reverse.amplitude, of(Sense::Reverse))?;
    }
    for (index, entry) in loads.torque.iter().enumerate() {
        let found = find(Quantity::Torque, entry.order).map(|one| one.vanishes(0));
        agrees(format!("torque[{index}].amplitude"), entry.amplitude, found)?;
    }
    let of = |quantity: Quantity| -> Vec<u32> {
        loads.orders.iter().filter(|entry| entry.quantity == quantity).map(|entry| entry.order).collect()
    };
    let (force, moment) = (of(Quantity::Force), of(Quantity::Moment));
    let torque: Vec<u32> = loads.torque.iter().map(|entry| entry.order).collect();
    let mut all = [&force[..], &torque].concat();
    all.sort_unstable();
    all.dedup();
    let rise = |orders: &[u32]| orders.windows(2).all(|pair| pair[0] < pair[1]);
    if force != moment || all != evidence.orders || !rise(&force) || !rise(&torque) {
        return Err(Fault::new("orders", "these are not the orders of the evidence, each once"));
    }
    Ok(())
}
