//! Which terms does a link on a master rod add to an order, and what do its knuckle pin and big end add?
//!
//! With Δ = α − α₀, `κ = a/l` and `z = 1 − κ e^{iΔ}` a link of knuckle angle Δ has `c_1 = 1`, no other odd order, and for even k
//!
//! ```text
//! c_k = κ e^{ikΔ} c_k(λ) + z^k g_k
//! ```
//!
//! c_k(λ) that of the master rod, g_k a real number that is not zero ([`crate::motion::Linkage`]). Both are multiplied by exact sums:
//! `z^k = Σ C(k,u) (−κ)^u e^{iuΔ}`. So a link and its mirror image, Δ and −Δ, have terms before one number, and copies of one linkage
//! cancel, or not, exactly.
//!
//! A mass μ at the knuckle pin, the point `K = (1−ζ) crankpin + ζ piston pin of the master` with `ζ = κ e^{iγ}`, is a mass ζμ that moves as the
//! master's piston does, and (1−ζ)μ on the crankpin: 2μ along the throw, −2μκ turned from it by γ, which is Δ where it is not corrected
//! ([`corrected`](super::corrected)).

use num_rational::BigRational;
use num_traits::Zero;

use crate::engine::{Cylinder, Link};
use crate::exact::Turn;
use crate::motion;

/// A link as far as its number g_k goes, which does not tell Δ from −Δ.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub struct Linkage {
    /// r/L.
    pub ratio: BigRational,
    /// κ = a/l.
    pub knuckle: BigRational,
    /// Δ or −Δ: the one up to half a turn.
    pub apart: Turn,
}

impl Linkage {
    /// That of a link.
    pub fn of(link: &Link) -> Self {
        let apart = link.angle.clone().min(-&link.angle);
        Linkage { ratio: link.ratio.clone(), knuckle: link.knuckle.clone(), apart }
    }

    /// Its motion.
    pub fn motion(&self) -> motion::Linkage {
        let turns = self.apart.turns().clone();
        match motion::Linkage::new(self.ratio.clone(), self.knuckle.clone(), turns) {
            Some(motion) => motion,
            None => unreachable!("an engine's mechanisms turn round"),
        }
    }

    /// Whether g_k is not zero.
    pub fn exists(&self, order: u32) -> bool {
        order > 0 && order.is_multiple_of(2) && !self.ratio.is_zero()
    }
}

/// The mass at the knuckle pin of a cylinder's link, times the crank radius, in multiples of m r; none where there is none.
pub(super) fn knuckle(cylinder: &Cylinder) -> Option<(&Link, BigRational)> {
    let link = cylinder.link().filter(|_| !cylinder.knuckle_mass.is_zero())?;
    Some((link, &cylinder.knuckle_mass * &cylinder.crank_radius))
}

/// The direction of the cylinder that the master rod of a link works in.
pub(super) fn master_bank(cylinder: &Cylinder, link: &Link) -> Turn {
    &cylinder.bank - &link.angle
}
