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
    /// By how much the resonance magnifies.
    pub fn magnifier(&self) -> f64 {
        self.amplitude / self.equilibrium
    }
}

/// What torques on the discs do at the natural frequency of a mode; infinite where nothing damps it.
pub fn resonance(train: &Train, mode: &Mode, torques: &[Complex<f64>]) -> Resonance {
    let work: Complex<f64> = torques.iter().zip(&mode.shape).map(|(torque, deflection)| torque * deflection).sum();
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
    let taken = omega * discs.sum::<f64>() + links.sum::<f64>();
    Resonance {
        amplitude: work.norm() / taken,
        equilibrium: work.norm() / (omega * omega * train.inertia_of(&mode.shape)),
    }
}
