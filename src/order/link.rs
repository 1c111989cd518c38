//! Which terms does a link on a master rod add to an order, and what do its knuckle pin and big end add?
//!
//! With Δ = α − α₀, `κ = a/l` and `z = 1 − κ e^{iΔ}` a link of knuckle angle Δ has `c_1 = 1`, no other odd order, and for even k
//!
//! ```text
//! c_k = κ e^{ikΔ} c_k(λ) + z^k g_k
//! ```
//!
//! c_k(λ) that of the master rod, g_k a real number that is not zero ([`crate::motion::Linkage`]). Both stand before exact sums:
//! `z^k = Σ C(k,u) (−κ)^u e^{iuΔ}`. So a link and its mirror image, Δ and −Δ, have terms before one number, and copies of one linkage
//! cancel, or not, exactly.
//!
//! A mass μ at the knuckle pin, the point `K = (1−ζ) crankpin + ζ piston pin of the master` with `ζ = κ e^{iγ}`, is a mass ζμ that moves as the
//! master's piston does, and (1−ζ)μ on the crankpin: 2μ along the throw, −2μκ turned from it by γ, which is Δ where it is not corrected
//! ([`corrected`](super::corrected)).

use num_bigint::BigInt;
use num_rational::BigRational;
use num_traits::{One, Zero};

use super::corrected;
use super::factor::Factor;
use crate::engine::{Cylinder, Engine, Link};
use crate::exact::{Term, Turn};
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

/// What the vector of a link's piston in the direct star stands before: numbers of the motion, each with a part and the angle it is
/// turned by; the other way in the reverse star.
pub(super) fn parts_of(link: &Link, order: u32) -> Vec<(Factor, Term)> {
    if link.is_corrected() {
        return corrected::parts_of(link, order);
    }
    let one = BigRational::one();
    if order == 1 {
        return vec![(Factor::One, Term { angle: Turn::zero(), weight: one })];
    }
    let master = Factor::Motion(link.master_rod());
    let with_the_master = Term { angle: link.angle.times(order.into()), weight: link.knuckle.clone() };
    if !order.is_multiple_of(2) {
        // Neither number is there: one stands for both.
        return vec![(master, with_the_master)];
    }
    let own = Factor::Linkage(Linkage::of(link));
    let mut weight = one;
    let powers = (0..=i64::from(order)).map(|u| {
        let term = Term { angle: link.angle.times(u), weight: weight.clone() };
        // C(k,u+1) = C(k,u) (k−u)/(u+1).
        weight *= -&link.knuckle * BigRational::new(BigInt::from(i64::from(order) - u), BigInt::from(u + 1));
        (own.clone(), term)
    });
    std::iter::once((master, with_the_master)).chain(powers).collect()
}

/// The mass at the knuckle pin of a cylinder's link, times the crank radius, in multiples of m r; none where there is none.
pub(super) fn knuckle(engine: &Engine, index: usize) -> Option<(&Cylinder, &Link, BigRational)> {
    let cylinder = &engine.cylinders()[index];
    let link = cylinder.link().filter(|_| !cylinder.knuckle_mass.is_zero())?;
    Some((cylinder, link, &cylinder.knuckle_mass * &cylinder.crank_radius))
}

/// The direction of the cylinder that the master rod of a link works in.
pub(super) fn master_bank(cylinder: &Cylinder, link: &Link) -> Turn {
    &cylinder.bank - &link.angle
}
