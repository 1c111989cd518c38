//! How much can the orders above the K-th of a link with a corrected knuckle angle add, at most?
//!
//! `|h_k| ≤ (2k²L/r) S q^k` in every strip where the root is analytic ([`CorrectedLinkage`]), and
//! `Σ_{k≥n} k² q^k = q^n (n²/(1−q) + 2nq/(1−q)² + q(1+q)/(1−q)³)`: the least of these sums over several strips.

use num_rational::BigRational;
use num_traits::ToPrimitive;

use super::corrected::CorrectedLinkage;
use super::tail::SLACK;

/// What the higher orders of h_k add at most, by the bounds of several strips.
#[derive(Clone, Debug)]
pub struct CorrectedTail {
    /// r/L; 0 of a link without an end.
    ratio: f64,
    /// q and 1 − q of a strip, and S there.
    strips: Vec<[f64; 3]>,
}

/// Strips that are tried.
const STRIPS: u32 = 16;
/// What is put under a root near 1 is enlarged by this part of it before.
const NEAR: f64 = 1.0 + 1e-12;

impl CorrectedLinkage {
    /// What the orders above one add at most.
    pub fn tail(&self) -> CorrectedTail {
        CorrectedTail::new(self)
    }
}

impl CorrectedTail {
    fn new(linkage: &CorrectedLinkage) -> Self {
        let float = |number: &BigRational| number.to_f64().unwrap_or(f64::INFINITY);
        let [ratio, knuckle, master] = [&linkage.ratio, &linkage.knuckle, &linkage.master].map(float);
        let [angle, correction] =
            [&linkage.angle, &linkage.correction].map(|turns| float(turns) * std::f64::consts::TAU);
        let along = knuckle * correction.cos();
        let length = (1.0 + along * along - 2.0 * along * angle.cos()).max(0.0).sqrt() + 1e-14;
        let off = knuckle / master * correction.sin().abs();
        let lowered = |x: f64| 1.0 - (1.0 - (x * NEAR).min(1.0).powi(2)).max(0.0).sqrt();
        let widest = (float(&linkage.cosh) - 1.0) * (1.0 - 1e-9);
        let strip = |part: u32| {
            let beyond = widest * f64::from(part) / f64::from(STRIPS);
            let root = (beyond * (beyond + 2.0)).sqrt();
            let cosh = 1.0 + beyond;
            let reach = ratio * (length * cosh + off * (1.0 + lowered(master * cosh)));
            [cosh - root, root - beyond, lowered(reach)]
        };
        CorrectedTail { ratio, strips: (1..=STRIPS).map(strip).collect() }
    }

    /// `Σ_{k>K} |h_k|` at most; 0 only where no order is above.
    pub fn force(&self, order: u32) -> f64 {
        if self.ratio == 0.0 {
            return 0.0;
        }
        let n = f64::from(order) + 1.0;
        let sum = |[q, short, lowered]: &[f64; 3]| {
            let terms = n * n / short + 2.0 * n * q / (short * short) + q * (1.0 + q) / (short * short * short);
            2.0 / self.ratio * lowered * q.powf(n) * terms
        };
        let least = self.strips.iter().map(sum).fold(f64::INFINITY, f64::min);
        (least * SLACK).max(f64::MIN_POSITIVE)
    }
}
