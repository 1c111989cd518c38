//! What is an exact sum multiplied by? 1, or a number of the motion of a piston.

use num_rational::BigRational;
use num_traits::{One, Signed, Zero};

use super::corrected::Corrected;
use super::crank::crank_of;
use super::link::Linkage;
use crate::engine::{Link, Mechanism, Rod};
use crate::exact::Turn;
use crate::motion::{Component, LinkMass};
use crate::proof::{Quantity, Sense};

/// The number that a sum is multiplied by in an order.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Factor {
    /// 1: masses that turn, and order 1 of centric rods.
    One,
    /// c_k of this mechanism, whose offset is not negative above order 1; conjugated in reverse sums.
    Motion(Rod),
    /// y of the c_1 = 1 + iy of this rod, whose offset is positive: a real number below 0 (theory, section 2). Order 1 of rods that differ
    /// is multiplied by it, a quarter turn on, and by 1; where all mechanisms are alike it is multiplied by c_1.
    Quadrature(Rod),
    /// t_k, the coefficient of the inertia torque, of this rod.
    Torque(Rod),
    /// That of a mechanism whose torque is not judged: a decimal.
    DecimalTorque(Mechanism),
    /// u_k, the part of the side force that no c_k has ([`SliderCrank::side_part`]), of this mechanism, whose offset is not
    /// negative; conjugated in reverse sums.
    ///
    /// [`SliderCrank::side_part`]: crate::motion::SliderCrank::side_part
    Side(Rod),
    /// g_k of a link on a master rod ([`crate::motion::Linkage`]), a real number.
    Linkage(Linkage),
    /// A part of h_k of a link with a corrected knuckle angle ([`crate::motion::CorrectedLinkage`]), a real number.
    Corrected(Corrected, Component),
    /// What the crankpin of a master rod feels of a mass of this link, in sums of this sense: a decimal ([`crate::motion::HungLink`]).
    OnPin(Link, LinkMass, Sense),
    /// c_k of the rods of an engine that names none: they are centric and alike.
    Open,
    /// t_k of such rods.
    OpenTorque,
    /// One of these numbers of a crank that turns this many times, at least twice, while the reference turns once: that of its own order,
    /// the order divided by this. Never [`Factor::One`], nor another of these.
    Geared(u32, Box<Factor>),
}

impl Factor {
    /// What the force of a piston is multiplied by that has a rod on the crankpin, as one number, and with which sign. A rod of which
    /// nothing is known is centric.
    ///
    /// The root `√(1−(λ sinψ−δ)²)` stays as it is where δ changes its sign and ψ goes on by half a turn, so that its
    /// coefficient of order k then changes by (−1)^k; c_1 has the crank's own 1 beside it.
    pub fn of_rod(rod: Option<&Rod>, order: u32) -> (Factor, BigRational) {
        let one = BigRational::one();
        match rod {
            None if order == 1 => (Factor::One, one),
            None => (Factor::Open, one),
            Some(rod) if order == 1 && rod.offset.is_zero() => (Factor::One, one),
            Some(rod) if order == 1 => (Factor::Motion(rod.clone()), one),
            Some(rod) => {
                let sign = if rod.offset.is_negative() && order % 2 == 1 { -one } else { one };
                (Factor::Motion(rod.unsigned()), sign)
            }
        }
    }

    /// What the part of the side force that no c_k has is multiplied by, and with which sign: for −δ the real number E_k of u_k is
    /// `(−1)^{k+1}` times that for δ, since p and q, R and S change places.
    pub fn of_side(rod: &Rod, order: u32) -> (Factor, BigRational) {
        let sign =
            if rod.offset.is_negative() && order.is_multiple_of(2) { -BigRational::one() } else { BigRational::one() };
        (Factor::Side(rod.unsigned()), sign)
    }

    /// What the inertia torque of a cylinder with this mechanism is multiplied by.
    pub fn of_torque(mechanism: Option<&Mechanism>) -> Factor {
        match (mechanism, mechanism.and_then(Mechanism::rod)) {
            (None, _) => Factor::OpenTorque,
            (Some(_), Some(rod)) => Factor::Torque(rod.clone()),
            (Some(mechanism), None) => Factor::DecimalTorque(mechanism.clone()),
        }
    }

    /// The same of a crank that turns this many times while the reference turns once.
    pub(super) fn geared(self, speed: u32) -> Factor {
        match (speed, self) {
            (_, Factor::One) => Factor::One,
            (1, factor) => factor,
            (_, factor) => Factor::Geared(speed, Box::new(factor)),
        }
    }

    /// The number by itself, and which order of it is multiplied by a sum of this order: its crank may turn faster than the reference.
    pub fn own(&self, order: u32) -> (&Factor, u32) {
        match self {
            Factor::Geared(speed, factor) => (factor, order / (*speed).max(1)),
            own => (own, order),
        }
    }

    /// Whether it is that of a crank which turns faster than the reference.
    pub fn is_geared(&self) -> bool {
        matches!(self, Factor::Geared(..))
    }

    /// The rod on a crankpin whose motion it is a number of.
    pub fn rod(&self) -> Option<&Rod> {
        match self {
            Factor::Motion(rod) | Factor::Torque(rod) | Factor::Side(rod) | Factor::Quadrature(rod) => Some(rod),
            Factor::Geared(_, own) => own.rod(),
            Factor::One
            | Factor::Open
            | Factor::OpenTorque
            | Factor::DecimalTorque(_)
            | Factor::Linkage(_)
            | Factor::Corrected(..)
            | Factor::OnPin(..) => None,
        }
    }

