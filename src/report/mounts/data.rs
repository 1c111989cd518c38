//! Which columns hold how an engine shakes on its mounts? Modes, orders, places, mount forces, a range of speeds.

use num_complex::Complex;

use crate::mounts::Phasors;
use crate::numbers;
use crate::report::data::Filling;
use crate::report::{MountsStudy, OrderMotion, Place};
use crate::table::{Table, Unit};

const AXES: [&str; 3] = ["x", "y", "z"];

/// A table of an engine on its mounts.
pub fn table(study: &MountsStudy, name: &str) -> Option<Table> {
    Some(match name {
        "modes" => modes(study),
        "orders" => orders(study),
        "places" => places(study),
        "forces" => forces(study),
        "rms" => rms(study),
        "speeds" => speeds(study),
        "critical" => critical(study),
        "axis" => axis(study)?,
        _ => return None,
    })
}

/// A column along or about each axis.
fn axes<R>(table: &mut Filling<R>, pattern: &'static str, unit: Unit, of: impl Fn(&R, usize) -> Option<f64>) {
    for (index, axis) in AXES.into_iter().enumerate() {
        table.decimal((pattern, axis), unit, |row| of(row, index));
    }
}

fn order(motion: &OrderMotion) -> Option<String> {
    Some(motion.excitation.order.exact().to_string())
}

fn peak(part: Complex<f64>, scale: f64) -> Option<f64> {
    Some(numbers::length(part) * scale)
}

fn place(of: Place) -> Option<String> {
    Some(match of {
        Place::Centre => "centre".to_owned(),
        Place::Point => "point".to_owned(),
        Place::Mount(mount) => format!("mount {}", mount + 1),
    })
}

fn modes(study: &MountsStudy) -> Table {
    let mut table = Filling::new("mounts.modes", study.modes.iter().enumerate());
    table.whole("mode", |(index, _)| index + 1);
    table.decimal("frequency_{unit}", Unit::HERTZ, |(_, mode)| Some(mode.hertz()));
    axes(&mut table, "share_{axis}_{unit}", Unit::PERCENT, |(_, mode), axis| Some(100.0 * mode.shares[axis]));
    axes(&mut table, "share_turn_{axis}_{unit}", Unit::PERCENT, |(_, mode), axis| Some(100.0 * mode.shares[3 + axis]));
    axes(&mut table, "shape_{axis}", Unit::NONE, |(_, mode), axis| Some(mode.shape[axis]));
    axes(&mut table, "shape_turn_{axis}", Unit::NONE, |(_, mode), axis| Some(mode.shape[3 + axis]));
    table.done()
}

fn orders(study: &MountsStudy) -> Table {
    let mut table = Filling::new("mounts.orders", &study.orders);
    table.exact("order", Unit::NONE, |one| order(one));
    table.truth("force_is_zero", |one| Some(one.excitation.still.force));
    table.truth("moment_is_zero", |one| Some(one.excitation.still.moment));
    table.truth("roll_is_zero", |one| Some(one.excitation.still.roll));
    table.truth("is_still", |one| Some(one.excitation.still.is_whole()));
    axes(&mut table, "force_{axis}_{unit}", Unit::NEWTON, |one, axis| peak(one.load[0][axis], 1.0));
    axes(&mut table, "moment_{axis}_{unit}", Unit::NEWTON_METRE, |one, axis| peak(one.load[1][axis], 1.0));
    axes(&mut table, "centre_{axis}_{unit}", Unit::MILLIMETRE, |one, axis| {
        peak(one.motion.as_ref()?.centre[axis], 1e3)
    });
    axes(&mut table, "turn_{axis}_{unit}", Unit::MILLIRADIAN, |one, axis| peak(one.motion.as_ref()?.turned[axis], 1e3));
    table.done()
}

