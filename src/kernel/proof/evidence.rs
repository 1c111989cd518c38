//! Do numbers agree with the verdicts that are beside them?
//!
//! The documents of loads and comparisons hold documents of verdicts under `evidence`, which are checked as any.
//! All else in those of loads and comparisons is numbers with their labels: a 0 is compared with the verdicts, which alone say what is zero.

use num_rational::BigRational;
use num_traits::{One, Signed, Zero};
use serde::{Serialize, Serializer};
use serde_json::Value;

use super::agreement::{agrees, check_title};
use super::audit::{Audit, Fault, demand};
use super::checked::Checked;
use super::document::Document;
use super::document_check::judge;
use super::judged::Judged;
use super::loads_check::{check_loads, check_scale};
use super::motion::Motion;
use super::outside::{COMPARE_NOT_CHECKED, Compared, Comparison, Loads};
use super::quantity::Quantity;
use super::reading::{Difference, Unreadable, difference, typed};
use super::sizes::{Length, Swing};

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

    /// The titles of its engines.
    pub(super) fn titles(&self) -> Vec<&str> {
        self.evidence.iter().map(|document| document.title.as_str()).collect()
    }

    /// Where what is said of one of the engines beside the verdicts is not what a layout has, and what both say there.
    pub fn numbers_difference(&self, index: usize, right: &Value) -> Option<Difference> {
        let own = self.tree.get("engines").map_or(&self.tree, |engines| &engines[index]);
        // Read as the document was, so that the last digits are the same.
        let right: Value = serde_json::from_str(&right.to_string()).unwrap_or_default();
        // Where a comparison has no newtons it says nothing of the scale.
        let is_silent = |key: &str| key == "scale" && own[key].is_null() && own.get("newtons").is_some();
        let mut said = ["scale", "units", "position_unit", "firing"].into_iter();
        said.find_map(|key| if is_silent(key) { None } else { difference(key, own.get(key)?, &right[key]) })
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
            (Outside::Loads(loads), [only]) => check_loads(loads, &self.evidence[0], only, &audit)?,
            (Outside::Loads(_), _) => return Err(Fault::new("evidence", "loads are those of one engine")),
            (Outside::Comparison(comparison), _) => check_comparison(comparison, &self.evidence, &judged, &audit)?,
        }
        let outside = match self.outside {
            Outside::Loads(_) => Checked::OUTSIDE_OF_LOADS,
            Outside::Comparison(_) => Checked::OUTSIDE_OF_COMPARISON,
        };
        Ok(Checked::evidence(&self.evidence, outside, audit.counts()))
    }
}

fn check_comparison(
    comparison: &Comparison,
    evidence: &[Document],
    judged: &[Vec<Judged>],
    audit: &Audit,
) -> Result<(), Fault> {
    if comparison.engines.is_empty() || comparison.engines.len() != evidence.len() {
        return Err(Fault::new("evidence", "a comparison has one document for each of its engines"));
    }
    demand(comparison.not_checked == COMPARE_NOT_CHECKED, Fault::new("not_checked", "these are not all, or more"))?;
    for (index, (engine, document)) in comparison.engines.iter().zip(evidence).enumerate() {
        let at = |key: &str| format!("engines[{index}].{key}");
        check_title(&at("title"), &engine.title, document)?;
        check_compared(&at, engine, document, &judged[index], &Motion::new(audit))?;
        if document.orders != comparison.orders {
            return Err(Fault::new("orders", "these are not the orders of the evidence"));
        }
    }
    Ok(())
}

fn check_compared(
    at: &dyn Fn(&str) -> String,
    engine: &Compared,
    evidence: &Document,
    judged: &[Judged],
    motion: &Motion<'_>,
) -> Result<(), Fault> {
    let right = |key: &str, orders: Vec<u32>| match orders == evidence.orders {
        true => Ok(()),
        false => Err(Fault::new(at(key), "these are not the orders of the evidence")),
    };
    right("orders", engine.orders.iter().map(|entry| entry.order).collect())?;
    let unit = engine.scale.as_ref().map(|scale| check_scale(&at("scale"), scale)).transpose()?;
    if engine.newtons.is_some() != unit.as_ref().is_some_and(|[force, _]| force.is_positive()) {
        return Err(Fault::new(at("newtons"), "they are here where there is a scale, of an engine that moves"));
    }
    let found = |quantity: Quantity, order: u32| {
        let found = judged.iter().find(|one| (one.quantity, one.order) == (quantity, order));
        found.ok_or_else(|| Fault::new(at("orders"), "the evidence says nothing of it"))
    };
    let vanishes = |found: &Judged| (0..2).all(|sense| found.vanishes(sense) == Some(true));
    for (place, entry) in engine.orders.iter().enumerate() {
        for (quantity, said) in [(Quantity::FORCE, &entry.force), (Quantity::MOMENT, &entry.moment)] {
            let at = at(&format!("orders[{place}].{}.largest", quantity.name()));
            let found = found(quantity, entry.order)?;
            // Before the one coefficient.
            let moduli = evidence.verdicts.iter().filter(|one| (one.quantity, one.order) == (quantity, entry.order));
            let both: BigRational = moduli.filter_map(|one| BigRational::from_float(one.modulus)).sum();
            let length = Length::of(both / BigRational::from_integer(2.into()), BigRational::zero());
            let (is_zero, has_several) = (vanishes(found), found.groups.len() > 1);
            match said.largest {
                Some(size) if is_zero => agrees(&at, size, true)?,
                Some(size) if !has_several => length.is_size(&at, size, &BigRational::one(), false)?,
                None if has_several && !is_zero => {}
                Some(_) | None => {
                    return Err(Fault::new(at, "it is null where several sums are not zero, and only there"));
                }
            }
        }
    }
    let (Some(newtons), Some([force, _])) = (&engine.newtons, unit) else { return Ok(()) };
    for (place, entry) in newtons.iter().enumerate() {
        for (quantity, size) in [(Quantity::FORCE, entry.force), (Quantity::MOMENT, entry.moment)] {
            let (at, found) = (at(&format!("newtons[{place}].{}", quantity.name())), found(quantity, entry.order)?);
            let swing = Swing::of(found, motion).map_err(|reason| Fault { place: at.clone(), reason })?;
            swing.largest.is_size(&at, size, &force, vanishes(found))?;
        }
    }
    right("newtons", newtons.iter().map(|entry| entry.order).collect())
}
