//! How is a student's vector-star table answered? The first wrong entry, and what it should be.

use super::super::{table, typeset};
use crate::claim::{StarTable, TableVerdict};
use crate::engine::Engine;
use crate::order;
use crate::page::number::Amount;
use crate::page::{Text, phrase};

/// The answer to a table.
pub fn table_finding(of: &StarTable, verdict: &TableVerdict) -> Text {
    match verdict {
        TableVerdict::Right(entries) => phrase!("All {} entries are right.", *entries),
        TableVerdict::WrongPhase { cylinder, sense, written, right } => {
            let engine: &Engine = &of.layout;
            let cylinder = &engine.cylinders()[*cylinder];
            assert_eq!(order::phase(cylinder, of.order, Some(*sense)), *right);
            phrase!(
                "The first wrong row is that of cylinder {}: its {} phase is {}, not {}: {} with β = {} and α = {} is {}.",
                cylinder.name.clone(),
                sense.name(),
                typeset::angle(right),
                written,
                table::phase_formula(i64::from(of.order), *sense, true),
                typeset::angle(&cylinder.throw),
                typeset::degrees(&typeset::signed_degrees(&cylinder.bank)),
                table::working(cylinder, of.order, *sense),
            )
        }
        TableVerdict::WrongSum { quantity, sense, written, right } => phrase!(
            "All phases given are right, but the {} sum of the {} is not {}: its length is {}.",
            sense.name(),
            quantity.name(),
            written,
            Amount { exact: right.0.clone(), decimal: right.1 },
        ),
    }
}
