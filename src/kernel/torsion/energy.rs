//! How far does a train swing at a resonance, by the work alone? The energy method of the textbooks.
//!
//! J. P. Den Hartog, Mechanical Vibrations, chapter 5; E. J. Nestorides, A Handbook on Torsional Vibration, 1958: in the shape of the
//! undamped mode, the work of the torque is what the damping takes. It holds at the natural frequency alone.
//! The formula is that of theory, section 13.

use num_complex::Complex;

use super::{Mode, Train};

/// A resonance by the energy method.
#[derive(Clone, Debug, PartialEq)]
pub struct Resonance {
    /// Amplitude of a disc with deflection 1, in radians: of the first disc, but where that is a node.
    pub amplitude: f64,
    /// What the torque would deflect the mode by at rest: `|Σ Δ t| / (ω² Σ J Δ²)`.
    pub equilibrium: f64,
}

impl Resonance {
    /// By how much the resonance magnifies; none where the torque does no work on the mode.
    pub fn magnifier(&self) -> Option<f64> {
        (self.equilibrium > 0.0).then(|| self.amplitude / self.equilibrium)
    }
}

/// Work that is less than this part of that of all torques is rounding.
const ROUNDING: f64 = 1e-12;

/// What torques on the discs do at the natural frequency of a mode; infinite where nothing damps it, 0 where they do no work on the mode.
pub fn resonance(train: &Train, mode: &Mode, torques: &[Complex<f64>]) -> Resonance {
    let works = || torques.iter().zip(&mode.shape).map(|(torque, deflection)| torque * deflection);
    let work = works().sum::<Complex<f64>>().norm();
    let work = if work > ROUNDING * works().map(|one| one.norm()).sum::<f64>() { work } else { 0.0 };
    let (omega, taken) = (mode.omega, taken(train, mode));
    Resonance {
        amplitude: if work > 0.0 { work / taken } else { 0.0 },
        equilibrium: work / (omega * omega * train.inertia_of(&mode.shape)),
    }
}

/// The torque that damping takes in a mode with these deflections, at its frequency.
fn taken(train: &Train, mode: &Mode) -> f64 {
    let omega = mode.omega;
    let discs = train.discs.iter().zip(&mode.shape).map(|(disc, deflection)| disc.damping * deflection.powi(2));
    let links = train.links.iter().map(|link| {
        let [one, other] = link.ends;
        if link.stiffness == 0.0 {
            // A ring that only oil drags along damps as an absolute damping of c(ΩJ)²/(c² + (ΩJ)²) would.
            let inertia = omega * train.discs[other].inertia;
            let damping = link.damping * inertia * inertia / (link.damping.powi(2) + inertia * inertia);
            return omega * damping * mode.shape[one].powi(2);
        }
        link.complex_stiffness(omega).im * (mode.shape[one] - mode.shape[other]).powi(2)
    });
    omega * discs.sum::<f64>() + links.sum::<f64>()
}

/// Half the width of the resonance of a mode, as a part of its frequency: so far beside it the amplitude is 1/√2 of the peak.
pub fn half_width(train: &Train, mode: &Mode) -> f64 {
    taken(train, mode) / (2.0 * mode.omega * mode.omega * train.inertia_of(&mode.shape))
}
