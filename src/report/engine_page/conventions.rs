//! What do angles, signs and units mean, and what do the verdicts rest on?

use super::super::convention::{differs, seen};
use super::super::mechanism_words::{assumed, centres, rows};
use super::super::table;
use crate::engine::{Engine, LengthUnit};
use crate::page::{Text, Unit, number};
use crate::report::texts::{engine as text, residual};

/// The conventions of a report.
pub(super) fn lines(engine: &Engine) -> Vec<Text> {
    let mut lines = vec![seen(engine.convention())];
    lines.extend(differs(engine.convention()));
    lines.extend([centres(engine), text::lagging_throw(), reference_plane(engine), assumed(engine)]);
    lines
}

/// About which plane moments are taken.
pub(in crate::report) fn reference_plane(engine: &Engine) -> Text {
    let plane = table::place(engine, engine.reference_plane());
    if engine.reference_plane_given() { text::plane_given(plane) } else { text::plane_in_the_middle(plane) }
}

/// What the exact tables count in.
pub(super) fn units(engine: &Engine) -> Text {
    let forces = match &engine.dimensions().mass {
        _ if engine.has_unit_masses() => text::force_unit(),
        Some(_) => text::force_unit_of_mass(number::given_with(&engine.unit_mass(), Unit::KILOGRAM)),
        None => text::force_unit_of_table(),
    };
    let moments = match engine.length_unit() {
        LengthUnit::Metre => text::moment_unit_metres(),
        LengthUnit::Spacing => text::moment_unit_spacing(engine.positions_given()),
    };
    let signs = [forces, text::largest_value(), moments, text::exact_or_decimal()];
    let speeds = engine.faster_crank().map(|_| residual::orders_by_speed());
    Text::joined(signs.into_iter().chain(rows(engine)).chain(speeds), " ")
}
