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
        "shapes" => shapes(study),
        "cylinders" => cylinders(study),
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
    let rows: Vec<_> = study.modes.iter().enumerate().collect();
    let mut table = Filling::new("torsion.modes", &rows);
    table.whole("mode", |(index, _)| index + 1);
    table.decimal("frequency_{unit}", Unit::HERTZ, |(_, one)| Some(one.mode.hertz()));
    table.decimal("frequency_{unit}", Unit::PER_MINUTE, |(_, one)| Some(60.0 * one.mode.hertz()));
    table.whole("nodes", |(_, one)| one.mode.nodes());
    table.decimal("longest_star", Unit::NONE, |(_, one)| Some(one.longest));
    table.done()
}

fn critical(study: &TorsionStudy) -> Table {
    let rows: Vec<_> = study
        .modes
        .iter()
        .enumerate()
        .flat_map(|(index, speeds)| speeds.orders.iter().map(move |order| (index + 1, speeds, order)))
        .collect();
    let mut table = Filling::new("torsion.critical", &rows).keyed(2);
    table.whole("mode", |(mode, ..)| *mode);
    table.exact("order", Unit::NONE, |(.., order)| Some(order.order.exact().to_string()));
    table.decimal("speed_{unit}", Unit::PER_MINUTE, |(.., order)| Some(order.rpm));
    table.decimal("star", Unit::NONE, |(.., order)| Some(order.star.norm()));
    table.decimal("part_{unit}", Unit::PERCENT, |(_, speeds, order)| Some(100.0 * order.star.norm() / speeds.longest));
    table.done()
}

fn discs(study: &TorsionStudy) -> Table {
    let torsion = study.torsion();
    let rows: Vec<_> = torsion.inertias.iter().enumerate().collect();
    let mut table = Filling::new("torsion.discs", &rows);
    table.whole("disc", |(index, _)| index + 1);
    table.decimal("inertia_{unit}", Unit::KILOGRAM_SQUARE_METRE, |(_, one)| one.to_f64());
    let unit = Unit::NEWTON_METRE_PER_RADIAN;
    table.decimal("stiffness_{unit}", unit, |(index, _)| {
        study.shaft_behind(*index).and_then(|one| one.stiffness.to_f64())
    });
    table.done()
}

fn shapes(study: &TorsionStudy) -> Table {
    let rows: Vec<_> = study
        .modes
        .iter()
        .enumerate()
        .flat_map(|(mode, speeds)| {
            speeds.mode.shape.iter().enumerate().map(move |(disc, value)| (mode + 1, disc + 1, value))
        })
        .collect();
    let mut table = Filling::new("torsion.shapes", &rows).keyed(2);
    table.whole("mode", |(mode, ..)| *mode);
    table.whole("disc", |(_, disc, _)| *disc);
    table.decimal("deflection", Unit::NONE, |(.., value)| Some(**value));
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
    let mut table = Filling::new("torsion.cylinders", &rows).keyed(2);
    table.whole("mode", |(mode, ..)| *mode);
    table.whole("cylinder", |(_, cylinder, _)| *cylinder);
    table.decimal("deflection", Unit::NONE, |(.., value)| Some(**value));
    table.done()
}

fn nodes(study: &TorsionStudy) -> Table {
    let of_mode = |(mode, speeds): (usize, &CriticalSpeeds)| {
        let places: Vec<Node> = speeds.mode.nodes.clone();
        places.into_iter().enumerate().map(move |(node, place)| (mode + 1, node + 1, place))
    };
    let rows: Vec<_> = study.modes.iter().enumerate().flat_map(of_mode).collect();
    let mut table = Filling::new("torsion.nodes", &rows).keyed(2);
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
    let rows = study.forced();
    if rows.is_empty() {
        return None;
    }
    let mut table = Filling::new("torsion.forced", &rows);
    table.exact("order", Unit::NONE, |one| Some(one.order.exact().to_string()));
    table.decimal("frequency_{unit}", Unit::HERTZ, |one| Some(one.hertz));
    table.maybe_whole("near_mode", |one| one.near);
    let far = |one: &crate::report::ForcedTwist, value: f64| one.near.is_none().then_some(value);
    table.decimal("free_end_zero_to_peak_{unit}", Unit::DEGREE, |one| far(one, one.free_end));
    table.decimal("shaft_torque_zero_to_peak_{unit}", Unit::NEWTON_METRE, |one| far(one, one.shaft));
    table.whole("behind_disc", |one| study.behind(one));
    Some(table.done())
}
