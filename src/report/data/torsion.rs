//! Which columns hold how a crankshaft twists? A row a mode, a disc, a critical speed, an order of the forced twist.

use num_traits::ToPrimitive;

use super::filling::Filling;
use crate::report::TorsionStudy;
use crate::table::{Table, Unit};

/// A table of a shaft that twists.
pub fn torsion(study: &TorsionStudy, name: &str) -> Option<Table> {
    Some(match name {
        "modes" => modes(study),
        "critical" => critical(study),
        "discs" => discs(study),
        "shapes" => shapes(study),
        "cylinders" => cylinders(study),
        "forced" => forced(study)?,
        _ => return None,
    })
}

const MODE: &str = "the mode, from 1";

fn modes(study: &TorsionStudy) -> Table {
    let rows: Vec<_> = study.modes.iter().enumerate().collect();
    let mut table = Filling::new("modes", "a natural mode of the shaft, the lowest first", &rows);
    table.whole("mode", MODE, |(index, _)| index + 1);
    table.decimal("frequency_{unit}", Unit::HERTZ, "its natural frequency", |(_, one)| Some(one.mode.hertz()));
    let about = "the same in oscillations a minute";
    table.decimal("frequency_{unit}", Unit::PER_MINUTE, about, |(_, one)| Some(60.0 * one.mode.hertz()));
    table.whole("nodes", "how many nodes it has", |(_, one)| one.mode.nodes());
    let about = "the longest star that the mode can have, with deflections of 1 at the first disc";
    table.decimal("longest_star", Unit::NONE, about, |(_, one)| Some(one.longest));
    table.done()
}

fn critical(study: &TorsionStudy) -> Table {
    let rows: Vec<_> = study
        .modes
        .iter()
        .enumerate()
        .flat_map(|(index, speeds)| speeds.orders.iter().map(move |order| (index + 1, speeds, order)))
        .collect();
    let about = "a critical speed: where an order of the torque meets a mode";
    let mut table = Filling::new("critical", about, &rows).keyed(2);
    table.whole("mode", MODE, |(mode, ..)| *mode);
    table.exact("order", Unit::NONE, "the order κ, halves too in a four-stroke engine: 3/2", |(.., order)| {
        Some(order.order.exact().to_string())
    });
    table.decimal("speed_{unit}", Unit::PER_MINUTE, "the critical speed", |(.., order)| Some(order.rpm));
    table.decimal("star", Unit::NONE, "the length of the star of the order on the mode", |(.., order)| {
        Some(order.star.norm())
    });
    table.decimal(
        "part_{unit}",
        Unit::PERCENT,
        "the same as a part of the longest star of the mode",
        |(_, speeds, order)| Some(100.0 * order.star.norm() / speeds.longest),
    );
    table.done()
}

fn discs(study: &TorsionStudy) -> Table {
    let torsion = study.torsion();
    let rows: Vec<_> = torsion.inertias.iter().enumerate().collect();
    let mut table = Filling::new("discs", "a disc of the shaft, from the free end", &rows);
    table.whole("disc", DISC, |(index, _)| index + 1);
    table.decimal("inertia_{unit}", Unit::KILOGRAM_SQUARE_METRE, "its moment of inertia", |(_, one)| one.to_f64());
    let unit = Unit::NEWTON_METRE_PER_RADIAN;
    table.decimal(
        "stiffness_{unit}",
        unit,
        "the torsional stiffness to the next disc; empty at the last",
        |(index, _)| torsion.stiffnesses.get(*index).and_then(ToPrimitive::to_f64),
    );
    table.done()
}

const DISC: &str = "its number, from 1 at the free end";

fn shapes(study: &TorsionStudy) -> Table {
    let rows: Vec<_> = study
        .modes
        .iter()
        .enumerate()
        .flat_map(|(mode, speeds)| {
            speeds.mode.shape.iter().enumerate().map(move |(disc, value)| (mode + 1, disc + 1, value))
        })
        .collect();
    let mut table = Filling::new("shapes", "a disc in a mode", &rows).keyed(2);
    table.whole("mode", MODE, |(mode, ..)| *mode);
    table.whole("disc", DISC, |(_, disc, _)| *disc);
    table.decimal("deflection", Unit::NONE, "how far it is turned, 1 at the first disc", |(.., value)| Some(**value));
    table.done()
}

fn cylinders(study: &TorsionStudy) -> Table {
    let rows: Vec<_> = study
        .modes
        .iter()
        .enumerate()
        .flat_map(|(mode, speeds)| {
            speeds.deflections.iter().enumerate().map(move |(cylinder, value)| (mode + 1, cylinder + 1, value))
        })
        .collect();
    let mut table = Filling::new("cylinders", "the crankpin of a cylinder in a mode", &rows).keyed(2);
    table.whole("mode", MODE, |(mode, ..)| *mode);
    table.whole("cylinder", "the number of the cylinder in the file, from 1", |(_, cylinder, _)| *cylinder);
    table.decimal("deflection", Unit::NONE, "how far it is turned, 1 at the first disc", |(.., value)| Some(**value));
    table.done()
}

fn forced(study: &TorsionStudy) -> Option<Table> {
    let rows = study.forced();
    if rows.is_empty() {
        return None;
    }
    let about =
        "an order of the torque of gas and inertia: how far it twists the undamped shaft at the speed of the layout";
    let mut table = Filling::new("forced", about, &rows);
    table.exact("order", Unit::NONE, "the order κ", |one| Some(one.order.exact().to_string()));
    table.decimal("frequency_{unit}", Unit::HERTZ, "its frequency", |one| Some(one.hertz));
    let about = "the mode whose natural frequency is so near that an undamped shaft says nothing; empty where none is";
    table.maybe_whole("near_mode", about, |one| one.near);
    let far = |one: &crate::report::ForcedTwist, value: f64| one.near.is_none().then_some(value);
    let about = "how far the free end swings; empty near a mode";
    table.decimal("free_end_zero_to_peak_{unit}", Unit::DEGREE, about, |one| far(one, one.free_end));
    let about = "the largest torque that it makes in the shaft; empty near a mode";
    table.decimal("shaft_torque_zero_to_peak_{unit}", Unit::NEWTON_METRE, about, |one| far(one, one.shaft));
    table.whole("behind_disc", "behind which disc that is", |one| one.behind);
    Some(table.done())
}