    /// The letter of its symbol; none for 1. Of a side force without an offset it is that of all there is in an odd order.
    pub fn letter(&self) -> Option<char> {
        match self {
            Factor::One => None,
            Factor::Motion(_) | Factor::Open | Factor::OpenTorque => Some('c'),
            Factor::Quadrature(_) => Some('y'),
            Factor::Torque(_) | Factor::DecimalTorque(_) => Some('t'),
            Factor::Side(rod) if rod.is_centric() => Some('n'),
            Factor::Side(_) => Some('u'),
            Factor::Linkage(_) => Some('g'),
            Factor::Corrected(..) => Some('h'),
            Factor::OnPin(..) => Some('p'),
            Factor::Geared(_, own) => own.letter(),
        }
    }

    /// Whether it is a number of a link on a master rod.
    pub fn is_of_link(&self) -> bool {
        matches!(self, Factor::Linkage(_) | Factor::Corrected(..))
    }

    /// Whether it is a decimal without an exact or an enclosed value.
    pub fn is_decimal(&self) -> bool {
        matches!(self, Factor::OnPin(..))
    }

    /// Whether it is not zero in an order: whether the order exists. One that [may be zero](Factor::may_be_zero) exists where nothing says
    /// that it is.
    pub fn exists(&self, order: u32) -> bool {
        match self {
            Factor::One | Factor::OpenTorque | Factor::OnPin(..) => true,
            Factor::Motion(rod) => rod.has_order(Quantity::FORCE, order),
            Factor::Quadrature(rod) => order == 1 && !rod.offset.is_zero(),
            Factor::Torque(rod) => rod.has_order(Quantity::TORQUE, order),
            Factor::DecimalTorque(mechanism) => mechanism.has_order(Quantity::TORQUE, order),
            Factor::Side(rod) => crank_of(rod).has_side_part(order),
            Factor::Linkage(linkage) => linkage.exists(order),
            Factor::Corrected(corrected, component) => corrected.exists(*component, order),
            Factor::Open => order == 1 || order.is_multiple_of(2),
            Factor::Geared(speed, _) => {
                let (own, own_order) = self.own(order);
                order.is_multiple_of(*speed) && own.exists(own_order)
            }
        }
    }

    /// Whether it is below 0 in an order of the force; none where it is not real.
    pub fn is_negative(&self, order: u32) -> Option<bool> {
        match self {
            Factor::One => Some(false),
            Factor::Quadrature(_) => Some(true),
            // c_2, c_6, … are above 0, c_4, c_8, … below (theory, section 2).
            Factor::Open | Factor::Linkage(_) => Some(order.is_multiple_of(4)),
            Factor::Motion(rod) => rod.is_centric().then(|| order.is_multiple_of(4)),
            Factor::Geared(..) => {
                let (own, own_order) = self.own(order);
                own.is_negative(own_order)
            }
            Factor::Torque(_)
            | Factor::DecimalTorque(_)
            | Factor::Side(_)
            | Factor::Corrected(..)
            | Factor::OnPin(..)
            | Factor::OpenTorque => None,
        }
    }

    /// Whether it may be zero even where it exists, so that only an enclosure tells: there is no theorem on it.
    pub fn may_be_zero(&self) -> bool {
        match self {
            Factor::Corrected(..) | Factor::OnPin(..) => true,
            Factor::Geared(_, factor) => factor.may_be_zero(),
            Factor::One
            | Factor::Motion(_)
            | Factor::Quadrature(_)
            | Factor::Torque(_)
            | Factor::DecimalTorque(_)
            | Factor::Side(_)
            | Factor::Linkage(_)
            | Factor::Open
            | Factor::OpenTorque => false,
        }
    }

    /// The real numbers that it is made of, in an order of the force, each with the angle that it turns a direct sum by, and a reverse one the other way:
    /// c_k is real for even k, imaginary for odd k above 1, and c_1 = 1 + iy (theory, section 3).
    pub fn real_parts(&self, order: u32) -> Vec<(Factor, Turn)> {
        let quarter = Turn::fraction(1, 4);
        match self {
            Factor::Geared(speed, factor) => {
                let parts = factor.real_parts(order / (*speed).max(1)).into_iter();
                parts.map(|(factor, turn)| (factor.geared(*speed), turn)).collect()
            }
            Factor::Motion(rod) if order == 1 => {
                let quarter = if rod.offset.is_negative() { -&quarter } else { quarter };
                vec![(Factor::One, Turn::zero()), (Factor::Quadrature(rod.unsigned()), quarter)]
            }
            Factor::Motion(_) if !order.is_multiple_of(2) => vec![(self.clone(), quarter)],
            // u_k = i (−i)^k E_k.
            Factor::Side(_) if order.is_multiple_of(2) => vec![(self.clone(), quarter)],
            Factor::One
            | Factor::Motion(_)
            | Factor::Quadrature(_)
            | Factor::Torque(_)
            | Factor::DecimalTorque(_)
            | Factor::Side(_)
            | Factor::Linkage(_)
            | Factor::Corrected(..)
            | Factor::OnPin(..)
            | Factor::Open
            | Factor::OpenTorque => vec![(self.clone(), Turn::zero())],
        }
    }
}
