//! Where is the piston at an angle, how fast, and how fast does that change? Closed forms in floats.

use std::f64::consts::PI;

use num_rational::BigRational;
use num_traits::One;

use super::enclosure::float;

/// The numbers of a crank as floats. The gaps `1 ± δ − λ` are rounded from exact ones: near the end of reach they decide.
#[derive(Clone, Debug)]
pub(super) struct ClosedForm {
    ratio: f64,
    offset: f64,
    gap_above: f64,
    gap_below: f64,
}

/// The crank at an angle.
struct Place {
    sin: f64,
    cos: f64,
    /// `λ sin ψ − δ`, the sine of the rod's angle.
    slant: f64,
    /// `√(1 − slant²)`.
    root: f64,
}

impl ClosedForm {
    pub fn new(ratio: &BigRational, offset: &BigRational) -> Self {
        let one = BigRational::one();
        ClosedForm {
            ratio: float(ratio),
            offset: float(offset),
            gap_above: float(&(&one + offset - ratio)),
            gap_below: float(&(&one - offset - ratio)),
        }
    }

    fn place(&self, psi: f64) -> Place {
        let (sin, cos) = psi.sin_cos();
        // 1 − |sin ψ| without cancellation.
        let short = cos * cos / (1.0 + sin.abs());
        let (above, below) = if sin > 0.0 { (short, 1.0 + sin) } else { (1.0 - sin, short) };
        let radicand = (self.gap_above + self.ratio * above) * (self.gap_below + self.ratio * below);
        Place { sin, cos, slant: self.ratio * sin - self.offset, root: radicand.sqrt() }
    }

    /// `cos ψ − 1 + (f(ψ) − f(0))/λ`, the difference of roots by the difference of squares.
    pub fn position(&self, psi: f64) -> f64 {
        let Place { sin, root, .. } = self.place(psi);
        let first_root = ((1.0 - self.offset) * (1.0 + self.offset)).sqrt();
        let half = (psi / 2.0).sin();
        -2.0 * half * half + sin * (2.0 * self.offset - self.ratio * sin) / (root + first_root)
    }

    /// `−sin ψ + f'/λ`.
    pub fn velocity(&self, psi: f64) -> f64 {
        let Place { sin, cos, slant, root } = self.place(psi);
        -sin - slant * cos / root
    }

    /// `−cos ψ + f''/λ`.
    pub fn acceleration(&self, psi: f64) -> f64 {
        let Place { sin, cos, slant, root } = self.place(psi);
        -cos - self.ratio * (cos / root) * (cos / root) / root + slant * sin / root
    }

    /// tan β of the rod.
    pub fn slope(&self, psi: f64) -> f64 {
        let sine = self.ratio * psi.sin() - self.offset;
        sine / ((1.0 - sine) * (1.0 + sine)).sqrt()
    }

    /// Where the piston is farthest out, and where farthest in.
    pub fn dead_centres(&self) -> [f64; 2] {
        [(self.offset / (1.0 + self.ratio)).asin(), PI + (self.offset / (1.0 - self.ratio)).asin()]
    }
}
