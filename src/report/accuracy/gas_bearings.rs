//! What does an order of the gas more, or a sample more, cost and buy for the largest bearing load? Methods beside each other.

use super::engine_torque::{PeakRow, enough, table_of};
use crate::accuracy::{Timing, measured};
use crate::engine::Engine;
use crate::journal::LoadPeak;
use crate::page::{Piece, Table, Text, Unit, phrase};

pub(super) const HOW: &str = "The loads are those of gas and masses, with the side forces of the pistons, on a continuous beam; the masses stay in their closed form. The error is \
    that of the largest load of any bearing against the forces themselves, and anywhere the largest error of any bearing through the cycle, both as parts of that load. What a wrong \
    pressure adds is in neither.";

/// The largest bearing load by all methods; none where the layout does not ask for the gas, or has not all that this needs.
pub(super) fn rows(engine: &Engine, timing: Timing) -> Option<Vec<PeakRow>> {
    let asked = engine.effects().gas && !engine.bearings().is_empty();
    let peak = asked.then(|| LoadPeak::new(engine).ok().flatten())??;
    let rows = peak.methods().into_iter().map(|method| {
        let (value, time) = measured(timing, || peak.value(method));
        let error = (value - peak.largest).abs() / peak.largest;
        let farthest = peak.farthest(method).map(|far| far / peak.largest);
        PeakRow { method, value, error, farthest, bound: None, time }
    });
    Some(rows.collect())
}

/// A row a method, with times where they were measured.
pub(super) fn table(rows: &[PeakRow]) -> Table {
    table_of(phrase!("Largest load in {}", Unit::NEWTON), Unit::NEWTON, rows)
}

/// The largest load, and how many orders have it.
pub(super) fn answer(label: Text, rows: &[PeakRow]) -> Text {
    let peak = Piece::Quantity(rows.last().map_or(f64::NAN, |row| row.value), Unit::NEWTON);
    match enough(rows) {
        Some(order) => phrase!(
            "Largest bearing load, gas and masses, {}: {}. The orders of the gas up to {} have it within 0.1 %.",
            label,
            peak,
            Text::label(order.to_string())
        ),
        None => phrase!(
            "Largest bearing load, gas and masses, {}: {}. The orders of the gas compared here do not have it within 0.1 %.",
            label,
            peak
        ),
    }
}
