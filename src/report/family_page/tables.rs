//! Which tables does the report of a family hold?

use super::super::table::phase_formula;
use super::{unknowns, words};
use crate::engine::{Family, LengthUnit, Linear};
use crate::family::{self, OpenOrder};
use crate::page::{Table, Text, phrase};
use crate::proof::Sense;

/// Orders × (force, moment) × (direct, reverse), for which angles each vanishes.
pub(super) fn summary(family: &Family, orders: &[OpenOrder]) -> Table {
    let direct = heading(family, "Moment, direct ({})", "Moment, direct");
    let reverse = heading(family, "Moment, reverse ({})", "Moment, reverse");
    let mut table = Table::new(["Order".into(), "Force, direct".into(), "Force, reverse".into(), direct, reverse]);
    for order in orders {
        let cells = order.force.iter().chain(&order.moment).map(words::cell);
        table.push([Text::from(order.order)].into_iter().chain(cells).collect());
    }
    table
}

/// Words with the unit of lengths that may be open: they stay in metres for every reader.
fn heading(family: &Family, in_metres: &'static str, bare: &'static str) -> Text {
    match family.length_unit() {
        LengthUnit::Metre => phrase!(in_metres, "m".to_owned()),
        LengthUnit::Spacing => bare.into(),
    }
}

/// A length that may be open, with its unit.
pub(super) fn place(family: &Family, length: &Linear) -> Text {
    let told = unknowns::open_length(length);
    match (family.length_unit(), length.as_known()) {
        (LengthUnit::Metre, Some(_)) => phrase!("{} {}", told, "m".to_owned()),
        (LengthUnit::Metre, None) | (LengthUnit::Spacing, _) => told.into(),
    }
}

/// One row per cylinder.
pub(super) fn cylinders(family: &Family) -> Table {
    Table::of(family.cylinders())
        .column("Cylinder", |cylinder| cylinder.name.clone())
        .column("Throw β", |cylinder| unknowns::open_angle(&cylinder.throw))
        .column("Bank α", |cylinder| unknowns::open_angle(&cylinder.bank))
        .column(heading(family, "Position z ({})", "Position z"), |cylinder| unknowns::open_length(&cylinder.position))
        .done()
}

/// The vector-star table of order k, the unknowns visible.
pub(super) fn phases(family: &Family, order: u32) -> Table {
    let formula = |sense| phase_formula(i64::from(order), sense, true);
    let phase = |cylinder, sense| unknowns::open_angle(&family::phase(cylinder, order, sense));
    Table::of(family.cylinders())
        .column("Cylinder", |cylinder| cylinder.name.clone())
        .column(heading(family, "Arm z ({})", "Arm z"), |cylinder| unknowns::open_length(&family.arm(cylinder)))
        .column(phrase!("Direct phase {}", formula(Sense::Direct)), |cylinder| phase(cylinder, Sense::Direct))
        .column(phrase!("Reverse phase {}", formula(Sense::Reverse)), |cylinder| phase(cylinder, Sense::Reverse))
        .done()
}
