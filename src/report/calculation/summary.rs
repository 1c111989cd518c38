//! What does `loads` show on a terminal? The largest values, a row per order, and the peaks.

use super::super::residual;
use super::amounts::{self, Unit, amount, digits, plain};
use super::largest::{Numbers, chosen_lines, largest_lines, shown_line};
use crate::engine::{DOES_NOT_EXIST, Engine, WHY_NOT};
use crate::loads::{Loads, Needed, OrderLoads, Peak, Swing, TorqueOrder};
use crate::proof::Quantity;

/// Header and rows of plain text.
pub struct Rows {
    /// Headings.
    pub header: Vec<String>,
    /// Cells, one row per order.
    pub rows: Vec<Vec<String>>,
}

/// The largest force, moment and torque of each order, zero to peak.
pub fn loads_rows(engine: &Engine, loads: &Loads) -> Rows {
    let [force, moment, torque] =
        [Quantity::Force, Quantity::Moment, Quantity::Torque].map(|quantity| Unit::of(engine, loads, quantity));
    let mut header = vec!["Order".to_owned(), format!("Force in {}", force.name), format!("Moment in {}", moment.name)];
    header.extend(loads.torque.as_ref().map(|_| format!("Torque in {}", torque.name)));
    let mut all: Vec<u32> = loads.orders.iter().map(|order| order.order).collect();
    all.extend(loads.torque.iter().flat_map(|torque| torque.orders.iter().map(|order| order.order)));
    all.sort_unstable();
    all.dedup();
    let row = |order: u32| {
        let judged = loads.orders.iter().find(|loads| loads.order == order);
        let unjudged = match engine.pistons_have_order(Quantity::Force, order) {
            true => NOT_JUDGED,
            false => DOES_NOT_EXIST,
        };
        let swing = |part: fn(&OrderLoads) -> &Swing, unit: Unit| match judged {
            Some(order) if order.exists(engine) => plain(amounts::largest(part(order), unit)),
            Some(_) => DOES_NOT_EXIST.to_owned(),
            None => unjudged.to_owned(),
        };
        let mut cells = vec![order.to_string(), swing(|of| &of.force, force), swing(|of| &of.moment, moment)];
        cells.extend(loads.torque.as_ref().map(|all| {
            let of = all.orders.iter().find(|torque| torque.order == order);
            of.map_or_else(|| NOT_JUDGED.to_owned(), |of| torque_cell(engine, of, torque))
        }));
        cells
    };
    Rows { header, rows: all.into_iter().map(row).collect() }
}

/// What stands where nothing was judged.
const NOT_JUDGED: &str = "not judged";

/// The amplitude of an order of the torque, or that there is none.
pub(super) fn torque_cell(engine: &Engine, order: &TorqueOrder, unit: Unit) -> String {
    match engine.pistons_have_order(Quantity::Torque, order.order) {
        true => torque_amplitude(order, unit),
        false => DOES_NOT_EXIST.to_owned(),
    }
}

pub(super) fn torque_amplitude(order: &TorqueOrder, unit: Unit) -> String {
    match order.vector.outcome {
        crate::loads::Outcome::Zero => "0".to_owned(),
        _ => plain(amount(order.vector.value.norm(), unit)),
    }
}

/// What follows the table: the largest values, what the orders shown leave out, the effects.
pub fn loads_lines(engine: &Engine, numbers: &Numbers, needed: Option<&Needed>) -> Vec<String> {
    let loads = &numbers.loads;
    let mut lines = vec!["Zero to peak; 0 is exact and proved, ≈ decimal.".to_owned()];
    if loads.orders.iter().any(|order| !order.exists(engine)) {
        lines.push(WHY_NOT.to_owned());
    }
    lines.extend(largest_lines(engine, numbers));
    lines.extend(shown_line(engine, numbers));
    lines.extend(chosen_lines(engine, numbers, needed));
    let names: Vec<&str> = loads.groups.iter().map(|group| residual::group_words(group.group)).collect();
    lines.push(format!("In the scene: {}.", names.join(", ")));
    lines
}

/// A peak with its crank angle.
pub(super) fn peak(peak: &Peak, unit: Unit) -> String {
    match peak.angle {
        _ if peak.value == 0.0 || unit.factor == 0.0 => "0".to_owned(),
        Some(angle) => format!("≈ {} {} at θ ≈ {}°", digits(peak.value * unit.factor), unit.name, digits(angle)),
        None => format!("≈ {} {} at every crank angle", digits(peak.value * unit.factor), unit.name),
    }
}
