//! Where is the piston at an angle, how fast, and how fast does that change? Closed forms in floats.

use std::f64::consts::PI;

use super::crank::{Floats, SliderCrank};

/// The crank at an angle.
struct Place {
    sin: f64,
    cos: f64,
    /// `λ sin ψ − δ`, the sine of the rod's angle.
    slant: f64,
    /// `√(1 − slant²)`.
    root: f64,
}

impl SliderCrank {
    fn place(&self, psi: f64) -> Place {
        let Floats { ratio, offset, gap_above, gap_below } = self.floats;
        let (sin, cos) = psi.sin_cos();
        // 1 − |sin ψ| without cancellation.
        let short = cos * cos / (1.0 + sin.abs());
        let (above, below) = if sin > 0.0 { (short, 1.0 + sin) } else { (1.0 - sin, short) };
        let radicand = (gap_above + ratio * above) * (gap_below + ratio * below);
        Place { sin, cos, slant: ratio * sin - offset, root: radicand.sqrt() }
    }

    /// How far the piston stands from where it is at ψ = 0, outward positive: `(s(ψ) − s(0))/r`, ψ in radians.
    ///
    /// At ψ = 0 a centric crank is in top dead centre, and this is at most 0. All motions here are closed forms without
    /// cancellation between crank and rod, for λ → 0 and λ → 1: errors are a few units in the last place of the largest term.
    pub fn position(&self, psi: f64) -> f64 {
        // cos ψ − 1 + (f(ψ) − f(0))/λ, the difference of roots by the difference of squares.
        let Place { sin, root, .. } = self.place(psi);
        let Floats { ratio, offset, .. } = self.floats;
        let first_root = ((1.0 - offset) * (1.0 + offset)).sqrt();
        let half = (psi / 2.0).sin();
        -2.0 * half * half + sin * (2.0 * offset - ratio * sin) / (root + first_root)
    }

    /// The piston's velocity `ṡ/(rω) = −sin ψ + f'/λ`, outward positive.
    pub fn velocity(&self, psi: f64) -> f64 {
        let Place { sin, cos, slant, root } = self.place(psi);
        -sin - slant * cos / root
    }

    /// The piston's acceleration `s̈/(rω²) = −cos ψ + f''/λ`, outward positive; the shaking force is its opposite.
    pub fn acceleration(&self, psi: f64) -> f64 {
        let Place { sin, cos, slant, root } = self.place(psi);
        -cos - self.floats.ratio * (cos / root) * (cos / root) / root + slant * sin / root
    }

    /// tan β of the rod at an angle, positive on the crankpin's side of ψ = 90°.
    pub fn rod_slope(&self, psi: f64) -> f64 {
        let sine = self.floats.ratio * psi.sin() - self.floats.offset;
        sine / ((1.0 - sine) * (1.0 + sine)).sqrt()
    }

    /// The angles at which the piston is farthest out, `sin ψ = δ/(1 + λ)`, and farthest in, in radians.
    pub fn dead_centres(&self) -> [f64; 2] {
        let Floats { ratio, offset, .. } = self.floats;
        [(offset / (1.0 + ratio)).asin(), PI + (offset / (1.0 - ratio)).asin()]
    }

    /// The inertia torque `T/(m r² ω²) = −s's''/r²`, positive in the sense of rotation.
    pub fn torque(&self, psi: f64) -> f64 {
        -self.velocity(psi) * self.acceleration(psi)
    }
}
