//! At which speeds does the crankshaft twist? Natural frequencies and modes of discs on a shaft, and the critical speeds of each order.
//!
//! `inertias, stiffnesses → modes (Holzer) → firing star of each mode → critical speeds`. The shaft is free at both ends and
//! without damping (theory, section 13). Mode shapes are decimals, and so are their stars; the star of a rigid crankshaft is exact.

mod critical;
mod forced;
mod holzer;

use num_rational::BigRational;

use crate::engine::Torsion;
use crate::numbers;
pub use critical::{Critical, CriticalSpeeds, critical_speeds};
pub use forced::{Excitation, forced_twist};
pub use holzer::{Mode, modes};

/// Discs on a massless shaft, free at both ends.
#[derive(Clone, Debug, PartialEq)]
pub struct Shaft {
    /// Moment of inertia of each disc in kg m².
    pub inertias: Vec<f64>,
    /// Stiffness between each disc and the next in N m per radian.
    pub stiffnesses: Vec<f64>,
}

impl Shaft {
    /// The shaft of an engine, in decimals.
    pub fn new(torsion: &Torsion) -> Self {
        let decimals = |values: &[BigRational]| values.iter().map(numbers::float).collect();
        Shaft { inertias: decimals(&torsion.inertias), stiffnesses: decimals(&torsion.stiffnesses) }
    }
}
