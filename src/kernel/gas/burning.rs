//! How does the pressure rise while the charge burns? By one integral, no differential equation.
//!
//! `X(τ) = (1 − e^{−aτ^{m+1}})/(1 − e^{−a})`, a = ln 1000, is what is burnt; from the first law with a constant exponent n
//! `p Vⁿ = p₀V₀ⁿ + (n − 1) Q ∫ V^{n−1} dX`.

use super::geometry::Geometry;
use super::quadrature::integrate;

/// Parts of the burning whose integrals are known beforehand.
const PANELS: usize = 24;

/// The burning of one joule.
#[derive(Clone, Debug)]
pub(super) struct Burning {
    start: f64,
    lasts: f64,
    wiebe: f64,
    exponent: f64,
    /// `(n − 1) ∫ V^{n−1} dX` from the start to the end of each panel.
    sums: Vec<f64>,
}

impl Burning {
    pub fn new(geometry: &Geometry, start: f64, lasts: f64, wiebe: f64, exponent: f64) -> Self {
        let mut burning = Burning { start, lasts, wiebe, exponent, sums: vec![0.0] };
        for panel in 0..PANELS {
            let [from, to] = [panel, panel + 1].map(|place| burning.edge(place, PANELS));
            let part = burning.part(geometry, from, to);
            burning.sums.push(burning.sums[panel] + part);
        }
        burning
    }

    /// Where a part of the angle begins: close together at the start, where a broken exponent leaves no smooth function.
    pub fn edge(&self, place: usize, of: usize) -> f64 {
        let part = place as f64 / of as f64;
        let power = if self.wiebe.fract() == 0.0 { 1 } else { 4 };
        self.start + self.lasts * part.powi(power)
    }

    /// `dX/dψ`.
    pub fn rate(&self, psi: f64) -> f64 {
        let a = 1000.0_f64.ln();
        let tau = ((psi - self.start) / self.lasts).clamp(0.0, 1.0);
        let m = self.wiebe;
        a * (m + 1.0) * tau.powf(m) * (-a * tau.powf(m + 1.0)).exp() / (0.999 * self.lasts)
    }

    fn part(&self, geometry: &Geometry, from: f64, to: f64) -> f64 {
        let n = self.exponent;
        (n - 1.0) * integrate(0.0, from, to, |psi| geometry.volume(psi).powf(n - 1.0) * self.rate(psi))
    }

    /// `(n − 1) ∫ V^{n−1} dX` from the start to an angle.
    pub fn sum(&self, geometry: &Geometry, psi: f64) -> f64 {
        let end = self.start + self.lasts;
        if psi >= end {
            return self.sums[PANELS];
        }
        let panel = (1..PANELS).take_while(|&place| self.edge(place, PANELS) <= psi).count();
        self.sums[panel] + self.part(geometry, self.edge(panel, PANELS), psi)
    }
}
