//! Where is the piston, and how much room does it leave?

use std::f64::consts::PI;

use num_rational::BigRational;
use num_traits::ToPrimitive;

use super::error::NoGas;
use crate::engine::Engine;
use crate::motion::PistonMotion;

/// Crank, rod and bore of a cylinder, in SI units.
#[derive(Clone, Debug)]
pub struct Geometry {
    motion: PistonMotion,
    /// Crank radius r.
    pub radius: f64,
    /// Area A of the piston.
    pub area: f64,
    /// Angle at which the piston is farthest out: of a rod on the crankpin `sin ψ = δ/(1 + λ)`.
    pub outermost: f64,
    /// Angle at which it is farthest in, in (π/2, 3π/2).
    pub innermost: f64,
    /// Volume that is left at the outermost place.
    pub clearance: f64,
}

impl Geometry {
    /// That of a cylinder, without clearance.
    pub(super) fn new(engine: &Engine, index: usize, bore: &BigRational) -> Result<Self, NoGas> {
        let cylinder = &engine.cylinders()[index];
        let Some(mechanism) = &cylinder.mechanism else { return Err(NoGas::Rods) };
        let Some(radius) = engine.dimensions().crank_radius.as_ref() else { return Err(NoGas::Radius) };
        let motion = mechanism.piston();
        let float = |number: &BigRational| number.to_f64().unwrap_or(f64::NAN);
        let bore = float(bore);
        let [outermost, innermost] = motion.dead_centres();
        Ok(Geometry {
            radius: float(&(radius * &cylinder.crank_radius)),
            area: Geometry::disc(bore),
            outermost,
            innermost,
            clearance: 0.0,
            motion,
        })
    }

    /// The area of a disc of this diameter.
    pub(super) fn disc(diameter: f64) -> f64 {
        PI / 4.0 * diameter * diameter
    }

    /// The volume that the piston sweeps.
    pub fn swept(&self) -> f64 {
        self.area * self.radius * (self.motion.position(self.outermost) - self.motion.position(self.innermost))
    }

    /// The volume of the cylinder.
    pub fn volume(&self, psi: f64) -> f64 {
        let way = self.motion.position(self.outermost) - self.motion.position(psi);
        self.clearance + self.area * self.radius * way
    }

    /// `dV/dψ`.
    pub fn volume_slope(&self, psi: f64) -> f64 {
        -self.area * self.radius * self.motion.velocity(psi)
    }

    /// `s'/r`: the lever of the piston effort, with its sign changed.
    pub fn lever(&self, psi: f64) -> f64 {
        -self.motion.velocity(psi)
    }

    /// `d(−s'/r)/dψ`.
    pub(super) fn lever_slope(&self, psi: f64) -> f64 {
        -self.motion.acceleration(psi)
    }

    /// `tan β`, the slope of the rod.
    pub fn slope(&self, psi: f64) -> f64 {
        self.motion.slope(psi)
    }
}
