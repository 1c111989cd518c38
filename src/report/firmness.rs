//! How firm are the zeros, in words? A cell of the summary, and a table with what each disturbance means.

use std::collections::{BTreeMap, BTreeSet};

use serde::Serialize;

use super::dialect::Dialect;
use super::table::Table;
use crate::engine::Engine;
use crate::verdict::{Balance, Disturbance, Firmness, FirmnessOutcome, OrderBalance, OrderVerdict, firmness};

/// The section on how firm the zeros are.
#[derive(Clone, Debug, Serialize)]
pub(super) struct Section {
    table: Table,
    meanings: Vec<String>,
}

/// What is changed, as the heading of a column, and what that means.
fn words(disturbance: Disturbance) -> (&'static str, &'static str) {
    match disturbance {
        Disturbance::SymmetricSpacing => (
            "Symmetric spacing",
            "the cylinders take any distances from the reference plane, those at equal distances equal ones again.",
        ),
        Disturbance::AnySpacing => (
            "Any spacing",
            "the cylinders take any positions, those at one position together; the reference plane stays where it is.",
        ),
        Disturbance::BankOffset => (
            "Bank offset",
            "every bank moves along the crankshaft as a whole; the middle of the banks stays where it is.",
        ),
        Disturbance::BankMasses => (
            "Masses by bank",
            "the masses of a bank are multiplied by a factor of its own; where every bank is a single cylinder, see the \
             next column.",
        ),
        Disturbance::CylinderMasses => {
            ("Masses by cylinder", "every mass is its own; only vectors of length zero survive that.")
        }
    }
}

impl Section {
    /// One row a zero; `None` where nothing vanishes.
    pub fn new(dialect: Dialect, engine: &Engine, orders: &[OrderVerdict]) -> Option<Self> {
        let mut header = vec!["Zero"];
        header.extend(Disturbance::ALL.map(|disturbance| words(disturbance).0));
        header.push("Verdict");
        let parts = orders.iter().flat_map(|order| &order.parts);
        let balances = parts.flat_map(|order| [("force", &order.force), ("moment", &order.moment)]);
        let rows: Vec<Vec<String>> =
            balances.filter_map(|(name, balance)| Some(row(name, balance, &firmness(engine, balance)?))).collect();
        let meaning = |disturbance| {
            let (heading, meaning) = words(disturbance);
            dialect.prose(&format!("**{heading}:** {meaning}"))
        };
        (!rows.is_empty()).then(|| Section {
            table: Table::new(dialect, &header, rows),
            meanings: Disturbance::ALL.into_iter().map(meaning).collect(),
        })
    }
}

fn row(name: &str, balance: &Balance, firmness: &Firmness) -> Vec<String> {
    let cell = |disturbance| match firmness.outcome(disturbance) {
        FirmnessOutcome::Survives => "yes",
        FirmnessOutcome::Breaks => "no",
        FirmnessOutcome::DoesNotApply => "–",
    };
    let mut cells = vec![format!("{name}, order {}", balance.direct.order)];
    cells.extend(Disturbance::ALL.map(|disturbance| cell(disturbance).to_owned()));
    cells.push(if firmness.is_firm() { "firm" } else { "accidental" }.to_owned());
    cells
}

/// How firm the zeros of one order are, in a few words: `force firm; moment needs symmetric spacing`.
pub(super) fn summary(engine: &Engine, order: &OrderBalance) -> String {
    let part = |name: &str, balance| {
        let firmness = firmness(engine, balance)?;
        Some(match firmness.is_firm() {
            true => format!("{name} firm"),
            false => format!("{name} needs {}", needs(engine, &firmness).join(", ")),
        })
    };
    let parts: Vec<String> =
        [part("force", &order.force), part("moment", &order.moment)].into_iter().flatten().collect();
    if parts.is_empty() { "–".to_owned() } else { parts.join("; ") }
}

/// What has to stay as it is.
fn needs(engine: &Engine, firmness: &Firmness) -> Vec<&'static str> {
    let spacing = match (firmness.outcome(Disturbance::SymmetricSpacing), firmness.breaks(Disturbance::AnySpacing)) {
        (FirmnessOutcome::Survives, true) => Some("symmetric spacing"),
        (FirmnessOutcome::Breaks, _) | (_, true) => Some("this spacing"),
        _ => None,
    };
    let offset = if has_offset(engine) { "this bank offset" } else { "no bank offset" };
    let offset = firmness.breaks(Disturbance::BankOffset).then_some(offset);
    let masses = firmness.breaks(Disturbance::BankMasses).then_some("equal banks");
    [spacing, offset, masses].into_iter().flatten().collect()
}

/// Whether the banks stand at different positions.
fn has_offset(engine: &Engine) -> bool {
    let mut banks: BTreeMap<_, BTreeSet<_>> = BTreeMap::new();
    for cylinder in engine.cylinders() {
        banks.entry(&cylinder.bank).or_default().insert(&cylinder.position);
    }
    banks.values().collect::<BTreeSet<_>>().len() > 1
}
