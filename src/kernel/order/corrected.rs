//! Which terms does a link with a corrected knuckle angle add to an order?
//!
//! Its knuckle pin is at `γ = Δ + ε` from the master rod, so that ([`crate::motion::CorrectedLinkage`])
//!
//! ```text
//! c_k = [k=1] (1 + ½κ e^{i(Δ−ε)} − ½κ e^{i(Δ+ε)}) + ½κ (e^{i(kΔ+ε)} + e^{i(kΔ−ε)}) c_k(λ) + h_k
//! ```
//!
//! with exact sums before 1 and c_k(λ), and a complex number h_k of every order. Its parts are numbers that a link has in common with those at
//! −Δ and of −ε, but for signs: `h_k(−Δ, −ε)` is conjugate, and `h_k(Δ, −ε) = (−1)^k h_k(Δ, ε)`. So mirror pairs and copies cancel, or not,
//! exactly. That such a part is not zero is no theorem: an enclosure has to show it.

use num_rational::BigRational;
use num_traits::Zero;

use crate::engine::Link;
use crate::exact::Turn;
use crate::motion::{Component, CorrectedLinkage};

/// A link with a corrected knuckle angle as far as its number h_k goes, which tells Δ from −Δ and ε from −ε by signs alone.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub struct Corrected {
    /// r/L.
    pub ratio: BigRational,
    /// κ = a/l.
    pub knuckle: BigRational,
    /// λ of the master rod.
    pub master: BigRational,
    /// Δ or −Δ: the one up to half a turn.
    pub apart: Turn,
    /// ε or −ε: the one up to half a turn.
    pub correction: Turn,
}

impl Corrected {
    /// That of a link.
    pub fn of(link: &Link) -> Self {
        let unsigned = |angle: &Turn| angle.clone().min(-angle);
        Corrected {
            ratio: link.ratio.clone(),
            knuckle: link.knuckle.clone(),
            master: link.master.clone(),
            apart: unsigned(&link.angle),
            correction: unsigned(&link.correction),
        }
    }

    /// Its motion.
    pub fn motion(&self) -> CorrectedLinkage {
        let lengths = [&self.ratio, &self.knuckle, &self.master];
        match CorrectedLinkage::new(lengths, [self.apart.turns(), self.correction.turns()]) {
            Some(motion) => motion,
            None => unreachable!("an engine's mechanisms turn round"),
        }
    }

    /// Whether a part of h_k may be other than zero: it is real or imaginary where the cylinder stands along that of the master.
    pub fn exists(&self, component: Component, order: u32) -> bool {
        let is_along = self.apart == Turn::zero() || self.apart == Turn::fraction(1, 2);
        let is_even = order.is_multiple_of(2);
        let is_there = match component {
            Component::Real => is_even || !is_along,
            Component::Imaginary => !is_even || !is_along,
        };
        order > 0 && !self.ratio.is_zero() && is_there
    }
}
