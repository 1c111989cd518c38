//! Which terms does a source add to the roll moment on the frame?
//!
//! A piston adds its force times the arm of its axis, before c_k, and `∓t_k`, before t_k, on a crank that turns with or against the
//! reference; both are at `k(β − α)`. The axis of a crankshaft at distance d in the direction η gives the arm `d sin(α − η)`: nothing
//! where that sine is 0, one vector where it is ±1, else `d/2` at `α − η − 90°` and `d/2` at the opposite angle. An offset gives
//! `−e = −(δ/λ) r`, and `+e` on a crank against the reference. A mass-radius U that turns n times about such an axis adds
//! `n²Ud` at `±(γ − η − 90°)`.

use num_bigint::BigInt;
use num_rational::BigRational;
use num_traits::{One, Zero};

use super::collected::turn;
use super::engine::{Cylinder, TurningMassClaim};
use super::quantity::Sense;
use super::vector::Vector;
use super::verdict::phase;

fn quarter(count: i64) -> BigRational {
    BigRational::new(count.into(), 4.into())
}

/// The arm of a cylinder's axis about the middle of the engine, in common radii.
pub(super) fn arms(cylinder: &Cylinder) -> Vec<Vector> {
    let mut arms = Vec::new();
    let crank = cylinder.crankshaft.as_ref();
    for axis in crank.map_or(&[][..], |crank| &crank.axis) {
        let across = turn(&(&cylinder.bank - &axis.angle - quarter(1)));
        let halves = |part: i64| &axis.weight / BigRational::from_integer(part.into());
        if across == quarter(1) || across == quarter(3) {
            continue;
        }
        if across.is_zero() || across == quarter(2) {
            arms.push(Vector { angle: across, weight: halves(1) });
        } else {
            arms.push(Vector { angle: -&across, weight: halves(2) });
            arms.push(Vector { angle: across, weight: halves(2) });
        }
    }
    if let Some(rod) = cylinder.rod.on_the_pin().filter(|rod| !rod.offset.is_zero() && !rod.ratio.is_zero()) {
        let offset = &rod.offset * &cylinder.crank_radius / &rod.ratio;
        let weight = if is_against(cylinder) { offset } else { -offset };
        arms.push(Vector { angle: BigRational::zero(), weight });
    }
    arms
}

/// The terms of a piston's force of this order of its own motion, whose vector is multiplied by its coefficient with these parts.
pub(super) fn of_force(cylinder: &Cylinder, order: u32, parts: &[Vector]) -> Vec<Vector> {
    let star = phase(&cylinder.throw, &cylinder.bank, order, None);
    let size = &cylinder.reciprocating_mass * &cylinder.crank_radius * cylinder.power(2);
    let arms = arms(cylinder);
    let of_part = |part: &Vector| -> Vec<Vector> {
        let vector = |arm: &Vector| Vector {
            angle: &star + &part.angle + &arm.angle,
            weight: &size * &part.weight * &arm.weight,
        };
        arms.iter().map(vector).collect()
    };
    parts.iter().flat_map(of_part).collect()
}

/// The term of the torque on a piston's crank, of this order of its own motion.
pub(super) fn of_torque(cylinder: &Cylinder, order: u32) -> Vec<Vector> {
    let size = &cylinder.reciprocating_mass * &cylinder.crank_radius * &cylinder.crank_radius * cylinder.power(2);
    let weight = if is_against(cylinder) { size } else { -size };
    vec![Vector { angle: phase(&cylinder.throw, &cylinder.bank, order, None), weight }]
}

/// The terms of a mass that turns, whose vector is multiplied by its coefficient with these parts.
pub(super) fn of_turning(mass: &TurningMassClaim, parts: &[Vector]) -> Vec<Vector> {
    let square = BigRational::from_integer(BigInt::from(mass.order) * mass.order);
    let sign = mass.sense.signed(BigRational::one());
    let term = |axis: &Vector, part: &Vector| Vector {
        angle: &sign * (&mass.angle - &axis.angle - quarter(1)) + &part.angle,
        weight: &square * &mass.mass_radius * &axis.weight * &part.weight,
    };
    parts.iter().flat_map(|part| mass.axis.iter().map(|axis| term(axis, part)).collect::<Vec<_>>()).collect()
}

fn is_against(cylinder: &Cylinder) -> bool {
    cylinder.crankshaft.as_ref().is_some_and(|crank| crank.sense == Sense::Reverse)
}
