//! Which tables does the report of a family hold?

use super::super::table::phase_formula;
use super::words;
use crate::engine::Family;
use crate::family::{self, OpenOrder};
use crate::page::{Table, Text, phrase};
use crate::proof::Sense;

/// Orders × (force, moment) × (direct, reverse), for which angles each vanishes.
pub(super) fn summary(orders: &[OpenOrder]) -> Table {
    let mut table = Table::new(["Order", "Force, direct", "Force, reverse", "Moment, direct", "Moment, reverse"]);
    for order in orders {
        let cells = order.force.iter().chain(&order.moment).map(words::summary);
        table.push([Text::from(order.order)].into_iter().chain(cells).collect());
    }
    table
}

/// One row per cylinder.
pub(super) fn cylinders(family: &Family) -> Table {
    let mut table = Table::new(["Cylinder", "Throw β", "Bank α", "Position z"]);
    for cylinder in family.cylinders() {
        table.push(vec![
            cylinder.name.clone().into(),
            words::open_angle(&cylinder.throw).into(),
            words::open_angle(&cylinder.bank).into(),
            words::open_length(&cylinder.position).into(),
        ]);
    }
    table
}

/// The vector-star table of order k, the unknowns visible.
pub(super) fn phases(family: &Family, order: u32) -> Table {
    let k = i64::from(order);
    let mut table = Table::new([
        "Cylinder".into(),
        "Arm z".into(),
        phrase!("Direct phase {}", phase_formula(k, Sense::Direct, true)),
        phrase!("Reverse phase {}", phase_formula(k, Sense::Reverse, true)),
    ]);
    for cylinder in family.cylinders() {
        let phase = |sense| words::open_angle(&family::phase(cylinder, order, sense)).into();
        table.push(vec![
            cylinder.name.clone().into(),
            words::open_length(&family.arm(cylinder)).into(),
            phase(Sense::Direct),
            phase(Sense::Reverse),
        ]);
    }
    table
}
