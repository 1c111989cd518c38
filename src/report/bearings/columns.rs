//! Which columns do the tables of bearings have in common?

use num_complex::Complex;

use crate::engine::Engine;
use crate::loads::{Arm, Peak};
use crate::report::calculation::data::Units;
use crate::report::data::Filling;
use crate::table::Unit;

/// The unit of the positions of a layout.
pub(super) fn position_unit(engine: &Engine) -> Unit {
    match Arm::of(engine) {
        Arm::Metre => Unit::METRE,
        Arm::Spacing => Unit::SPACING,
    }
}

/// Which crankshaft a row is about, where several are geared together.
pub(in crate::report) fn crankshafts<R>(table: &mut Filling<R>, engine: &Engine, of: impl Fn(&R) -> usize) {
    let cranks = engine.geared_cranks();
    if !cranks.is_empty() {
        table.words("crankshaft", |row| cranks.get(of(row)).map(|crank| crank.name.clone()));
    }
}

/// A largest value, and the crank angle where it is.
pub(super) fn peak<R>(
    table: &mut Filling<R>,
    [size, angle]: [&'static str; 2],
    units: Units,
    of: impl Fn(&R) -> &Peak,
) {
    table.decimal(size, units.force, |row| Some(of(row).value * units.newtons));
    table.decimal(angle, Unit::DEGREE, |row| of(row).angle.filter(|_| of(row).value > 0.0));
}

/// The force on a bearing at a crank angle, along y and along x.
pub(super) fn components<R>(
    table: &mut Filling<R>,
    bearing: usize,
    unit: Unit,
    force: impl Fn(&R) -> Option<Complex<f64>>,
) {
    table.decimal(("bearing_{bearing}_y_{unit}", bearing), unit, |row| force(row).map(|force| force.re));
    table.decimal(("bearing_{bearing}_x_{unit}", bearing), unit, |row| force(row).map(|force| -force.im));
}
