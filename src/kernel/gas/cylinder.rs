//! What does the gas of one cylinder do at an angle?

use std::f64::consts::TAU;

use super::error::NoGas;
use super::geometry::Geometry;
use super::law::Law;
use super::{solve, stage};
use crate::engine::{Cycle, DeadCentre, Engine, PressureLaw};
use crate::motion::float;

/// One cylinder with its gas, in SI units; angles are ψ in radians.
#[derive(Clone, Debug)]
pub struct CylinderGas {
    geometry: Geometry,
    /// The outer side of the piston, and the inner one where it is double-acting.
    sides: Vec<Side>,
    crankcase: f64,
    cycle: Cycle,
    heat: Option<f64>,
    zero: f64,
}

/// A side of a piston.
#[derive(Clone, Debug)]
pub(super) struct Side {
    pub law: Law,
    /// The area that its pressure acts on towards the crank: below 0 on the inner side.
    pub area: f64,
}

impl Side {
    fn pressure(&self, geometry: &Geometry, psi: f64) -> f64 {
        let (piece, psi) = self.law.at(psi);
        piece.pressure(geometry, psi)
    }
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
            DeadCentre::Crank => geometry.crank_of_first(engine.is_second_piston(index)),
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
        let mut sides = vec![Side { law, area: geometry.area }];
        if let Some((below, PressureLaw::Table(table))) = chamber.below.as_ref().map(|one| (one, &gas.laws[one.law])) {
            let area = Geometry::disc(float(&below.rod)) - geometry.area;
            sides.push(Side { law: Law::table(table, cycle, zero), area });
        }
        let gas = CylinderGas { geometry, sides, crankcase: float(&chamber.crankcase), cycle, heat, zero };
        let is_shown = |value: f64| value.is_finite() && value.abs() < 1e150;
        if is_shown(gas.work()) && is_shown(gas.peak_pressure().0) { Ok(gas) } else { Err(NoGas::TooLarge) }
    }

    /// From which crank angle the firing of a cylinder counts, in radians after its crank is in line with its axis: 0 unless the file counts from
    /// where the piston is farthest out.
    pub fn firing_zero(engine: &Engine, index: usize) -> f64 {
        let chamber = engine.gas().map(|gas| &gas.chambers[index]).filter(|chamber| chamber.zero == DeadCentre::Piston);
        let geometry = chamber.and_then(|chamber| Geometry::new(engine, index, &chamber.bore).ok());
        geometry.map_or(0.0, |geometry| geometry.outermost)
    }

    /// Crank, rod and bore.
    pub fn geometry(&self) -> &Geometry {
        &self.geometry
    }

    pub(super) fn sides(&self) -> &[Side] {
        &self.sides
    }

    /// Absolute pressure on the other side of the piston, of a double-acting one on the section of its rod.
    pub fn crankcase(&self) -> f64 {
        self.crankcase
    }

    /// Heat released in a cycle in joules; none where the pressure comes from a table, or nothing burns.
    pub fn heat(&self) -> Option<f64> {
        self.heat
    }

    /// How many pistons share the cylinder: its work is that of all.
    pub fn pistons(&self) -> u32 {
        self.geometry.pistons()
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
        self.sides[0].pressure(&self.geometry, psi)
    }

    /// The same on the inner side of a double-acting piston.
    pub fn pressure_below(&self, psi: f64) -> Option<f64> {
        Some(self.sides.get(1)?.pressure(&self.geometry, psi))
    }

    /// The volume on the inner side of a double-acting piston, without clearance.
    pub fn volume_below(&self, psi: f64) -> f64 {
        let geometry = &self.geometry;
        let above = geometry.volume(geometry.innermost) - geometry.volume(psi);
        self.sides.get(1).map_or(0.0, |side| above * (-side.area / geometry.area))
    }

    /// Force F_g on the piston, towards the crank, in newtons: `p₁A − p₂(A − a) − p_c a`.
    pub fn force(&self, psi: f64) -> f64 {
        self.sides.iter().map(|side| (side.pressure(&self.geometry, psi) - self.crankcase) * side.area).sum()
    }

    /// Torque of the gas on the crank, in newton-metres.
    pub fn torque(&self, psi: f64) -> f64 {
        self.force(psi) * self.geometry.radius * self.geometry.lever(psi)
    }

    /// The largest pressure on the outer side, and the angle at which it stands.
    pub fn peak_pressure(&self) -> (f64, f64) {
        self.sides[0].law.peak(&self.geometry)
    }

    /// Indicated work of a cycle in joules: the area of the loop, of both sides together, and of both pistons where two share the cylinder.
    pub fn work(&self) -> f64 {
        self.sides.iter().map(|side| side.law.work(&self.geometry) * (side.area / self.geometry.area)).sum()
    }

    /// Mean indicated pressure in pascals: the work over the volume that the outer side sweeps.
    pub fn mean_pressure(&self) -> f64 {
        self.work() / self.geometry.swept()
    }

    /// Angles at which the pressure has a kink, in the cycle that begins with the first of them.
    pub fn kinks(&self) -> impl Iterator<Item = f64> {
        let begins = |side: &Side| side.law.pieces.iter().map(|piece| piece.from).collect::<Vec<_>>();
        let mut kinks = begins(&self.sides[0]);
        let first = kinks[0];
        let others = self.sides[1..].iter().flat_map(begins);
        kinks.extend(others.map(|psi| first + (psi - first).rem_euclid(self.period())));
        kinks.sort_by(f64::total_cmp);
        kinks.into_iter()
    }
}
