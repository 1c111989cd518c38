//! How evenly does the engine turn, and which flywheel makes it turn as evenly as it should?
//!
//! At a constant load `J = ΔW/(δ ω̄²)`, ΔW the largest less the smallest work of the torque above its mean, δ the largest less the smallest
//! speed over their arithmetic mean: exact, with the inertia torque of the mean speed. With the energy of the reciprocating mass
//! `½ (J + Σ m s'²) ω² = E₀ + ∫ (T_gas − T̄) dθ`; nearly that comes of J and the mean of `Σ m s'²` in place of J.

use super::curve::TorqueCurve;
use super::extreme::Extreme;
use crate::engine::Engine;
use crate::motion::halving;
use crate::numbers::float;

/// How evenly an engine turns at its speed.
#[derive(Clone, Debug)]
pub struct Evenness {
    /// ΔW: what the flywheel takes up and gives back, in joules.
    pub energy: f64,
    /// Where the speed is largest.
    pub fastest: Extreme,
    /// Where it is smallest.
    pub slowest: Extreme,
    /// Mean of `Σ m s'²`, in kilograms times square metres.
    pub reciprocating: f64,
    /// What the inertia of the layout makes of it.
    pub given: Option<Given>,
    /// What the irregularity of the layout, or a usual one, needs.
    pub needed: Needed,
}

/// The irregularity at an inertia.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Given {
    /// Inertia J of all that turns with the crank.
    pub inertia: f64,
    /// `δ = ΔW/(J ω̄²)`.
    pub irregularity: f64,
    /// With the mean of `Σ m s'²` added to J.
    pub refined: f64,
    /// By the balance of energy.
    pub by_energy: Option<f64>,
}

/// The inertia for an irregularity.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Needed {
    /// δ.
    pub irregularity: f64,
    /// Whether it is none of the layout's, but an example.
    pub is_example: bool,
    /// `J = ΔW/(δ ω̄²)`, of all that turns with the crank.
    pub inertia: f64,
    /// Less the mean of `Σ m s'²`, not below 0.
    pub refined: f64,
}

/// The irregularity that is shown where none is asked for: that of a generator.
const EXAMPLE: f64 = 0.01;
/// Halvings of the energy at the beginning.
const HALVINGS: u32 = 100;

/// How evenly an engine turns at this speed, in radians a second.
pub fn evenness(engine: &Engine, course: &TorqueCurve, omega: f64) -> Evenness {
    let [fastest, slowest] = course.extremes(|theta| course.work(theta));
    let energy = fastest.value - slowest.value;
    let squared = omega * omega;
    let reciprocating =
        course.angles().map(|theta| course.reduced_inertia(theta)).sum::<f64>() / course.angles().count() as f64;
    let flywheel = engine.flywheel();
    let given = flywheel.inertia.as_ref().map(|inertia| {
        let inertia = float(inertia);
        Given {
            inertia,
            irregularity: energy / (inertia * squared),
            refined: energy / ((inertia + reciprocating) * squared),
            by_energy: by_energy(course, inertia, omega),
        }
    });
    let irregularity = flywheel.irregularity.as_ref().map_or(EXAMPLE, float);
    let inertia = energy / (irregularity * squared);
    let needed = Needed {
        irregularity,
        is_example: flywheel.irregularity.is_none(),
        inertia,
        refined: (inertia - reciprocating).max(0.0),
    };
    Evenness { energy, fastest, slowest, reciprocating, given, needed }
}

/// The irregularity by the balance of energy: its beginning is where the mean of largest and smallest speed is the given one. None where
/// the flywheel is too light to carry the engine through its cycle.
pub fn by_energy(course: &TorqueCurve, inertia: f64, omega: f64) -> Option<f64> {
    let grid: Vec<(f64, f64)> =
        course.angles().map(|theta| (course.gas_work(theta), inertia + course.reduced_inertia(theta))).collect();
    let speed = |energy: f64, (work, inertia): (f64, f64)| (2.0 * (energy + work) / inertia).max(0.0).sqrt();
    let middle = |energy: f64| {
        let speeds = grid.iter().map(|&point| speed(energy, point));
        let (low, high) = speeds.fold((f64::INFINITY, 0.0_f64), |(low, high), v| (low.min(v), high.max(v)));
        (low + high) / 2.0
    };
    let least = grid.iter().map(|(work, _)| -work).fold(f64::NEG_INFINITY, f64::max);
    let most =
        grid.iter().map(|(work, inertia)| 2.0 * omega * omega * inertia - work).fold(f64::NEG_INFINITY, f64::max);
    if middle(least) > omega {
        return None;
    }
    let energy = halving(least, most, HALVINGS, |energy| middle(energy) < omega);
    let at = |theta: f64| speed(energy, (course.gas_work(theta), inertia + course.reduced_inertia(theta)));
    let [fastest, slowest] = course.extremes(at);
    Some((fastest.value - slowest.value) / omega)
}
