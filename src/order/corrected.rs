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
use num_traits::{One, Zero};

use super::factor::Factor;
use crate::engine::Link;
use crate::exact::{Term, Turn};
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

/// What the vector of a link's piston in the direct star stands before: numbers of the motion, each with a part and the angle it
/// is turned by; the other way in the reverse star.
pub(super) fn parts_of(link: &Link, order: u32) -> Vec<(Factor, Term)> {
    let one = BigRational::one();
    let half = &link.knuckle / BigRational::from_integer(2.into());
    let term = |angle: Turn, weight: &BigRational| Term { angle, weight: weight.clone() };
    let mut parts = Vec::new();
    if order == 1 {
        parts.push((Factor::One, term(Turn::zero(), &one)));
        parts.push((Factor::One, term(&link.angle - &link.correction, &half)));
        parts.push((Factor::One, term(&link.angle + &link.correction, &-&half)));
    } else if order.is_multiple_of(2) {
        let master = Factor::Motion(link.master_rod());
        let with_it = link.angle.times(order.into());
        parts.push((master.clone(), term(&with_it + &link.correction, &half)));
        parts.push((master, term(&with_it - &link.correction, &half)));
    }
    let own = Corrected::of(link);
    let (is_behind, is_taken_back) = (own.apart != link.angle, own.correction != link.correction);
    let sign = if is_behind != is_taken_back && !order.is_multiple_of(2) { -one } else { one };
    let quarter = if is_behind { Turn::fraction(3, 4) } else { Turn::fraction(1, 4) };
    parts.push((Factor::Corrected(own.clone(), Component::Real), term(Turn::zero(), &sign)));
    parts.push((Factor::Corrected(own, Component::Imaginary), term(quarter, &sign)));
    parts
}
