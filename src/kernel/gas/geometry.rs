//! Where is the piston, and how much room does it leave?

use std::f64::consts::{PI, TAU};

use num_rational::BigRational;

use super::error::NoGas;
use crate::engine::Engine;
use crate::motion::{PistonMotion, float, halving};

/// Crank, rod and bore of a cylinder, in SI units. Where two pistons share it, lever and slope are those of the one that ψ is of, and the volume is
/// that between both.
#[derive(Clone, Debug)]
pub struct Geometry {
    motion: PistonMotion,
    /// The piston on the other side of the volume.
    facing: Option<Facing>,
    /// Crank radius r.
    pub radius: f64,
    /// Area A of the piston.
    pub area: f64,
    /// Angle at which the piston is farthest out: of a rod on the crankpin `sin ψ = δ/(1 + λ)`. Of two pistons, where they are nearest.
    pub outermost: f64,
    /// Angle at which it is farthest in, in (π/2, 3π/2); of two, where they are farthest apart, in the turn after the outermost place.
    pub innermost: f64,
    /// Volume that is left at the outermost place.
    pub clearance: f64,
}

/// A piston that faces another.
#[derive(Clone, Debug)]
struct Facing {
    motion: PistonMotion,
    /// Its crank radius over that of the other.
    radius: f64,
    /// By how much its crank is ahead, in radians.
    ahead: f64,
}

/// Steps of a turn among which the places are looked for where two pistons are nearest and farthest apart.
const STEPS: usize = 720;
/// Halvings after which the angle at which the volume stands still is known to its last digits.
const HALVINGS: u32 = 60;
/// Two pistons that change their volume by less than this part of what each sweeps move together.
const STILL: f64 = 1e-6;

impl Geometry {
    /// That of a cylinder, without clearance.
    pub(super) fn new(engine: &Engine, index: usize, bore: &BigRational) -> Result<Self, NoGas> {
        let cylinder = &engine.cylinders()[index];
        let Some(mechanism) = &cylinder.mechanism else { return Err(NoGas::Rods) };
        let Some(radius) = engine.dimensions().crank_radius.as_ref() else { return Err(NoGas::Radius) };
        let motion = mechanism.piston();
        let bore = float(bore);
        let [outermost, innermost] = motion.dead_centres();
        let geometry = Geometry {
            radius: float(&(radius * &cylinder.crank_radius)),
            area: Geometry::disc(bore),
            facing: None,
            outermost,
            innermost,
            clearance: 0.0,
            motion,
        };
        let Some((partner, lead)) = engine.partner(index).zip(engine.lead(index)) else { return Ok(geometry) };
        let other = &engine.cylinders()[partner];
        let Some(mechanism) = &other.mechanism else { return Err(NoGas::Rods) };
        geometry.between(Facing {
            motion: mechanism.piston(),
            radius: float(&(&other.crank_radius / &cylinder.crank_radius)),
            ahead: -float(&lead) * TAU,
        })
    }

    /// The same with the piston that faces it.
    fn between(self, facing: Facing) -> Result<Self, NoGas> {
        let (alone, sweeps) = (self.swept(), facing.radius.max(1.0));
        let mut both = Geometry { facing: Some(facing), ..self };
        let step = TAU / STEPS as f64;
        let best = |from: f64, sign: f64| {
            let out = |psi: &f64| sign * both.out(*psi);
            let places = (0..STEPS).map(|place| from + place as f64 * step);
            let near = places.max_by(|one, other| out(one).total_cmp(&out(other))).unwrap_or(from);
            both.still(near, step)
        };
        let outermost = best(-PI, 1.0);
        let innermost = best(outermost, -1.0);
        (both.outermost, both.innermost) = (outermost, innermost);
        if both.swept() > STILL * alone * sweeps { Ok(both) } else { Err(NoGas::Still) }
    }

    /// Where the volume stands still, within a step of this place; the place itself where it does not.
    fn still(&self, near: f64, step: f64) -> f64 {
        let (low, high) = (near - step, near + step);
        let rises = |psi: f64| self.speed(psi) > 0.0;
        let at_first = rises(low);
        if rises(high) == at_first {
            return near;
        }
        halving(low, high, HALVINGS, |psi| rises(psi) == at_first)
    }

    /// How far out the pistons are that bound the volume, in crank radii, but for a constant.
    fn out(&self, psi: f64) -> f64 {
        let of_other = |other: &Facing| other.radius * other.motion.position(psi + other.ahead);
        self.motion.position(psi) + self.facing.as_ref().map_or(0.0, of_other)
    }

    /// How fast that changes.
    fn speed(&self, psi: f64) -> f64 {
        let of_other = |other: &Facing| other.radius * other.motion.velocity(psi + other.ahead);
        self.motion.velocity(psi) + self.facing.as_ref().map_or(0.0, of_other)
    }

    /// How many pistons bound the volume.
    pub(super) fn pistons(&self) -> u32 {
        if self.facing.is_some() { 2 } else { 1 }
    }

    /// ψ at which the crank of the piston by which the cylinder is told points along its axis: 0 of the one that ψ is of.
    pub(super) fn crank_of_first(&self, is_second: bool) -> f64 {
        self.facing.as_ref().filter(|_| is_second).map_or(0.0, |first| -first.ahead)
    }

    /// The area of a disc of this diameter.
    pub(super) fn disc(diameter: f64) -> f64 {
        PI / 4.0 * diameter * diameter
    }

    /// The volume that the piston sweeps, or both together.
    pub fn swept(&self) -> f64 {
        self.area * self.radius * (self.out(self.outermost) - self.out(self.innermost))
    }

    /// The volume of the cylinder.
    pub fn volume(&self, psi: f64) -> f64 {
        let way = self.out(self.outermost) - self.out(psi);
        self.clearance + self.area * self.radius * way
    }

    /// `dV/dψ`.
    pub fn volume_slope(&self, psi: f64) -> f64 {
        -self.area * self.radius * self.speed(psi)
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
