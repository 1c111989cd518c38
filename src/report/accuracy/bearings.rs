//! What does an order of the inertia more cost and buy for the largest bearing load? Methods beside each other.

use super::methods;
use crate::accuracy::{BearingMethod, BearingRow};
use crate::engine::Engine;
use crate::page::{Piece, Table, Text, phrase};
use crate::proof::Quantity;

pub(super) const HOW: &str = "The loads are those of inertia, with the side forces of the pistons, on a continuous beam. The error is that of the largest load of any bearing \
    against the closed form; what is guaranteed bounds all orders that are left out, whichever bearing they load.";

/// Errors below this are those of the search for the peak.
const ROUNDING: f64 = 1e-9;

fn name(method: BearingMethod) -> Text {
    match method {
        BearingMethod::Orders(order) => phrase!("orders up to {}", order),
        BearingMethod::Angles(steps) => phrase!("closed form, {} angles", steps),
        BearingMethod::ClosedForm => "closed form, its largest value refined".into(),
    }
}

/// A row a method, with times where they were measured.
pub(super) fn table(engine: &Engine, rows: &[BearingRow]) -> Table {
    let (unit, factor) = methods::page_unit(engine, Quantity::FORCE);
    let timed = rows.iter().any(|row| row.time.is_some());
    let columns = ["Method".into(), phrase!("Peak in {}", unit), "Error".into(), "Guaranteed".into()];
    let mut table = Table::new(columns.into_iter().chain(timed.then_some(Text::from("Time"))));
    for row in rows {
        let error = error(row);
        let bound = row.bound.map_or_else(Text::default, |bound| methods::power(bound).into());
        let cells = [name(row.method), methods::to_digits(row.value * factor, unit), error, bound];
        let time = timed.then(|| row.time.map_or_else(Text::default, |time| methods::time(time).into()));
        table.push(cells.into_iter().chain(time).collect());
    }
    table
}

/// The part of the largest load by which a method is off; nothing for the reference itself.
fn error(row: &BearingRow) -> Text {
    match row.method {
        BearingMethod::ClosedForm => Text::default(),
        BearingMethod::Orders(_) | BearingMethod::Angles(_) if row.error < ROUNDING => {
            phrase!("below {}", methods::power_of_ten(-9))
        }
        BearingMethod::Orders(_) | BearingMethod::Angles(_) => methods::power(row.error).into(),
    }
}

/// The fewest orders that have the largest load within a thousandth, guaranteed.
fn orders_for_a_thousandth(rows: &[BearingRow]) -> Option<u32> {
    rows.iter().find_map(|row| match row.method {
        BearingMethod::Orders(order) => row.bound.filter(|bound| *bound <= methods::USUAL).map(|_| order),
        BearingMethod::Angles(_) | BearingMethod::ClosedForm => None,
    })
}

/// The largest load, and the orders that have it.
pub(super) fn answer(engine: &Engine, label: Text, rows: &[BearingRow]) -> Text {
    let (unit, factor) = methods::page_unit(engine, Quantity::FORCE);
    let peak = Piece::Quantity(rows.last().map_or(f64::NAN, |row| row.value) * factor, unit);
    match orders_for_a_thousandth(rows) {
        Some(order) => phrase!(
            "Largest bearing load of inertia, {}: {}. Orders up to {} have it within 0.1 %, guaranteed.",
            label,
            peak,
            order
        ),
        None => phrase!(
            "Largest bearing load of inertia, {}: {}. The orders compared here do not have it within 0.1 %.",
            label,
            peak
        ),
    }
}
