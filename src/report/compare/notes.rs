//! What has to be said beside a comparison: units, how it is read, why there are no newtons?

use super::Compared;
use crate::engine::{LengthUnit, WHY_NOT};
use crate::page::Text;
use crate::report::texts::{compare as text, engine_cells, residual};

/// What follows the table.
pub(super) fn notes(engines: &[Compared]) -> Vec<Text> {
    let mut notes: Vec<Text> = vec![text::sizes(), residual::exact_sizes(), positions(engines), text::lowest_orders()];
    notes.push(engine_cells::remedies());
    if engines.iter().any(|engine| engine.judged.orders.iter().any(|order| order.parts.len() > 1)) {
        notes.push(text::several_sums());
    }
    if engines.iter().any(|engine| engine.judged.orders.iter().any(|order| !order.exists())) {
        notes.push(WHY_NOT.into());
    }
    if engines.iter().any(|engine| engine.engine.faster_crank().is_some()) {
        notes.push(residual::orders_by_speed());
    }
    notes.extend(engines.iter().filter_map(without_gas));
    if engines.iter().any(|engine| engine.bearings.is_ok()) {
        notes.push(text::bearing_orders(Text::code("crankstar bearings")));
    }
    let moved = names(engines, |engine| engine.engine.firing().is_some() && engine.engine.has_dead_centres_apart());
    if !moved.is_empty() {
        notes.push(text::firing_intervals(moved));
    }
    let silent = names(engines, |engine| engine.engine.gas().is_some() && !engine.engine.effects().gas);
    if !silent.is_empty() {
        notes.push(text::gas_not_asked(Text::code("effects = [\"gas\"]"), silent));
    }
    notes
}

/// The names of those that this is true of.
pub(super) fn names(engines: &[Compared], of: impl Fn(&Compared) -> bool) -> Text {
    Text::joined(engines.iter().filter(|engine| of(engine)).map(|engine| (&engine.name).into()), ", ")
}

/// What the positions, and with them the moments, are counted in.
fn positions(engines: &[Compared]) -> Text {
    let of = |unit: LengthUnit| names(engines, |engine| engine.engine.length_unit() == unit);
    match (of(LengthUnit::Metre), of(LengthUnit::Spacing)) {
        (_, spacings) if spacings.is_empty() => text::metres(),
        (metres, _) if metres.is_empty() => text::spacings(),
        (metres, spacings) => text::different_units(metres, spacings),
    }
}

/// Why the loads of gas and masses of an engine that asks for the gas are not there.
fn without_gas(engine: &Compared) -> Option<Text> {
    let lack = engine.with_gas.as_ref()?.as_ref().err()?;
    Some(text::gas_missing(&engine.name, lack.to_string()))
}
