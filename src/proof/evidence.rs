//! Do numbers agree with the verdicts that stand beside them?
//!
//! The documents of loads, comparisons and sweeps hold documents of verdicts under `evidence`, which are checked as any.
//! Of all else only what repeats a verdict is compared with it.

use serde::de::DeserializeOwned;
use serde::{Deserialize, Serialize, Serializer};
use serde_json::Value;

use super::audit::{Audit, Fault};
use super::checked::Checked;
use super::document::Document;
use super::document_check::judge;
use super::engine::{Quantity, Sense};
use super::judged::Judged;
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
    vanishes: Option<bool>,
    direct: Said,
    reverse: Said,
}

/// One order of the torque.
#[derive(Deserialize)]
struct LoadsTorque {
    order: u32,
    vanishes: Option<bool>,
}

/// Whether something is zero; null where that is not decided.
#[derive(Deserialize)]
struct Said {
    vanishes: Option<bool>,
}

#[derive(Deserialize)]
struct Loads {
    orders: Vec<LoadsOrder>,
    torque: Vec<LoadsTorque>,
}

#[derive(Deserialize)]
struct Compared {
    engines: Vec<ComparedEngine>,
}

#[derive(Deserialize)]
struct ComparedEngine {
    orders: Vec<ComparedOrder>,
}

#[derive(Deserialize)]
struct ComparedOrder {
    order: u32,
    force: ComparedShape,
    moment: ComparedShape,
}

#[derive(Deserialize)]
struct ComparedShape {
    shape: Shape,
}

impl EvidenceDocument {
    pub(super) fn read(format: Format, tree: Value) -> Result<Self, Unreadable> {
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
            (Format::Loads, [only]) => check_loads(&self.rest()?, only)?,
            (Format::Loads, _) => return Err(Fault::new("evidence", "loads are those of one engine")),
            (Format::Compare, _) => self.check_compared(&self.rest()?)?,
            (_, []) => return Err(Fault::new("evidence", "the list is empty, there is nothing to check")),
            _ => (),
        }
        Ok(Checked::evidence(&self.evidence, audit.counts()))
    }

    fn rest<T: DeserializeOwned>(&self) -> Result<T, Fault> {
        T::deserialize(&self.tree).map_err(|error| Fault::new("the numbers", error.to_string()))
    }

    fn check_compared(&self, compared: &Compared) -> Result<(), Fault> {
        if compared.engines.is_empty() || compared.engines.len() != self.evidence.len() {
            return Err(Fault::new("evidence", "a comparison has one document for each of its engines"));
        }
        for (index, (engine, document)) in compared.engines.iter().zip(&self.evidence).enumerate() {
            for (place, entry) in engine.orders.iter().enumerate() {
                for (quantity, said) in [(Quantity::Force, &entry.force), (Quantity::Moment, &entry.moment)] {
                    let is_it = |claim: &&ShapeClaim| (claim.quantity, claim.order) == (quantity, entry.order);
                    let proved = document.shapes.iter().find(is_it).map(|claim| claim.shape);
                    if proved != Some(said.shape) {
                        let place = format!("engines[{index}].orders[{place}].{}.shape", quantity.name());
                        return Err(Fault::new(place, "it is not the one of the evidence"));
                    }
                }
            }
        }
        Ok(())
    }
}

fn check_loads(loads: &Loads, judged: &[Judged]) -> Result<(), Fault> {
    let find =
        |quantity: Quantity, order: u32| judged.iter().find(|one| (one.quantity, one.order) == (quantity, order));
    let agree = |place: String, said: Option<bool>, proved: Option<Option<bool>>| match proved {
        Some(proved) if proved == said => Ok(()),
        Some(_) => Err(Fault::new(place, "it is not what the evidence says")),
        None => Err(Fault::new(place, "the evidence says nothing of it")),
    };
    for (index, entry) in loads.orders.iter().enumerate() {
        let at = |key: &str| format!("orders[{index}].{key}");
        let found = find(entry.quantity, entry.order).filter(|one| one.quantity.senses().len() == 2);
        let of = |sense: Sense| found.and_then(|one| one.place(Some(sense)).map(|place| one.vanishes(place)));
        let (direct, reverse) = (of(Sense::Direct), of(Sense::Reverse));
        agree(at("direct.vanishes"), entry.direct.vanishes, direct)?;
        agree(at("reverse.vanishes"), entry.reverse.vanishes, reverse)?;
        let both = direct.zip(reverse).map(|both| match both {
            (Some(true), Some(true)) => Some(true),
            (Some(false), _) | (_, Some(false)) => Some(false),
            _ => None,
        });
        agree(at("vanishes"), entry.vanishes, both)?;
    }
    for (index, entry) in loads.torque.iter().enumerate() {
        let found = find(Quantity::Torque, entry.order).map(|one| one.vanishes(0));
        agree(format!("torque[{index}].vanishes"), entry.vanishes, found)?;
    }
    Ok(())
}
