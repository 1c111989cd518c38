//! Which columns hold how a crankshaft twists? A row a mode, a disc, a critical speed, an order of the forced twist.

use num_traits::ToPrimitive;

use super::{damped_data as damped, gears};
use crate::report::TorsionStudy;
use crate::report::data::Filling;
use crate::table::{Table, Unit};
use crate::torsion::{CriticalSpeeds, Node};

/// A table of a shaft that twists.
pub fn table(study: &TorsionStudy, name: &str) -> Option<Table> {
    Some(match name {
        "modes" => modes(study),
        "critical" => critical(study),
        "discs" => discs(study),
        "shapes" => deflections(study, "torsion.shapes", "disc", |speeds| &speeds.mode.shape),
        "cylinders" => deflections(study, "torsion.cylinders", "cylinder", |speeds| &speeds.deflections),
        "forced" => forced(study)?,
        "nodes" => nodes(study),
        "shafts" => damped::shafts(study),
        "resonances" => damped::resonances(study)?,
        "response" => damped::response(study)?,
        "torques" => damped::torques(study)?,
        "speeds" => damped::speeds(study)?,
        "gears" => gears::data(study)?,
        "meshes" => gears::data_of_orders(study)?,
        "mesh_speeds" => gears::data_of_speeds(study)?,
        "excesses" => damped::excesses(study)?,
        "heat" => damped::heat(study)?,
        "dampers" => damped::dampers(study)?,
        _ => return None,
    })
}

fn modes(study: &TorsionStudy) -> Table {
    let mut table = Filling::new("torsion.modes", study.modes.iter().enumerate());
    table.whole("mode", |(index, _)| index + 1);
    table.decimal("frequency_{unit}", Unit::HERTZ, |(_, one)| Some(one.mode.hertz()));
    table.decimal("frequency_{unit}", Unit::PER_MINUTE, |(_, one)| Some(60.0 * one.mode.hertz()));
    table.whole("nodes", |(_, one)| one.mode.nodes());
    table.decimal("longest_star", Unit::NONE, |(_, one)| Some(one.longest));
    table.done()
}

/// What there is of each mode, by the numbers of the mode and its own.
fn of_modes<T>(study: &TorsionStudy, of: fn(&CriticalSpeeds) -> &Vec<T>) -> Vec<(usize, usize, &T)> {
    let all = (1..).zip(&study.modes);
    all.flat_map(|(mode, speeds)| (1..).zip(of(speeds)).map(move |(number, one)| (mode, number, one))).collect()
}

fn critical(study: &TorsionStudy) -> Table {
    let mut table = Filling::new("torsion.critical", of_modes(study, |speeds| &speeds.orders)).keyed(2);
    table.whole("mode", |(mode, ..)| *mode);
    table.exact("order", Unit::NONE, |(.., order)| Some(order.order.exact().to_string()));
    table.decimal("speed_{unit}", Unit::PER_MINUTE, |(.., order)| Some(order.rpm));
    table.decimal("star", Unit::NONE, |(.., order)| Some(order.star.norm()));
    table.decimal("part_{unit}", Unit::PERCENT, |(mode, _, order)| Some(100.0 * study.modes[mode - 1].part(order)));
    table.done()
}

fn discs(study: &TorsionStudy) -> Table {
    let torsion = study.torsion();
    let mut table = Filling::new("torsion.discs", torsion.inertias.iter().enumerate());
    table.whole("disc", |(index, _)| index + 1);
    table.decimal("inertia_{unit}", Unit::KILOGRAM_SQUARE_METRE, |(_, one)| one.to_f64());
    let unit = Unit::NEWTON_METRE_PER_RADIAN;
    table.decimal("stiffness_{unit}", unit, |(index, _)| {
        study.shaft_behind(*index).and_then(|one| one.stiffness.to_f64())
    });
    table.done()
}

/// How far each disc, or the pin of each cylinder, is turned in each mode.
fn deflections(
    study: &TorsionStudy,
    path: &'static str,
    of_what: &'static str,
    deflections: fn(&CriticalSpeeds) -> &Vec<f64>,
) -> Table {
    let mut table = Filling::new(path, of_modes(study, deflections)).keyed(2);
    table.whole("mode", |(mode, ..)| *mode);
    table.whole(of_what, |(_, number, _)| *number);
    table.decimal("deflection", Unit::NONE, |(.., value)| Some(**value));
    table.done()
}

fn nodes(study: &TorsionStudy) -> Table {
    let mut table = Filling::new("torsion.nodes", of_modes(study, |speeds| &speeds.mode.nodes)).keyed(2);
    table.whole("mode", |(mode, ..)| *mode);
    table.whole("node", |(_, node, _)| *node);
    let ends = |place: &Node| place.ends(&study.train).map(|disc| disc + 1);
    table.whole("from_disc", |(.., place)| ends(place)[0]);
    table.whole("to_disc", |(.., place)| ends(place)[1]);
    table.decimal("part", Unit::NONE, |(.., place)| match place {
        Node::Shaft(_, part) => Some(*part),
        Node::Disc(_) => Some(0.0),
    });
    table.done()
}

fn forced(study: &TorsionStudy) -> Option<Table> {
    let mut table = Filling::new("torsion.forced", study.forced());
    table.exact("order", Unit::NONE, |one| Some(one.order.exact().to_string()));
    table.decimal("frequency_{unit}", Unit::HERTZ, |one| Some(one.hertz));
    table.maybe_whole("near_mode", |one| one.near);
    let far = |one: &crate::report::ForcedTwist, value: f64| one.near.is_none().then_some(value);
    table.decimal("free_end_zero_to_peak_{unit}", Unit::DEGREE, |one| far(one, one.free_end));
    table.decimal("shaft_torque_zero_to_peak_{unit}", Unit::NEWTON_METRE, |one| far(one, one.shaft));
    table.whole("behind_disc", |one| study.behind(one));
    table.done_if_any()
}