fn places(study: &MountsStudy) -> Table {
    let rows = study.places().into_iter().flat_map(|of| study.orders.iter().map(move |order| (of, order)));
    let moved = |of: &Place, one: &OrderMotion| -> Option<(Phasors, f64)> {
        let motion = one.motion.as_ref()?;
        Some((study.displacement(*of, motion), motion.omega))
    };
    let mut table = Filling::new("mounts.places", rows).keyed(2);
    table.words("place", |(of, _)| place(*of));
    table.exact("order", Unit::NONE, |(_, one)| order(one));
    axes(&mut table, "displacement_{axis}_{unit}", Unit::MILLIMETRE, |(of, one), axis| {
        peak(moved(of, one)?.0[axis], 1e3)
    });
    axes(&mut table, "velocity_{axis}_{unit}", Unit::MILLIMETRE_PER_SECOND, |(of, one), axis| {
        let (moved, omega) = moved(of, one)?;
        peak(moved[axis], 1e3 * omega)
    });
    table.done()
}

fn forces(study: &MountsStudy) -> Table {
    let mounts = 0..study.body.mounts();
    let rows = mounts.flat_map(|mount| study.orders.iter().map(move |order| (mount, order)));
    let mut table = Filling::new("mounts.forces", rows).keyed(2);
    table.whole("mount", |(mount, _)| mount + 1);
    table.exact("order", Unit::NONE, |(_, one)| order(one));
    axes(&mut table, "force_{axis}_{unit}", Unit::NEWTON, |(mount, one), axis| {
        peak(study.body.mount_force(*mount, one.motion.as_ref()?)[axis], 1.0)
    });
    table.done()
}

fn rms(study: &MountsStudy) -> Table {
    let mut table = Filling::new("mounts.rms", study.places());
    table.words("place", |of| place(*of));
    let rms = |of: &Place, derivative: i32, axis: usize| Some(study.rms(*of, derivative)?[axis]);
    let (displacement, velocity) = (Unit::MILLIMETRE, Unit::MILLIMETRE_PER_SECOND);
    axes(&mut table, "displacement_{axis}_rms_{unit}", displacement, |of, axis| Some(rms(of, 0, axis)? * 1e3));
    axes(&mut table, "velocity_{axis}_rms_{unit}", velocity, |of, axis| Some(rms(of, 1, axis)? * 1e3));
    axes(&mut table, "acceleration_{axis}_rms_{unit}", Unit::METRE_PER_SQUARE_SECOND, |of, axis| rms(of, 2, axis));
    table.done()
}

fn speeds(study: &MountsStudy) -> Table {
    let mut table = Filling::new("mounts.speeds", study.range()).keyed(2);
    table.decimal("speed_{unit}", Unit::PER_MINUTE, |at| Some(at.rpm));
    table.exact("order", Unit::NONE, |at| order(&study.orders[at.order]));
    table.decimal("velocity_{unit}", Unit::MILLIMETRE_PER_SECOND, |at| Some(at.velocity? * 1e3));
    table.decimal("mount_force_{unit}", Unit::NEWTON, |at| at.force);
    table.done()
}

fn critical(study: &MountsStudy) -> Table {
    let rows = study
        .modes
        .iter()
        .enumerate()
        .flat_map(|(index, mode)| study.orders.iter().map(move |order| (index + 1, mode, order)));
    let mut table = Filling::new("mounts.critical", rows).keyed(2);
    table.whole("mode", |(number, ..)| *number);
    table.exact("order", Unit::NONE, |(.., one)| order(one));
    table.decimal("speed_{unit}", Unit::PER_MINUTE, |(_, mode, one)| Some(one.excitation.order.rpm(mode.hertz())));
    table.truth("is_still", |(.., one)| Some(one.excitation.still.is_whole()));
    table.done()
}

fn axis(study: &MountsStudy) -> Option<Table> {
    let mut table = Filling::new("mounts.axis", [study.axis.as_ref()?]).keyed(0);
    axes(&mut table, "direction_{axis}", Unit::NONE, |of, axis| Some(of.direction[axis]));
    table.decimal("from_crankshaft_{unit}", Unit::DEGREE, |axis| Some(axis.from_crankshaft));
    table.decimal("frequency_{unit}", Unit::HERTZ, |axis| Some(axis.hertz));
    table.decimal("coupling_{unit}", Unit::PERCENT, |axis| Some(100.0 * axis.coupling));
    Some(table.done())
}
