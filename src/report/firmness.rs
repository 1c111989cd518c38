//! How firm are the zeros, in words? A cell of the summary, and a table with what each disturbance means.

use std::collections::{BTreeMap, BTreeSet};

use crate::engine::Engine;
use crate::page::{Block, Table, Text, phrase};
use crate::report::texts::firmness as text;
use crate::verdict::{Disturbance, Firmness, FirmnessOutcome, OrderBalance, OrderVerdict, firmness};

/// What is changed, as the heading of a column.
fn heading(disturbance: Disturbance) -> &'static str {
    match disturbance {
        Disturbance::SymmetricSpacing => "Symmetric spacing",
        Disturbance::AnySpacing => "Any spacing",
        Disturbance::BankOffset => "Bank offset",
        Disturbance::BankMasses => "Masses by bank",
        Disturbance::CylinderMasses => "Masses by cylinder",
    }
}

/// What that means.
fn meaning(disturbance: Disturbance) -> Text {
    match disturbance {
        Disturbance::SymmetricSpacing => text::symmetric_spacing(),
        Disturbance::AnySpacing => text::any_spacing(),
        Disturbance::BankOffset => text::bank_offset(),
        Disturbance::BankMasses => text::bank_masses(),
        Disturbance::CylinderMasses => text::cylinder_masses(),
    }
}

/// One row per zero, with what each disturbance means; nothing where nothing vanishes.
pub(super) fn section(engine: &Engine, orders: &[OrderVerdict]) -> Vec<Block> {
    let mut zeros: Vec<(Text, Firmness)> = Vec::new();
    // What no mass has at this order is zero whatever is changed.
    for order in orders.iter().flat_map(|order| &order.parts).filter(|order| order.exists) {
        for (name, balance) in [("force, order {}", &order.force), ("moment, order {}", &order.moment)] {
            zeros.extend(firmness(engine, balance).map(|firmness| (phrase!(name, order.order), firmness)));
        }
    }
    if zeros.is_empty() {
        return Vec::new();
    }
    let explained = |disturbance| phrase!("**{}:** {}", heading(disturbance), meaning(disturbance));
    vec![
        Block::Heading(1, "Robust and accidental zeros".into()),
        text::which_survive().into(),
        table(engine, zeros).into(),
        Block::List(Disturbance::ALL.map(explained).into()),
    ]
}

fn table(engine: &Engine, zeros: Vec<(Text, Firmness)>) -> Table {
    let mut table = Table::of(zeros).column("Zero", |(name, _)| name.clone());
    for disturbance in Disturbance::ALL {
        table = table.column(heading(disturbance), |(_, firmness)| match firmness.outcome(disturbance) {
            FirmnessOutcome::Survives => "yes",
            FirmnessOutcome::Breaks => "no",
            FirmnessOutcome::DoesNotApply => "–",
        });
    }
    let verdict = |firmness: &Firmness| match firmness.is_firm() {
        true => "robust".into(),
        false => phrase!("needs {}", needs_words(engine, firmness)),
    };
    table.column("Verdict", |(_, firmness)| verdict(firmness)).done()
}

/// What an accidental zero needs: `symmetric spacing, equal banks`.
fn needs_words(engine: &Engine, firmness: &Firmness) -> Text {
    Text::joined(needs(engine, firmness).into_iter().map(Text::from), ", ")
}

/// How firm the zeros of one order are, in a few words: `force firm; moment needs symmetric spacing`.
pub(super) fn summary(engine: &Engine, order: &OrderBalance) -> Text {
    if !order.exists {
        return "–".into();
    }
    let both = [(&order.force, "force robust", "force needs {}"), (&order.moment, "moment robust", "moment needs {}")];
    let words = |(balance, firm, needed): (_, &'static str, _)| {
        let firmness = firmness(engine, balance)?;
        Some(if firmness.is_firm() { firm.into() } else { phrase!(needed, needs_words(engine, &firmness)) })
    };
    let told: Vec<Text> = both.into_iter().filter_map(words).collect();
    if told.is_empty() { "–".into() } else { Text::joined(told, "; ") }
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

/// Whether the banks are at different positions.
fn has_offset(engine: &Engine) -> bool {
    let mut banks: BTreeMap<_, BTreeSet<_>> = BTreeMap::new();
    for cylinder in engine.cylinders() {
        banks.entry(&cylinder.bank).or_default().insert(&cylinder.position);
    }
    banks.values().collect::<BTreeSet<_>>().len() > 1
}
