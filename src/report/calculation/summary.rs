//! What does `loads` show on a terminal? The largest values, a row an order, and the peaks.

use super::amounts::{self, Unit, amount, digits};
use crate::layout::Layout;
use crate::loads::{Loads, Needed, Peak};
use crate::order::MassGroup;
use crate::proof::Quantity;

/// Header and rows of plain text.
pub struct Rows {
    /// Headings.
    pub header: Vec<String>,
    /// Cells, one row an order.
    pub rows: Vec<Vec<String>>,
}

/// The largest force, moment and torque of each order, zero to peak.
pub fn loads_rows(layout: &Layout, loads: &Loads) -> Rows {
    let [force, moment, torque] =
        [Quantity::Force, Quantity::Moment, Quantity::Torque].map(|quantity| Unit::of(layout, loads, quantity));
    let mut header = vec!["Order".to_owned(), format!("Force in {}", force.name), format!("Moment in {}", moment.name)];
    header.extend(loads.torque.as_ref().map(|_| format!("Torque in {}", torque.name)));
    let torque_order = |order: u32| loads.torque.as_ref()?.orders.iter().find(|torque| torque.order == order);
    let mut all: Vec<u32> = loads.orders.iter().map(|order| order.order).collect();
    all.extend(loads.torque.iter().flat_map(|torque| torque.orders.iter().map(|order| order.order)));
    all.sort_unstable();
    all.dedup();
    let row = |order: u32| {
        let swings = loads.orders.iter().find(|loads| loads.order == order);
        let mut cells = vec![order.to_string()];
        cells.push(swings.map_or(String::new(), |loads| amounts::largest(&loads.force, force)));
        cells.push(swings.map_or(String::new(), |loads| amounts::largest(&loads.moment, moment)));
        cells.extend(
            loads
                .torque
                .as_ref()
                .map(|_| torque_order(order).map_or(String::new(), |order| torque_amplitude(order, torque))),
        );
        cells
    };
    Rows { header, rows: all.into_iter().map(row).collect() }
}

pub(super) fn torque_amplitude(order: &crate::loads::TorqueOrder, unit: Unit) -> String {
    match order.vector.outcome {
        crate::loads::Outcome::Zero => "0".to_owned(),
        _ => amount(order.vector.value.norm(), unit),
    }
}

/// What follows the table: peaks, effects, orders that were chosen.
pub fn loads_lines(layout: &Layout, loads: &Loads, needed: Option<&Needed>) -> Vec<String> {
    let unit = |quantity| Unit::of(layout, loads, quantity);
    let mut lines = vec![
        "Zero to peak; 0 is exact and proved, ≈ decimal.".to_owned(),
        format!("Largest force of all orders shown: {}.", peak(&loads.force.peak(), unit(Quantity::Force))),
        format!("Largest moment: {}.", peak(&loads.moment.peak(), unit(Quantity::Moment))),
    ];
    if let Some(torque) = &loads.torque {
        let peak = peak(&torque.waveform.real_peak(), unit(Quantity::Torque));
        lines.push(format!("Largest inertia torque: {peak}."));
    }
    let names: Vec<&str> = loads.groups.iter().map(|group| name(group.group)).collect();
    lines.push(format!("In the scene: {}.", names.join(", ")));
    lines.extend(needed.map(needed_sentence));
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

/// The name of a group of masses.
pub(super) fn name(group: MassGroup) -> &'static str {
    match group {
        MassGroup::Reciprocating => "reciprocating masses",
        MassGroup::Rotating => "rotating masses",
        MassGroup::Crankshaft => "pins and webs",
        MassGroup::Counterweights => "counterweights",
        MassGroup::Balancers => "balancer shafts",
    }
}

/// Which orders were kept, which were left out, and how much that is at most.
pub(super) fn needed_sentence(needed: &Needed) -> String {
    let list = |orders: &[u32]| match orders {
        [] => "none".to_owned(),
        orders => orders.iter().map(u32::to_string).collect::<Vec<_>>().join(", "),
    };
    let bounds = [("force", needed.force_bound), ("moment", needed.moment_bound)];
    let bounds = bounds.into_iter().filter_map(|(name, bound)| {
        bound.map(|bound| format!("{} % of the peak {name}", digits((bound * 100.0).next_up())))
    });
    let bounds: Vec<String> = bounds.collect();
    let left = if bounds.is_empty() {
        "there is nothing to leave out".to_owned()
    } else {
        format!("what is left out is at most {}", bounds.join(" and "))
    };
    format!(
        "Orders kept for the accuracy asked for: {}; left out: {} and all above {}; {left}.",
        list(&needed.kept),
        list(&needed.dropped),
        needed.looked_at
    )
}
