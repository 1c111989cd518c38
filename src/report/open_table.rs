//! Which tables does the report of a family hold?

use super::dialect::Dialect;
use super::open_words;
use super::table::{Table, phase_formula};
use crate::engine::{Cylinder, Family, Linear};
use crate::family::{self, OpenOrder};
use crate::proof::Sense;

/// A family: orders × (force, moment) × (direct, reverse), for which angles each vanishes.
pub(super) fn summary(dialect: Dialect, orders: &[OpenOrder]) -> Table {
    let bold = |text: String| if text == "0" { "**0**".to_owned() } else { text };
    let row = |order: &OpenOrder| {
        let cells =
            order.force.iter().chain(&order.moment).map(|verdict| bold(open_words::open_summary_prose(verdict)));
        [order.order.to_string()].into_iter().chain(cells).collect()
    };
    let header = ["Order", "Force, direct", "Force, reverse", "Moment, direct", "Moment, reverse"];
    Table::new(dialect, &header, orders.iter().map(row).collect())
}

/// A family: one row per cylinder.
pub(super) fn cylinders(dialect: Dialect, family: &Family) -> Table {
    let row = |cylinder: &Cylinder<Linear, Linear>| {
        vec![
            cylinder.name.clone(),
            open_words::open_angle(&cylinder.throw),
            open_words::open_angle(&cylinder.bank),
            open_words::open_length(&cylinder.position),
        ]
    };
    Table::new(dialect, &["Cylinder", "Throw β", "Bank α", "Position z"], family.cylinders().iter().map(row).collect())
}

/// A family: the vector-star table of order k, the unknowns visible.
pub(super) fn phases(dialect: Dialect, family: &Family, order: u32) -> Table {
    let k = i64::from(order);
    let row = |cylinder: &Cylinder<Linear, Linear>| {
        let phase = |sense| open_words::open_angle(&family::phase(cylinder, order, sense));
        vec![
            cylinder.name.clone(),
            open_words::open_length(&family.arm(cylinder)),
            phase(Sense::Direct),
            phase(Sense::Reverse),
        ]
    };
    let direct = format!("Direct phase {}", phase_formula(k, Sense::Direct, true));
    let reverse = format!("Reverse phase {}", phase_formula(k, Sense::Reverse, true));
    Table::new(dialect, &["Cylinder", "Arm z", &direct, &reverse], family.cylinders().iter().map(row).collect())
}
