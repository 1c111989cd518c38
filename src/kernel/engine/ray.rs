//! Which motions is that of a piston made of? Each is a ray: a rotating vector in each order that its law has.
//!
//! At order k a ray adds `w e^{iα} e^{±ik(β−α+ahead)}`, turned by a fixed angle, times the number of order k of its [`Law`].

use num_rational::BigRational;
use num_traits::{One, Signed, Zero};

use super::mechanism::{Link, Mechanism, Rod};
use crate::exact::Turn;

/// Which numbers the orders of a ray have.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Law {
    /// That of a crankpin: 1 in order 1, and no other order.
    Crank,
    /// c_k of a rod, in order 1 less the 1 of its crank.
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
    /// The motion of a piston, of weight 1. The first ray is that of its crank.
    pub fn of(mechanism: &Mechanism) -> Vec<Ray> {
        let own = |law| Ray { law, ahead: Turn::zero(), turned: Turn::zero(), weight: BigRational::one() };
        match mechanism {
            Mechanism::SliderCrank(rod) => vec![own(Law::Crank), own(Law::Rod(rod.clone()))],
            Mechanism::Link(link) if link.is_corrected() => {
                let half = &link.knuckle / BigRational::from_integer(2.into());
                let (ahead, back) = (&link.correction, &-&link.correction);
                vec![
                    own(Law::Crank),
                    of_master(link, Law::Crank, back, half.clone()),
                    of_master(link, Law::Crank, ahead, -&half),
                    of_master(link, Law::Rod(link.master_rod()), ahead, half.clone()),
                    of_master(link, Law::Rod(link.master_rod()), back, half),
                    own(Law::Corrected(link.clone())),
                ]
            }
            Mechanism::Link(link) => {
                let master = of_master(link, Law::Rod(link.master_rod()), &Turn::zero(), link.knuckle.clone());
                vec![own(Law::Crank), master, own(Law::Link(link.clone()))]
            }
        }
    }

    /// The motion of the knuckle pin of a link, along the axis of the master: that of its piston pin, and of the weight κ.
    pub fn of_knuckle(link: &Link) -> [Ray; 2] {
        let laws = [Law::Crank, Law::Rod(link.master_rod())];
        laws.map(|law| of_master(link, law, &link.correction, link.knuckle.clone()))
    }
}

/// A part of the motion of a link, or of its knuckle pin, that stands to the crank as its master's piston does.
fn of_master(link: &Link, law: Law, turned: &Turn, weight: BigRational) -> Ray {
    Ray { law, ahead: link.angle.clone(), turned: turned.clone(), weight }
}

/// A rod is asked without its rays: a sweep asks at each of its points.
impl Mechanism {
    /// Whether the motion is that of rods on the crankpin whose cylinder axes meet the crankshaft: order 1 is `cos ψ`, and there
    /// is no other odd order. Links with a corrected knuckle angle move otherwise.
    pub fn is_centric(&self) -> bool {
        if let Some(rod) = self.rod() {
            return rod.is_centric();
        }
        let mut odd = Ray::of(self).into_iter().filter(|ray| ray.law.has_parity_of(1));
        odd.next().is_some_and(|ray| ray.law == Law::Crank) && odd.next().is_none()
    }

    /// Whether its piston has one rotating vector in each order and sense of the force: a link has several, before several numbers.
    pub fn has_one_vector_per_order(&self) -> bool {
        self.rod().is_some() || matches!(Ray::of(self).as_slice(), [_, _])
    }
}

impl Law {
    /// Whether there is no order of it above the first.
    pub fn is_endless(&self) -> bool {
        match self {
            Law::Crank => true,
            Law::Rod(rod) => rod.ratio.is_zero(),
            Law::Link(link) | Law::Corrected(link) => link.ratio.is_zero(),
        }
    }

    /// Whether it has this order, as far as even and odd ones go.
    pub fn has_parity_of(&self, order: u32) -> bool {
        match self {
            Law::Crank => order == 1,
            Law::Rod(rod) => order.is_multiple_of(2) || !rod.is_centric(),
            Law::Link(_) => order.is_multiple_of(2),
            Law::Corrected(_) => true,
        }
    }

    /// The law without a sign that half a turn of the crank makes up for, and the turn of the crank ahead of the cylinder that goes with it,
    /// as far as it counts: equal ones of equal laws are multiplied by one number at every order above the first.
    pub fn unsigned(self, own: Turn) -> (Law, Turn) {
        match self {
            Law::Crank => (Law::Crank, own),
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
}
