//! Which motions is that of a piston made of, at all orders above the first? Each is a ray.
//!
//! At order k a ray adds `w e^{iα} e^{±ik(β−α+ahead)}`, turned by a fixed angle, times the number of order k of its [`Law`]. The crank's own first
//! order is not among them.

use num_bigint::BigInt;
use num_rational::BigRational;
use num_traits::{One, Signed, Zero};

use super::corrected::Corrected;
use super::factor::Factor;
use super::link::{self, Linkage};
use super::turning::mass_radius;
use crate::engine::{Cylinder, Engine, Link, Mechanism, Rod};
use crate::exact::{Term, Turn};
use crate::motion::Component;

/// Which numbers the orders of a ray have.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Law {
    /// c_k of a rod.
    Rod(Rod),
    /// `g_k z^k` of a link whose knuckle angle is not corrected.
    Link(Link),
    /// h_k of one whose knuckle angle is.
    Corrected(Link),
}

/// A part of the motion of a piston.
#[derive(Clone, Debug)]
pub struct Ray {
    /// Its numbers.
    pub law: Law,
    /// By how much its crank is farther ahead of its cylinder than that of the piston is.
    pub ahead: Turn,
    /// By which angle it is turned at every order.
    pub turned: Turn,
    /// What it is multiplied by: a share of the motion, or mass times crank radius.
    pub weight: BigRational,
}

impl Ray {
    /// The motion of a piston, of weight 1.
    pub fn of(mechanism: &Mechanism) -> Vec<Ray> {
        let own = |law| Ray { law, ahead: Turn::zero(), turned: Turn::zero(), weight: BigRational::one() };
        match mechanism {
            Mechanism::SliderCrank(rod) => vec![own(Law::Rod(rod.clone()))],
            Mechanism::Link(link) if link.is_corrected() => {
                let half = &link.knuckle / BigRational::from_integer(2.into());
                let master = |turned| of_master(link, turned, half.clone());
                vec![master(link.correction.clone()), master(-&link.correction), own(Law::Corrected(link.clone()))]
            }
            Mechanism::Link(link) => {
                vec![of_master(link, Turn::zero(), link.knuckle.clone()), own(Law::Link(link.clone()))]
            }
        }
    }
}

/// The part of a link's motion, or of its knuckle pin's, that the master rod gives it.
fn of_master(link: &Link, turned: Turn, weight: BigRational) -> Ray {
    Ray { law: Law::Rod(link.master_rod()), ahead: link.angle.clone(), turned, weight }
}

/// What the masses of a cylinder that go up and down add, in multiples of m r: its piston, and the mass at the knuckle pin of its link, which
/// moves as the master's piston does.
pub fn rays(engine: &Engine, cylinder: &Cylinder) -> Vec<Ray> {
    let Some(mechanism) = &cylinder.mechanism else { return Vec::new() };
    let piston = mass_radius(engine, cylinder);
    let of_piston = Ray::of(mechanism).into_iter().map(|ray| Ray { weight: ray.weight * &piston, ..ray });
    let of_knuckle = link::knuckle(cylinder)
        .map(|(link, mass_radius)| of_master(link, link.correction.clone(), mass_radius * &link.knuckle));
    of_piston.chain(of_knuckle).collect()
}

impl Law {
    /// Whether there is no order of it above the first.
    pub fn is_endless(&self) -> bool {
        match self {
            Law::Rod(rod) => rod.ratio.is_zero(),
            Law::Link(link) | Law::Corrected(link) => link.ratio.is_zero(),
        }
    }

    /// Whether it has even, or odd, orders above the first.
    pub(super) fn has_parity_of(&self, order: u32) -> bool {
        let has_odd = match self {
            Law::Rod(rod) => !rod.is_centric(),
            Law::Link(_) => false,
            Law::Corrected(_) => true,
        };
        has_odd || order.is_multiple_of(2)
    }

    /// The law without a sign that half a turn of the crank makes up for, and the turn of the crank ahead of the cylinder that goes with it,
    /// as far as it counts: equal ones of equal laws are multiplied by one number at every order.
    pub fn unsigned(self, own: Turn) -> (Law, Turn) {
        match self {
            // Even orders alone.
            Law::Rod(rod) if rod.is_centric() => (Law::Rod(rod), own.times(2)),
            Law::Link(link) => (Law::Link(link), own.times(2)),
            Law::Rod(rod) => {
                let own = if rod.offset.is_negative() { own.opposite() } else { own };
                (Law::Rod(rod.unsigned()), own)
            }
            Law::Corrected(link) => {
                let correction = link.correction.clone().min(-&link.correction);
                let own = if correction == link.correction { own } else { own.opposite() };
                (Law::Corrected(Link { correction, ..link }), own)
            }
        }
    }

    /// Its numbers at an order (of a rod: above the first), each with a part of the vector in the direct star and the angle that this part is
    /// turned by; in the reverse star it is turned the other way.
    pub(super) fn parts(&self, order: u32) -> Vec<(Factor, Term)> {
        match self {
            Law::Rod(rod) => {
                let (factor, weight) = Factor::of_rod(Some(rod), order);
                vec![(factor, Term { angle: Turn::zero(), weight })]
            }
            Law::Link(link) => of_link(link, order),
            Law::Corrected(link) => of_corrected(link, order),
        }
    }
}

/// `g_k z^k`, with `z^k = Σ C(k,u) (−κ)^u e^{iuΔ}`.
fn of_link(link: &Link, order: u32) -> Vec<(Factor, Term)> {
    let own = Factor::Linkage(Linkage::of(link));
    let mut weight = BigRational::one();
    let powers = (0..=i64::from(order)).map(|u| {
        let term = Term { angle: link.angle.times(u), weight: weight.clone() };
        // C(k,u+1) = C(k,u) (k−u)/(u+1).
        weight *= -&link.knuckle * BigRational::new(BigInt::from(i64::from(order) - u), BigInt::from(u + 1));
        (own.clone(), term)
    });
    powers.collect()
}

/// The two parts of h_k.
fn of_corrected(link: &Link, order: u32) -> Vec<(Factor, Term)> {
    let own = Corrected::of(link);
    let (is_behind, is_taken_back) = (own.apart != link.angle, own.correction != link.correction);
    let is_opposite = is_behind != is_taken_back && !order.is_multiple_of(2);
    let weight = if is_opposite { -BigRational::one() } else { BigRational::one() };
    let quarter = if is_behind { Turn::fraction(3, 4) } else { Turn::fraction(1, 4) };
    let part = |component, angle| (Factor::Corrected(own.clone(), component), Term { angle, weight: weight.clone() });
    vec![part(Component::Real, Turn::zero()), part(Component::Imaginary, quarter)]
}
