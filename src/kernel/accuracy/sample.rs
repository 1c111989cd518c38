//! What is the largest load at equal steps of the crank angle, from the closed form of the motion, in floats?

use std::f64::consts::TAU;

use num_complex::Complex;

use super::bodies::{phases, turning};
use crate::engine::Engine;
use crate::loads::Missing;
use crate::motion::SliderCrank;
use crate::numbers::{self, float};
use crate::order;
use crate::proof::Quantity;

/// An engine in doubles.
#[derive(Clone, Debug)]
pub(super) struct Doubles {
    quantity: Quantity,
    pistons: Vec<Piston>,
    rotating: Complex<f64>,
}

#[derive(Clone, Debug)]
struct Piston {
    crank: SliderCrank,
    phase: f64,
    part: Complex<f64>,
}

impl Doubles {
    /// # Errors
    /// A crank cannot turn round.
    pub fn new(engine: &Engine, quantity: Quantity) -> Result<Self, Missing> {
        let mut pistons = Vec::new();
        for ((cylinder, mechanism), phase) in engine.moved().zip(phases(engine)) {
            let Some(crank) = order::crank(mechanism) else { continue };
            let weight = float(&order::mass_radius(engine, cylinder));
            let part = match quantity {
                Quantity::Axial(_) => Complex::new(weight * float(&cylinder.crank_radius), 0.0),
                Quantity::Planar(planar) => {
                    let lever = float(&order::lever(engine, planar, &cylinder.position));
                    numbers::direction(&cylinder.bank) * (weight * lever)
                }
            };
            pistons.push(Piston { crank, phase: float(phase.turns()) * TAU, part });
        }
        let rotating = turning(engine, quantity).into_iter();
        let rotating = rotating.map(|(angle, weight)| numbers::direction(&angle) * float(&weight));
        Ok(Doubles { quantity, rotating: rotating.sum(), pistons })
    }

    /// The largest length at this many angles.
    pub fn peak(&self, angles: u32) -> f64 {
        let length = |place: u32| {
            let theta = TAU * f64::from(place) / f64::from(angles);
            let load = |piston: &Piston| match self.quantity {
                Quantity::Axial(_) => piston.part * piston.crank.torque(theta + piston.phase),
                Quantity::Planar(_) => piston.part * -piston.crank.acceleration(theta + piston.phase),
            };
            let rotating = self.rotating * Complex::cis(theta);
            self.pistons.iter().map(load).fold(rotating, |sum, load| sum + load).norm()
        };
        (0..angles).map(length).fold(0.0, f64::max)
    }
}
