//! What is said of forces of gas and masses together: how far a formula is off, which load is the largest?

use super::super::torque::{angle, quantity};
use crate::claim::{Agreement, LargestOf, Loaded, Measured};
use crate::page::number;
use crate::page::{Text, Unit, phrase};

/// How far a formula is off.
pub(super) fn agreement(found: &Agreement) -> Text {
    let largest = measure(found.what, found.largest.value);
    let constant = matches!(
        found.what,
        Measured::ReciprocatingMass | Measured::RotatingMass | Measured::RodLength | Measured::CentrifugalForce
    );
    let percent = || Text::from(number::decimal(100.0 * found.part()));
    match (found.equal, constant) {
        (true, true) => phrase!("It agrees: {}.", largest),
        (false, true) => phrase!("It is {}; the formula is {} % off.", largest, percent()),
        (true, false) => phrase!(
            "At each of {} crank angles of the cycle both are the same to 10⁻⁹ of the largest value, {} at θ {}.",
            found.angles,
            largest,
            angle(found.largest.angle)
        ),
        (false, false) => phrase!(
            "The formula is off by up to {} at θ {}: {} % of the largest value, {} at θ {}.",
            measure(found.what, found.off.value),
            angle(found.off.angle),
            percent(),
            largest,
            angle(found.largest.angle)
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
    let words = match found.of {
        Loaded::MainBearing => "Bearing {} carries the largest load, {} at crank angle {}.",
        Loaded::Crankpin => "The rod of cylinder {} loads its crankpin most, with {} at crank angle {}.",
        Loaded::Rod => "The rod of cylinder {} is compressed most, with {} at crank angle {}.",
        Loaded::Cylinder => "Cylinder {} has the largest side force, {} at crank angle {}.",
    };
    let told = phrase!(words, which, size, at);
    match found.without_gas {
        None => told,
        Some(masses) => phrase!("{} The masses alone give at most {} there.", told, quantity(masses, Unit::NEWTON)),
    }
}
