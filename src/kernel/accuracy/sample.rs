//! What is the largest load at equal steps of the crank angle, from the closed form of the motion, in floats?

use std::f64::consts::TAU;

use num_complex::Complex;

use super::bodies::{phases, turning};
use crate::engine::{Cylinder, Engine, Mechanism};
use crate::exact::Turn;
use crate::loads::Missing;
use crate::motion::SliderCrank;
use crate::numbers::{self, float};
use crate::order;
use crate::proof::Quantity;

/// An engine in doubles.
#[derive(Clone, Debug)]
pub(super) struct Doubles {
    quantity: Quantity,
    pistons: Vec<Piston<Complex<f64>>>,
    rotating: Complex<f64>,
}

/// A piston, and its part in what is asked for.
#[derive(Clone, Debug)]
pub(super) struct Piston<P> {
    pub crank: SliderCrank,
    pub phase: f64,
    pub part: P,
}

/// The pistons of an engine; the part of each from its cylinder and its m r.
pub(super) fn pistons<P>(engine: &Engine, part: impl Fn(&Cylinder, f64) -> P) -> Vec<Piston<P>> {
    let piston = |((cylinder, mechanism), phase): ((&Cylinder, &Mechanism), Turn)| {
        let crank = order::crank(mechanism)?;
        let part = part(cylinder, float(&order::mass_radius(engine, cylinder)));
        Some(Piston { crank, phase: float(phase.turns()) * TAU, part })
    };
    engine.moved().zip(phases(engine)).filter_map(piston).collect()
}

impl Doubles {
    /// # Errors
    /// A crank cannot turn round.
    pub fn new(engine: &Engine, quantity: Quantity) -> Result<Self, Missing> {
        let pistons = pistons(engine, |cylinder, weight| match quantity {
            Quantity::Axial(_) => Complex::new(weight * float(&cylinder.crank_radius), 0.0),
            Quantity::Planar(planar) => {
                let lever = float(&order::lever(engine, planar, &cylinder.position));
                numbers::direction(&cylinder.bank) * (weight * lever)
            }
        });
        let rotating = turning(engine, quantity).into_iter();
        let rotating = rotating.map(|(angle, weight)| numbers::direction(&angle) * float(&weight));
        Ok(Doubles { quantity, rotating: rotating.sum(), pistons })
    }

    /// The largest length at this many angles.
    pub fn peak(&self, angles: u32) -> f64 {
        let length = |place: u32| {
            let theta = TAU * f64::from(place) / f64::from(angles);
            let load = |piston: &Piston<Complex<f64>>| match self.quantity {
                Quantity::Axial(_) => piston.part * piston.crank.torque(theta + piston.phase),
                Quantity::Planar(_) => piston.part * -piston.crank.acceleration(theta + piston.phase),
            };
            let rotating = self.rotating * Complex::cis(theta);
            self.pistons.iter().map(load).fold(rotating, |sum, load| sum + load).norm()
        };
        (0..angles).map(length).fold(0.0, f64::max)
    }
}
