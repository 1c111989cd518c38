//! What is said of forces of gas and masses together: how far a formula is off, which load is the largest?

use super::super::torque::{angle, quantity};
use crate::claim::{Agreement, LargestOf, Loaded, Measured};
use crate::page::number;
use crate::page::{Text, Unit};
use crate::report::texts::claims as text;

/// How far a formula is off.
pub(super) fn agreement(found: &Agreement) -> Text {
    let largest = measure(found.what, found.largest.value);
    let constant = matches!(
        found.what,
        Measured::ReciprocatingMass | Measured::RotatingMass | Measured::RodLength | Measured::CentrifugalForce
    );
    let percent = || Text::from(number::decimal(100.0 * found.part()));
    match (found.equal, constant) {
        (true, true) => text::constant_agrees(largest),
        // A percentage of 0 says nothing.
        (false, true) if found.largest.value == 0.0 => text::constant_is(largest),
        (false, false) if found.largest.value == 0.0 => {
            text::curve_is(largest, measure(found.what, found.off.value), angle(found.off.angle))
        }
        (false, true) => text::constant_off(largest, percent()),
        (true, false) => text::curve_agrees(found.angles, largest, angle(found.largest.angle)),
        (false, false) => text::curve_off(
            measure(found.what, found.off.value),
            angle(found.off.angle),
            percent(),
            largest,
            angle(found.largest.angle),
        ),
    }
}

fn measure(what: Measured, value: f64) -> Text {
    match what {
        Measured::RodSine => number::decimal(value).into(),
        Measured::Displacement | Measured::RodLength => quantity(value * 1000.0, Unit::MILLIMETRE),
        Measured::Velocity => quantity(value, Unit::METRE_PER_SECOND),
        Measured::Acceleration => quantity(value, Unit::METRE_PER_SQUARE_SECOND),
        Measured::ReciprocatingMass | Measured::RotatingMass => quantity(value, Unit::KILOGRAM),
        Measured::Torque | Measured::ReactionTorque => quantity(value, Unit::NEWTON_METRE),
        Measured::GasForce
        | Measured::InertiaForce
        | Measured::CentrifugalForce
        | Measured::PistonEffort
        | Measured::SideForce
        | Measured::RodForce
        | Measured::RadialForce
        | Measured::CrankEffort
        | Measured::FrameAlong
        | Measured::FrameAcross => quantity(value, Unit::NEWTON),
    }
}

/// A largest load.
pub(super) fn largest(found: &LargestOf) -> Text {
    let (size, at) = (quantity(found.peak.value, Unit::NEWTON), angle(found.peak.angle));
    let which = Text::label(found.which.clone());
    let told = match found.of {
        Loaded::MainBearing => text::worst_bearing(which, size, at),
        Loaded::Crankpin => text::worst_crankpin(which, size, at),
        Loaded::Rod => text::worst_rod(which, size, at),
        Loaded::Cylinder => text::worst_side_force(which, size, at),
    };
    match found.without_gas {
        None => told,
        Some(masses) => text::without_gas(told, quantity(masses, Unit::NEWTON)),
    }
}
