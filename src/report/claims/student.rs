//! How is a student's vector-star table answered? The first wrong entry, and what it should be.

use super::super::{table, typeset};
use crate::claim::{StarTable, TableVerdict};
use crate::engine::Engine;
use crate::order;
use crate::page::Text;
use crate::page::number::Amount;
use crate::report::texts::claims as text;

/// The answer to a table.
pub fn table_finding(of: &StarTable, verdict: &TableVerdict) -> Text {
    match verdict {
        TableVerdict::Right(entries) => text::all_entries_right(*entries),
        TableVerdict::WrongPhase { cylinder, sense, written, right } => {
            let engine: &Engine = &of.layout;
            let cylinder = &engine.cylinders()[*cylinder];
            assert_eq!(order::phase(cylinder, of.order, Some(*sense)), *right);
            text::wrong_row(
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
        TableVerdict::WrongSum { quantity, sense, written, right } => {
            text::wrong_sum(sense.name(), quantity.name(), written, Amount { exact: right.0.clone(), decimal: right.1 })
        }
    }
}
