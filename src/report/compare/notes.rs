//! What has to be said beside a comparison: units, how it is read, why there are no newtons?

use super::super::engine_cells;
use super::super::texts::residual;
use super::Compared;
use crate::engine::{LengthUnit, WHY_NOT};
use crate::page::{Text, phrase};

/// What follows the table.
pub(super) fn notes(engines: &[Compared]) -> Vec<Text> {
    let mut notes: Vec<Text> = vec![SIZES.into(), residual::exact_sizes(), positions(engines), FIRST_LEFT.into()];
    notes.push(engine_cells::REMEDIES.into());
    if engines.iter().any(|engine| engine.judged.orders.iter().any(|order| order.parts.len() > 1)) {
        notes.push(SEVERAL_SUMS.into());
    }
    if engines.iter().any(|engine| engine.judged.orders.iter().any(|order| !order.exists())) {
        notes.push(WHY_NOT.into());
    }
    if engines.iter().any(|engine| engine.engine.faster_crank().is_some()) {
        notes.push(residual::orders_by_speed());
    }
    notes.extend(engines.iter().filter_map(without_gas));
    let moved = names(engines, |engine| engine.engine.firing().is_some() && engine.engine.has_dead_centres_apart());
    if !moved.is_empty() {
        notes.push(phrase!(
            "Firing intervals count where crankpins are in line with their cylinders; offsets move the top dead centres: {}.",
            moved
        ));
    }
    let silent = names(engines, |engine| engine.engine.gas().is_some() && !engine.engine.effects().gas);
    if !silent.is_empty() {
        let key = Text::code("effects = [\"gas\"]");
        notes.push(phrase!(
            "Guide-force moments H and X and bearing loads with gas need {} above the first table: {}.",
            key,
            silent
        ));
    }
    notes
}

const SIZES: &str = "Sizes are the largest values through a revolution, rounded; 0 is proved. An order has a row where it is above 1 % of the largest in one of the engines; the others add up to at most what is stated, – means below a millionth of the largest, or unknown. Cures are those of orders 1 and 2, or of all orders where neither is compared.";

const FIRST_LEFT: &str = "Force from order, moment from order: the lowest of all orders at which it is not zero. All values are for the engines as built, with all masses of their layouts; where rotating masses contribute to an order, the pistons alone are below it.";

const SEVERAL_SUMS: &str = "Where rods differ, or a shaft turns at an order of the pistons, both the whole order and each of its sums are decided: only equal rods have the same $c_k$.";

/// The names of those that this is true of.
pub(super) fn names(engines: &[Compared], of: impl Fn(&Compared) -> bool) -> Text {
    Text::joined(engines.iter().filter(|engine| of(engine)).map(|engine| (&engine.name).into()), ", ")
}

/// What the positions, and with them the moments, are counted in.
fn positions(engines: &[Compared]) -> Text {
    let of = |unit: LengthUnit| names(engines, |engine| engine.engine.length_unit() == unit);
    match (of(LengthUnit::Metre), of(LengthUnit::Spacing)) {
        (_, spacings) if spacings.is_empty() => {
            "m, r, ω and $c_k$ are those of each engine. Positions are in metres.".into()
        }
        (metres, _) if metres.is_empty() => {
            "m, r, ω and $c_k$ are those of each engine. Positions have no unit: they are multiples of the spacing of each engine.".into()
        }
        (metres, spacings) => phrase!(
            "m, r, ω and $c_k$ are those of each engine. Positions are in different units, so that the moments do not compare: metres in {}, multiples of the spacing in {}.",
            metres,
            spacings
        ),
    }
}

/// Why the loads of gas and masses of an engine that asks for the gas are not there.
fn without_gas(engine: &Compared) -> Option<Text> {
    let lack = engine.with_gas.as_ref()?.as_ref().err()?;
    Some(phrase!("**{}**: gas loads were asked for, but are missing: {}.", &engine.name, lack.to_string()))
}
