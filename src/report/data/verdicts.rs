//! Which columns hold verdicts, of one engine or of several? A row an order: whether force and moment vanish, what is left, exactly.

use super::super::remaining::{Remaining, RemainingOrder};
use super::super::residual::shape_name;
use super::filling::Filling;
use crate::engine::Engine;
use crate::loads::Arm;
use crate::proof::Shape;
use crate::table::Unit;

/// What the largest values of an engine's verdicts are counted in: forces, moments.
pub fn units(engine: &Engine) -> [Unit; 2] {
    match Arm::of(engine) {
        Arm::Metre => [Unit::OPEN, Unit::OPEN_METRE],
        Arm::Spacing => [Unit::OPEN, Unit::OPEN_SPACING],
    }
}

/// Adds to the number of an order what is left of force and moment, in moments of this unit; those of other rows are omitted.
pub fn of_orders<R>(
    table: &mut Filling<R>,
    order: impl Fn(&R) -> &RemainingOrder,
    moment_units: &[Unit],
    moment_unit: impl Fn(&R) -> Unit,
) {
    table.truth("exists", |row| Some(order(row).exists));
    remaining(table, "force", |row| &order(row).force);
    let largest = |remaining: &Remaining| remaining.largest.as_ref().map(|largest| largest.decimal);
    table.decimal(("{quantity}_zero_to_peak_{unit}", "force"), Unit::OPEN, |row| largest(&order(row).force));
    table.exact(("{quantity}_exact", "force"), Unit::NONE, |row| order(row).force.exact());
    remaining(table, "moment", |row| &order(row).moment);
    for unit in moment_units {
        table.decimal(("{quantity}_zero_to_peak_{unit}", "moment"), *unit, |row| {
            largest(&order(row).moment).filter(|_| moment_unit(row) == *unit)
        });
    }
    table.exact(("{quantity}_exact", "moment"), Unit::NONE, |row| order(row).moment.exact());
    table.truth("moment_is_couple", |row| Some(order(row).moment_is_couple));
}

fn remaining<R>(table: &mut Filling<R>, quantity: &'static str, of: impl Fn(&R) -> &Remaining) {
    table.truth(("{quantity}_vanishes", quantity), |row| vanishes(of(row).shape));
    table.words(("{quantity}_shape", quantity), |row| Some(shape_name(of(row).shape).to_owned()));
}

/// Whether nothing is left. Where the shape is not decided, that something is left may be known all the same: the verdicts of `classify` tell.
fn vanishes(shape: Shape) -> Option<bool> {
    match shape {
        Shape::Balanced | Shape::DoesNotExist => Some(true),
        Shape::Rotating | Shape::CounterRotating | Shape::Planar | Shape::Elliptical => Some(false),
        Shape::NotDecided => None,
    }
}
