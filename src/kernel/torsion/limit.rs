//! Which vibration stress does a classification society permit in a shaft, and which speeds are barred?
//!
//! IACS Unified Requirement M68 (2012, revised 2015): Dimensions of propulsion shafts and their permissible torsional vibration
//! stresses. Stresses in pascals, as amplitudes; λ is the speed over the rated speed. Theory, section 13.

use crate::engine::{Section, Steel};
use crate::numbers::float;

/// No larger tensile strength counts, in megapascals: of carbon steels, of alloy steels.
const STRONGEST: [f64; 2] = [600.0, 800.0];
/// From this λ on no range may be barred, and the stress may nowhere be that of passing through quickly.
pub const UNBARRED: f64 = 0.8;
/// The bracket no longer falls from this λ on.
const LEVEL: f64 = 0.9;
/// No stress is permitted beyond this λ.
pub const HIGHEST_RATIO: f64 = 1.05;
const MEGA: f64 = 1e6;

/// What the permissible stress of a shaft depends on.
#[derive(Clone, Debug, PartialEq)]
pub struct StressLimit {
    /// Tensile strength σ_B that counts, in pascals.
    pub strength: f64,
    /// Factor of the shape c_K.
    pub shape: f64,
    /// Factor of the size c_D.
    pub size: f64,
}

impl StressLimit {
    /// That of a shaft.
    pub fn new(section: &Section, steel: &Steel) -> Self {
        let strongest = STRONGEST[usize::from(steel.is_alloy)];
        StressLimit {
            strength: MEGA * (float(&steel.tensile_strength) / MEGA).min(strongest),
            shape: float(&steel.shape_factor),
            size: 0.35 + 0.93 * (1e3 * float(&section.outer)).powf(-0.2),
        }
    }

    /// τ_C, for continuous running; none beyond 105 % of the rated speed.
    pub fn continuous(&self, lambda: f64) -> Option<f64> {
        let bracket = if lambda < LEVEL { 3.0 - 2.0 * lambda * lambda } else { 1.38 };
        let stress = (self.strength / MEGA + 160.0) / 18.0 * self.shape * self.size * bracket;
        (lambda <= HIGHEST_RATIO).then_some(MEGA * stress)
    }

    /// τ_T, for passing through quickly, below 80 % of the rated speed: 1.7 τ_C / √c_K.
    pub fn transient(&self, lambda: f64) -> Option<f64> {
        let stress = self.continuous(lambda)?;
        (lambda < UNBARRED).then(|| 1.7 * stress / self.shape.sqrt())
    }
}

/// The speeds that are barred around a critical one: `16 n_c/(18 − λ)` to `(18 − λ) n_c/16`.
pub fn barred(critical: f64, rated: f64) -> [f64; 2] {
    let lambda = critical / rated;
    [16.0 * critical / (18.0 - lambda), (18.0 - lambda) * critical / 16.0]
}

/// Stress of a torque in a shaft, `16 M d / π(d⁴ − d_i⁴)`.
pub fn stress(section: &Section, torque: f64) -> f64 {
    let (outer, inner) = (float(&section.outer), float(&section.inner));
    16.0 * torque * outer / (std::f64::consts::PI * (outer.powi(4) - inner.powi(4)))
}
