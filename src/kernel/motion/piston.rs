//! Where is a piston at an angle, how fast, and how fast does that change, whether its rod is on the crankpin or on another rod?
//!
//! In the frame of its cylinder, lengths in crank radii, the crankpin is at `e^{iψ}`. The knuckle pin of a link stands, seen from there, at
//! the distance `κ/λ` and by `γ = Δ + ε` ahead of the master rod, whose slope is that of the master's angle `ψ + Δ`:
//!
//! `K = e^{iψ} + (κ/λ) e^{iε} (f − iλ sin(ψ+Δ))`, `f = √(1 − λ² sin²(ψ+Δ))`, and the piston at `Re K + √((L/r)² − Im² K)`.

use std::f64::consts::{PI, TAU};

use num_rational::BigRational;

use super::crank::SliderCrank;
use super::enclosure::float;
use super::jet::Jet;
use super::section::{golden_section, halving};

/// The motion of a piston.
#[derive(Clone, Debug)]
pub enum PistonMotion {
    /// By a rod on the crankpin.
    Crank(SliderCrank),
    /// By a link on a master rod.
    Link(LinkMotion),
}

/// The motion of a link that lets the crank turn round.
#[derive(Clone, Debug)]
pub struct LinkMotion {
    /// r/L.
    ratio: f64,
    /// κ = a/l.
    pub(super) knuckle: f64,
    /// λ of the master rod.
    pub(super) master: f64,
    /// Δ in radians.
    pub(super) angle: f64,
    /// Cosine and sine of ε.
    pub(super) correction: [f64; 2],
}

/// Steps of half a turn among which a dead centre is looked for.
const STEPS: usize = 64;
/// Sections after which it is known as well as it can be by its place.
const SECTIONS: u32 = 60;
/// Halvings after which the angle at which the piston stands still is known to its last digits.
const HALVINGS: u32 = 60;

impl LinkMotion {
    /// From r/L, κ and λ, and Δ and ε in turns.
    pub fn new([ratio, knuckle, master]: [&BigRational; 3], [angle, correction]: [&BigRational; 2]) -> Self {
        let (sin, cos) = (float(correction) * TAU).sin_cos();
        LinkMotion {
            ratio: float(ratio),
            knuckle: float(knuckle),
            master: float(master),
            angle: float(angle) * TAU,
            correction: [cos, sin],
        }
    }

    /// The knuckle pin along the axis, but for a constant, and across it.
    pub fn knuckle(&self, psi: f64) -> [Jet; 2] {
        let [cos, sin] = Jet::circle(psi);
        let [_, of_master] = Jet::circle(psi + self.angle);
        let [short, _] = of_master.times(self.master).versed();
        let [along, across] = self.correction;
        // κ/λ (f − 1), which an endless rod leaves at 0.
        let short = if self.master == 0.0 { short } else { short.times(-self.knuckle / self.master) };
        let constant = if across == 0.0 { 0.0 } else { across * self.knuckle / self.master };
        let aside = of_master.times(self.knuckle);
        [
            cos + short.times(along) + aside.times(across),
            sin + Jet::constant(constant) + short.times(across) - aside.times(along),
        ]
    }

    /// What is left out of the place of the knuckle pin along the axis: `(κ/λ) cos ε`. An endless master rod has none that counts.
    pub fn constant(&self) -> f64 {
        if self.master == 0.0 { 0.0 } else { self.correction[0] * self.knuckle / self.master }
    }

    /// tan β of the link.
    pub fn slope(&self, psi: f64) -> f64 {
        let sine = self.knuckle(psi)[1].value * self.ratio;
        sine / ((1.0 - sine) * (1.0 + sine)).sqrt()
    }

    /// The piston along its axis, but for a constant.
    pub fn piston(&self, psi: f64) -> Jet {
        let [along, across] = self.knuckle(psi);
        if self.ratio == 0.0 {
            return along;
        }
        let [short, _] = across.times(self.ratio).versed();
        along - short.times(1.0 / self.ratio)
    }
}

impl PistonMotion {
    /// How far the piston stands from where it is at ψ = 0, outward positive, in crank radii.
    pub fn position(&self, psi: f64) -> f64 {
        match self {
            PistonMotion::Crank(crank) => crank.position(psi),
            PistonMotion::Link(link) => link.piston(psi).value - link.piston(0.0).value,
        }
    }

    /// `s'/r`, outward positive.
    pub fn velocity(&self, psi: f64) -> f64 {
        match self {
            PistonMotion::Crank(crank) => crank.velocity(psi),
            PistonMotion::Link(link) => link.piston(psi).first,
        }
    }

    /// `s''/r`, outward positive.
    pub fn acceleration(&self, psi: f64) -> f64 {
        match self {
            PistonMotion::Crank(crank) => crank.acceleration(psi),
            PistonMotion::Link(link) => link.piston(psi).second,
        }
    }

    /// tan β of the rod that the piston hangs on.
    pub fn slope(&self, psi: f64) -> f64 {
        match self {
            PistonMotion::Crank(crank) => crank.rod_slope(psi),
            PistonMotion::Link(link) => link.slope(psi),
        }
    }

    /// The angles at which the piston is farthest out, within half a turn of 0, and farthest in, within half a turn of half a turn.
    pub fn dead_centres(&self) -> [f64; 2] {
        match self {
            PistonMotion::Crank(crank) => crank.dead_centres(),
            PistonMotion::Link(_) => [self.dead_centre(0.0, 1.0), self.dead_centre(PI, -1.0)],
        }
    }

    /// Where the piston is farthest out (sign 1) or in (−1) within half a turn of an angle: by its place, then where it stands still.
    fn dead_centre(&self, about: f64, sign: f64) -> f64 {
        let step = PI / STEPS as f64;
        let place = |psi: f64| sign * self.position(psi);
        let grid = (0..2 * STEPS).map(|index| about + (index as f64 - STEPS as f64) * step);
        let best = grid.fold(about, |best, psi| if place(psi) > place(best) { psi } else { best });
        let top = golden_section(best - step, best + step, SECTIONS, place);
        let (low, high) = (top - step / 8.0, top + step / 8.0);
        if sign * self.velocity(low) <= 0.0 || sign * self.velocity(high) >= 0.0 {
            return top;
        }
        halving(low, high, HALVINGS, |psi| sign * self.velocity(psi) > 0.0)
    }
}
