//! Below which load does no crankshaft of this mass come? What multipliers prove, whoever found them.
//!
//! For multipliers y of the samples with `Σ|y_s| = 1`, and any λ and ξ of force and couple (of each crankshaft), every crankshaft that keeps the
//! conditions has `p ≥ Re Σ ȳ_s R_s + Re(λ̄ F + ξ̄ C) − |ξ| κ` (κ the bound of the couple), which is affine in the mass-radii:
//! `Re(h) + Re Σ ḡ_i U_i`. With `|U_i| ≤ m_i r_i` and `Σ m_i ≤ M` the second part is at least `−M max |g_i| r_i`. That is weak
//! duality: a poor solver makes the bound low, never wrong but for the rounding of floats.

use num_complex::Complex;

use super::problem::{Problem, Shaft};
use super::solve::{Sample, Solution};

/// A lower bound of the largest bearing load, as a function of the crankshaft's mass.
#[derive(Clone, Copy, Debug)]
pub(super) struct Bound {
    constant: f64,
    /// Multiples of m r ω² per kilogram of counterweights.
    slope: f64,
    bare_mass: f64,
}

impl Bound {
    pub fn new(problem: &Problem, samples: &[Sample], solution: &Solution) -> Self {
        let size: f64 = solution.of_samples.iter().map(|multiplier| multiplier.norm()).sum();
        if size == 0.0 {
            return Bound { constant: 0.0, slope: 0.0, bare_mass: problem.bare_mass };
        }
        let of_samples = || samples.iter().zip(&solution.of_samples).map(|(sample, y)| (sample, y / size));
        let of_balance: Vec<_> = solution.of_balance.iter().map(|pair| pair.map(|one| one / size)).collect();
        let product = |multiplier: Complex<f64>, value: Complex<f64>| (multiplier.conj() * value).re;
        let loads: f64 = of_samples().map(|(sample, y)| product(y, sample.load)).sum();
        let most = problem.of_shafts(problem.asked_couple.unwrap_or(0.0));
        let of_shaft = |((shaft, [of_force, of_couple]), most): ((&Shaft, &[Complex<f64>; 2]), f64)| {
            product(*of_force, shaft.left[0]) + product(*of_couple, shaft.left[1]) - of_couple.norm() * most
        };
        let constant = loads + problem.shafts.iter().zip(&of_balance).zip(most).map(of_shaft).sum::<f64>();
        let felt = |place: usize| {
            let parts: Complex<f64> = of_samples().map(|(sample, y)| y * problem.parts[sample.bearing][place]).sum();
            let [of_force, of_couple] = of_balance[problem.shaft_of[place]];
            parts + of_force + of_couple * problem.arms[place]
        };
        let slope = (0..problem.places()).map(|place| felt(place).norm() / problem.weighs[place]).fold(0.0, f64::max);
        Bound { constant, slope, bare_mass: problem.bare_mass }
    }

    /// The bound in multiples of m r ω² for a crankshaft of this mass in kilograms.
    pub fn at(&self, mass: f64) -> f64 {
        (self.constant - self.slope * (mass - self.bare_mass)).max(0.0)
    }
}
