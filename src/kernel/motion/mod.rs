//! How does one piston move? The harmonics of a slider-crank, guaranteed, exact as series, or fast.
//!
//! The crank has radius r, rod length l and pin offset e; its rod ratio is `λ = r/l`, its offset `δ = e/l`. With
//! `f(ψ) = √(1 − (λ sin ψ − δ)²)` the piston is at `s = r cos ψ + l f(ψ)` (theory, section 2), outward positive.
//! [`SliderCrank`] gives its harmonics, [`series`] the centric ones as series in λ, [`coefficients_fast`] as floats.
//!
//! # Which orders are there
//!
//! **Theorem.** For λ > 0 and k ≥ 1 the k-th harmonic of f is not zero if δ ≠ 0; if δ = 0, exactly those of even order
//! are not zero.
//!
//! *Proof.* `1 − √(1 − x²) = Σ b_n x^{2n}` with every `b_n > 0`, n ≥ 1. Put `x = λ sin ψ − δ`, which is at most
//! λ + |δ| < 1, and expand by powers of `sin ψ = (ζ + ζ⁻¹)/2`, `ζ = −i e^{iψ}`. The term
//! `b_n C(2n,j) λ^j (−δ)^{2n−j} sin^jψ` contributes to `ζ^k` only if j ≥ k and j − k is even, and then with the sign of
//! `(−δ)^j`, which all these j share. So nothing cancels. If δ = 0 only j = 2n is left, and k is even. ∎
//!
//! Hence in the force every `c_k ≠ 0` with an offset, and without one exactly `c_1` and the even ones. In the inertia
//! torque every order is there, with an offset or without: [`SliderCrank::torque_coefficient`] tells why; and so in the load of a
//! crankpin, whose side force has what the force does not have: [`SliderCrank::side_part`].

mod ball;
mod centric;
mod circle;
mod closed;
mod corrected;
mod corrected_tail;
mod crank;
mod enclosure;
mod error;
mod fast;
mod hung;
mod jet;
mod linkage;
mod offset;
mod piston;
mod section;
mod series;
mod side;
mod small;
mod tail;
mod top;
mod torque;

pub use circle::{DOUBT, FixedPoint};
pub use corrected::{Component, CorrectedLinkage};
pub use corrected_tail::CorrectedTail;
pub use crank::SliderCrank;
pub use enclosure::{Coefficient, Enclosure, float, rational_root};
pub use error::NoFullTurn;
pub use fast::coefficients_fast;
pub use hung::{HungLink, LinkMass, harmonic};
pub use jet::Jet;
pub use linkage::Linkage;
pub use piston::{LinkMotion, PistonMotion};
pub use section::{golden_section, halving};
pub use series::{Series, series};
pub use tail::{SLACK, Tail};
pub use top::top_between;
