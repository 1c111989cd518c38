//! Do numbers agree with the verdicts that are beside them?
//!
//! The documents of loads and comparisons hold documents of verdicts under `evidence`, which are checked as any.
//! All else in those of loads and comparisons is numbers with their labels: a 0 is compared with the verdicts, which alone say what is zero.

use serde::{Serialize, Serializer};
use serde_json::Value;

use super::agreement::{agrees, check_title};
use super::audit::{Audit, Fault};
use super::checked::Checked;
use super::decimals::Size;
use super::document::Document;
use super::document_check::judge;
use super::loads_check::check_loads;
use super::outside::{Compared, Comparison, Loads};
use super::quantity::Quantity;
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
        if judged.is_empty() {
            return Err(Fault::new(
                "evidence",
                "there is none, so that nothing is proved: its proof was too large, or was taken away",
            ));
        }
        match (&self.outside, &judged[..]) {
            (Outside::Loads(loads), [only]) => check_loads(loads, &self.evidence[0], only)?,
            (Outside::Loads(_), _) => return Err(Fault::new("evidence", "loads are those of one engine")),
            (Outside::Comparison(comparison), _) => check_comparison(comparison, &self.evidence)?,
        }
        Ok(Checked::evidence(&self.evidence, audit.counts()))
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
    let agrees_with = |at: String, quantity: Quantity, order: u32, size: Size| {
        let is_zero = is_zero(quantity, order);
        agrees(&at, size, is_zero.ok_or_else(|| Fault::new(at.clone(), "the evidence says nothing of it"))?)
    };
    for (place, entry) in engine.orders.iter().enumerate() {
        for (quantity, said) in [(Quantity::FORCE, &entry.force), (Quantity::MOMENT, &entry.moment)] {
            let at = at(&format!("orders[{place}].{}.largest", quantity.name()));
            let has_several = evidence.wholes.iter().any(|one| (one.quantity, one.order) == (quantity, entry.order));
            match said.largest {
                Some(size) if !has_several || size.is_nothing() => agrees_with(at, quantity, entry.order, size)?,
                None if has_several && is_zero(quantity, entry.order) == Some(false) => {}
                Some(_) | None => {
                    return Err(Fault::new(at, "it is null where several sums are not zero, and only there"));
                }
            }
        }
    }
    for (place, entry) in engine.newtons.iter().flatten().enumerate() {
        for (quantity, size) in [(Quantity::FORCE, entry.force), (Quantity::MOMENT, entry.moment)] {
            let at = at(&format!("newtons[{place}].{}", quantity.name()));
            agrees_with(at, quantity, entry.order, size)?;
        }
    }
    Ok(())
}
