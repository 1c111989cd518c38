//! Which columns hold the values at crank angles? A row a piston, the torque, a main bearing, at an angle.

use crate::journal::PistonAt;
use crate::report::angle::AngleStudy;
use crate::report::bearings::crankshafts;
use crate::report::data::Filling;
use crate::table::{Table, Unit};

/// A table of the values at crank angles.
pub fn table(study: &AngleStudy, name: &str) -> Option<Table> {
    Some(match name {
        "pistons" => pistons(study),
        "torque" => torque(study),
        "bearings" => bearings(study)?,
        _ => return None,
    })
}

fn pistons(study: &AngleStudy) -> Table {
    let mut table = Filling::new("angle.pistons", study.pistons()).keyed(2);
    table.decimal("theta_{unit}", Unit::DEGREE, |row| Some(row.0));
    table.whole("cylinder", |row| row.1.cylinder + 1);
    type Value = fn(&PistonAt) -> Option<f64>;
    let columns: [(&'static str, Unit, Value); 16] = [
        ("psi_{unit}", Unit::DEGREE, |piston| Some(piston.psi)),
        ("displacement_{unit}", Unit::METRE, |piston| Some(piston.way)),
        ("velocity_{unit}", Unit::METRE_PER_SECOND, |piston| piston.velocity),
        ("acceleration_{unit}", Unit::METRE_PER_SQUARE_SECOND, |piston| piston.acceleration),
        ("textbook_velocity_{unit}", Unit::METRE_PER_SECOND, |piston| piston.textbook.map(|both| both[0])),
        ("textbook_acceleration_{unit}", Unit::METRE_PER_SQUARE_SECOND, |piston| piston.textbook.map(|both| both[1])),
        ("gas_{unit}", Unit::NEWTON, |piston| piston.gas),
        ("inertia_{unit}", Unit::NEWTON, |piston| piston.inertia),
        ("weight_{unit}", Unit::NEWTON, |piston| piston.weight),
        ("effort_{unit}", Unit::NEWTON, PistonAt::effort),
        ("rod_{unit}", Unit::NEWTON, PistonAt::rod),
        ("side_{unit}", Unit::NEWTON, PistonAt::side),
        ("torque_{unit}", Unit::NEWTON_METRE, PistonAt::torque),
        ("pin_{unit}", Unit::NEWTON, |piston| piston.pin.map(|pin| pin.norm())),
        ("pin_outward_{unit}", Unit::NEWTON, |piston| piston.pin_on_the_crank.map(|pin| pin.re)),
        ("pin_tangential_{unit}", Unit::NEWTON, |piston| piston.pin_on_the_crank.map(|pin| pin.im)),
    ];
    for (name, unit, of) in columns {
        table.decimal(name, unit, move |row| of(row.1));
    }
    table.done()
}

fn torque(study: &AngleStudy) -> Table {
    let mut table = Filling::new("angle.torque", &study.instants);
    table.decimal("theta_{unit}", Unit::DEGREE, |one| Some(one.theta));
    table.decimal("gas_{unit}", Unit::NEWTON_METRE, |one| one.torque_of(|piston| piston.gas));
    table.decimal("inertia_{unit}", Unit::NEWTON_METRE, |one| one.torque_of_inertia());
    table.decimal("torque_{unit}", Unit::NEWTON_METRE, |one| one.sum(PistonAt::torque));
    table.done()
}

fn bearings(study: &AngleStudy) -> Option<Table> {
    let mut table = Filling::new("angle.bearings", study.bearings()).keyed(2);
    table.decimal("theta_{unit}", Unit::DEGREE, |row| Some(row.0));
    table.whole("bearing", |row| row.1);
    crankshafts(&mut table, &study.engine, |row| study.crank_of(row.1));
    table.decimal("force_{unit}", Unit::NEWTON, |row| Some(row.2.norm()));
    table.decimal("force_y_{unit}", Unit::NEWTON, |row| Some(row.2.re));
    table.decimal("force_x_{unit}", Unit::NEWTON, |row| Some(0.0 - row.2.im));
    table.done_if_any()
}
