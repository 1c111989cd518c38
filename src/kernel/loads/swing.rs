//! What do the two vectors of an order trace together? An ellipse (theory, section 3).

use num_complex::Complex;

use super::vector::{Outcome, Vector};
use crate::numbers;
use crate::order::{OrderSum, Path};

/// One order of the force or the moment: the vector `½(P⁺ e^{ikθ} + P⁻ e^{−ikθ})`, in multiples of m r ω².
#[derive(Clone, Debug)]
pub struct Swing {
    /// P⁺, which turns with the crank.
    pub direct: Vector,
    /// P⁻, which turns against it.
    pub reverse: Vector,
    /// What is proved of the path.
    pub path: Path,
}

impl Swing {
    /// The swing of two vectors with their exact sums.
    ///
    /// Their lengths are compared by the exact sums; only where those are not equal whatever the coefficients are, nothing is proved.
    pub(super) fn new([direct, reverse]: [Vector; 2], [direct_sum, reverse_sum]: [&OrderSum; 2], order: u32) -> Self {
        let mut swing = Swing { direct, reverse, path: Path::POINT };
        if !swing.vanishes() {
            let surely_not = swing.smallest() > numbers::ALIKE * swing.largest();
            swing.path = if surely_not { Path::OPEN } else { Path::of(direct_sum, reverse_sum, order) };
        }
        swing
    }

    /// Whether both vectors are proved to be zero.
    pub fn vanishes(&self) -> bool {
        self.direct.outcome == Outcome::Zero && self.reverse.outcome == Outcome::Zero
    }

    /// How much longer than its decimals it may be, where a vector is not decided.
    pub fn doubt(&self) -> f64 {
        (self.direct.doubt() + self.reverse.doubt()) / 2.0
    }

    /// Largest length in a revolution, zero to peak: `½(|P⁺| + |P⁻|)`.
    pub fn largest(&self) -> f64 {
        (self.direct.value.norm() + self.reverse.value.norm()) / 2.0
    }

    /// Smallest length in a revolution: `½| |P⁺| − |P⁻| |`.
    pub fn smallest(&self) -> f64 {
        (self.direct.value.norm() - self.reverse.value.norm()).abs() / 2.0
    }

    /// Direction of the longer axis of the ellipse, in degrees in (−90, 90]; none where the path is a circle.
    pub fn direction(&self) -> Option<f64> {
        let (direct, reverse) = (self.direct.value, self.reverse.value);
        (direct.norm() > 0.0 && reverse.norm() > 0.0).then(|| {
            let degrees = ((direct.arg() + reverse.arg()) / 2.0).to_degrees();
            // An axis has two ends: the one in the right half is named.
            let folded = if degrees > 90.0 { degrees - 180.0 } else { degrees };
            match folded {
                _ if folded <= -90.0 => folded + 180.0,
                // Rounding of two angles that cancel.
                _ if folded.abs() < 1e-12 => 0.0,
                _ => folded,
            }
        })
    }

    /// Amplitude along direction 0: `½|P⁺ + P̄⁻|`.
    pub fn along(&self) -> f64 {
        (self.direct.value + self.reverse.value.conj()).norm() / 2.0
    }

    /// Amplitude across direction 0: `½|P⁺ − P̄⁻|`.
    pub fn across(&self) -> f64 {
        (self.direct.value - self.reverse.value.conj()).norm() / 2.0
    }

    /// Both vectors, halved: the coefficients of `e^{ikθ}` and `e^{−ikθ}`.
    pub fn amplitudes(&self) -> [Complex<f64>; 2] {
        [self.direct.value / 2.0, self.reverse.value / 2.0]
    }
}
