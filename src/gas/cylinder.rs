//! What does the gas of one cylinder do at an angle?

use std::f64::consts::TAU;

use super::error::NoGas;
use super::geometry::Geometry;
use super::harmonics::Harmonics;
use super::law::{Law, float};
use super::{solve, stage};
use crate::engine::{Cycle, DeadCentre, Engine, PressureLaw};

/// One cylinder with its gas, in SI units; angles are ψ in radians.
#[derive(Clone, Debug)]
pub struct CylinderGas {
    geometry: Geometry,
    law: Law,
    crankcase: f64,
    cycle: Cycle,
    heat: Option<f64>,
    zero: f64,
}

impl CylinderGas {
    /// The gas of a cylinder of an engine, by its index.
    ///
    /// # Errors
    /// What the engine lacks.
    pub fn new(engine: &Engine, index: usize) -> Result<Self, NoGas> {
        let (Some(gas), Some(cycle)) = (engine.gas(), engine.cycle()) else { return Err(NoGas::Gas) };
        let chamber = &gas.chambers[index];
        let mut geometry = Geometry::new(engine, index, &chamber.bore)?;
        let zero = match chamber.zero {
            DeadCentre::Crank => 0.0,
            DeadCentre::Piston => geometry.outermost,
        };
        let (law, heat) = match &gas.laws[chamber.law] {
            PressureLaw::Table(table) => (Law::table(table, cycle, zero), None),
            PressureLaw::Cycle(ideal) => {
                geometry.clearance = geometry.swept() / (float(&ideal.compression_ratio) - 1.0);
                let (law, heat) = solve::cycle(ideal, &geometry, cycle, zero)?;
                (law, Some(heat))
            }
            PressureLaw::Stage(stage) => {
                geometry.clearance = geometry.swept() * float(&stage.clearance);
                (stage::law(stage, &geometry)?, None)
            }
        };
        let gas = CylinderGas { geometry, law, crankcase: float(&chamber.crankcase), cycle, heat, zero };
        let is_shown = |value: f64| value.is_finite() && value.abs() < 1e150;
        match is_shown(gas.work()) && is_shown(gas.peak_pressure().0) {
            true => Ok(gas),
            false => Err(NoGas::TooLarge),
        }
    }

    /// Crank, rod and bore.
    pub fn geometry(&self) -> &Geometry {
        &self.geometry
    }

    pub(super) fn law(&self) -> &Law {
        &self.law
    }

    /// Absolute pressure on the other side of the piston.
    pub fn crankcase(&self) -> f64 {
        self.crankcase
    }

    /// Heat released in a cycle in joules; none where the pressure comes from a table, or nothing burns.
    pub fn heat(&self) -> Option<f64> {
        self.heat
    }

    /// Revolutions of a cycle.
    pub fn revolutions(&self) -> u32 {
        match self.cycle {
            Cycle::TwoStroke => 1,
            Cycle::FourStroke => 2,
        }
    }

    /// Length of the cycle in radians.
    pub fn period(&self) -> f64 {
        TAU * f64::from(self.revolutions())
    }

    /// ψ at the angle 0 of the pressure: 0, or where the piston is farthest out.
    pub fn zero(&self) -> f64 {
        self.zero
    }

    /// Absolute pressure in pascals.
    pub fn pressure(&self, psi: f64) -> f64 {
        let (piece, psi) = self.law.at(psi);
        piece.pressure(&self.geometry, psi)
    }

    /// Force F_g on the piston, towards the crank, in newtons.
    pub fn force(&self, psi: f64) -> f64 {
        (self.pressure(psi) - self.crankcase) * self.geometry.area
    }

    /// Force `F_g tan β` of the wall on the piston, in newtons.
    pub fn side(&self, psi: f64) -> f64 {
        self.force(psi) * self.geometry.slope(psi)
    }

    /// Torque of the gas on the crank, in newton-metres.
    pub fn torque(&self, psi: f64) -> f64 {
        self.force(psi) * self.geometry.radius * self.geometry.lever(psi)
    }

    /// The largest pressure, and the angle at which it stands.
    pub fn peak_pressure(&self) -> (f64, f64) {
        self.law.peak(&self.geometry)
    }

    /// Indicated work of a cycle in joules: the area of the loop.
    pub fn work(&self) -> f64 {
        self.law.work(&self.geometry)
    }

    /// Mean indicated pressure in pascals.
    pub fn mean_pressure(&self) -> f64 {
        self.work() / self.geometry.swept()
    }

    /// Angles at which the pressure has a kink, in the cycle that begins with the first of them.
    pub fn kinks(&self) -> impl Iterator<Item = f64> {
        self.law.pieces.iter().map(|piece| piece.from)
    }

    /// The harmonics up to the n-th of the cycle.
    pub fn harmonics(&self, highest: usize) -> Harmonics {
        Harmonics::new(self, highest)
    }
}
