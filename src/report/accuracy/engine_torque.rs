//! What does an order of the gas torque more, or a sample more, cost and buy? Methods for the largest torque of an engine with gas.

use std::time::Duration;

use super::methods;
use crate::accuracy::{Timing, measured};
use crate::engine::{CycleOrder, Engine};
use crate::page::{Piece, Table, Text, Unit, phrase};
use crate::torque::{self, Peak, PeakMethod};

pub(super) const HOW: &str = "The error is that of the largest torque, gas and inertia, against the time law, and anywhere the largest error through the cycle, both as parts of that torque; what is guaranteed of it adds up the orders of the gas that are left out, \
    exact stars times harmonics to order 48, above it times the bound by the total variation of the torque's slope. The inertia stays in its closed form. What \
    a wrong pressure adds is in neither.";

/// What one method finds.
#[derive(Clone, Debug)]
pub(super) struct PeakRow {
    pub method: PeakMethod,
    /// In newton-metres.
    pub value: f64,
    /// As a part of the peak of the time law.
    pub error: f64,
    /// The largest distance anywhere in the cycle, as a part of that; none for samples.
    pub farthest: Option<f64>,
    /// Guaranteed, as a part of that; none for samples.
    pub bound: Option<f64>,
    pub time: Option<Duration>,
}

/// The largest torque by all methods; none where the layout has no gas, or not all that its torque needs.
pub(super) fn rows(engine: &Engine, timing: Timing) -> Option<Vec<PeakRow>> {
    engine.gas()?;
    let torque = torque::torque(engine).ok()?;
    let peak = Peak::new(&torque);
    let row = |method: PeakMethod| {
        let (value, time) = measured(timing, || peak.value(method));
        let part = |torques: Option<f64>| torques.map(|value| peak.part(value));
        let (farthest, bound) = (part(peak.farthest(method)), part(peak.bound(method)));
        PeakRow { method, value, error: peak.error(value), farthest, bound, time }
    };
    Some(peak.methods().into_iter().map(row).collect())
}

fn name(method: PeakMethod) -> Text {
    match method {
        PeakMethod::Orders(order) => phrase!("orders of the gas up to {}", Text::label(order.to_string())),
        PeakMethod::Samples(steps) => phrase!("time law, {} angles a revolution", steps),
        PeakMethod::TimeLaw => "time law, its largest value refined".into(),
    }
}

/// The torque: a row a method, with times where they were measured.
pub(super) fn table(rows: &[PeakRow]) -> Table {
    table_of(phrase!("Largest torque in {}", Unit::NEWTON_METRE), Unit::NEWTON_METRE, rows)
}

/// A row a method, with what is guaranteed and times where they are known.
pub(super) fn table_of(heading: Text, unit: Unit, rows: &[PeakRow]) -> Table {
    let timed = rows.iter().any(|row| row.time.is_some());
    let guaranteed = rows.iter().any(|row| row.bound.is_some());
    let columns = ["Method".into(), heading, "Error".into(), Text::from("Anywhere")].into_iter();
    let more = [guaranteed.then_some("Guaranteed"), timed.then_some("Time")];
    let columns = columns.chain(more.into_iter().flatten().map(Text::from));
    let mut table = Table::new(columns);
    for row in rows {
        let error = match row.method {
            PeakMethod::TimeLaw => Text::default(),
            PeakMethod::Orders(_) | PeakMethod::Samples(_) if row.error < ROUNDING => {
                phrase!("below {}", methods::power_of_ten(-9))
            }
            PeakMethod::Orders(_) | PeakMethod::Samples(_) => methods::power(row.error).into(),
        };
        let part = |part: Option<f64>| part.map_or_else(Text::default, |part| methods::power(part).into());
        let (farthest, bound) = (part(row.farthest), part(row.bound));
        let cells = [name(row.method), methods::to_digits(row.value, unit), error, farthest];
        let cells = cells.into_iter().chain(guaranteed.then_some(bound));
        let time = timed.then(|| row.time.map_or_else(Text::default, |time| methods::time(time).into()));
        table.push(cells.chain(time).collect());
    }
    table
}

/// Errors below this are those of the search for the peak.
const ROUNDING: f64 = 1e-9;

/// The largest torque, and how many orders have it.
pub(super) fn answer(label: Text, rows: &[PeakRow]) -> Text {
    let peak = rows.last().map_or(f64::NAN, |row| row.value);
    let peak = Piece::Quantity(peak, Unit::NEWTON_METRE);
    match enough(rows) {
        Some(order) => phrase!(
            "Largest torque, gas and inertia, {}: {}. The orders of the gas up to {} have it within 0.1 %.",
            label,
            peak,
            Text::label(order.to_string())
        ),
        None => phrase!(
            "Largest torque, gas and inertia, {}: {}. The orders of the gas compared here do not have it within 0.1 %.",
            label,
            peak
        ),
    }
}

/// The first order of the gas with which the largest value is within 0.1 %, and with every higher one that is compared.
pub(super) fn enough(rows: &[PeakRow]) -> Option<CycleOrder> {
    let orders = rows.iter().filter_map(|row| match row.method {
        PeakMethod::Orders(order) => Some((order, row.error <= methods::USUAL)),
        PeakMethod::Samples(_) | PeakMethod::TimeLaw => None,
    });
    orders.fold(None, |first, (order, is_within)| if is_within { first.or(Some(order)) } else { None })
}
