//! What is the term of a cylinder multiplied by, and is that zero?

use num_rational::BigRational;
use num_traits::{One, Signed, Zero};
use serde::{Deserialize, Serialize};

use super::engine::RodStatement;
use super::knuckle::{KnuckleClaim, Part};
use super::link::{LinkClaim, LinkageClaim};
use super::rod::RodClaim;
use super::vector::Vector;

/// What a sum is multiplied by.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord, Serialize, Deserialize)]
#[serde(rename_all = "lowercase", deny_unknown_fields)]
pub enum Coefficient {
    /// 1.
    One,
    /// The one that all rods have, where none is named.
    Common,
    /// c_k of this rod.
    Rod(RodClaim),
    /// y of c_1 = 1 + iy of this rod, whose offset is positive.
    Quadrature(RodClaim),
    /// g_k of this link on a master rod.
    Linkage(LinkageClaim),
    /// A part of h_k of this link with a corrected knuckle angle.
    Corrected(KnuckleClaim),
    /// t_k of the torque, which all rods have where none is named.
    #[serde(skip)]
    CommonTorque,
    /// t_k of this rod.
    #[serde(skip)]
    Torque(RodClaim),
    /// One of these of a crank that turns this many times, at least twice, while the reference turns once: that of its own order, the order
    /// divided by this.
    Geared(GearedClaim),
}

/// The coefficient of a crank that turns faster than the reference.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct GearedClaim {
    /// How many times it turns.
    pub speed: u32,
    /// Its coefficient.
    pub of: Box<Coefficient>,
}

impl GearedClaim {
    /// Which order of its own motion this order of the engine is.
    pub(super) fn own_order(&self, order: u32) -> u32 {
        order / self.speed.max(1)
    }
}

impl Coefficient {
    /// Whether it is that of rods which are not named.
    pub(super) fn is_open(&self) -> bool {
        match self {
            Coefficient::Common | Coefficient::CommonTorque => true,
            Coefficient::Geared(geared) => geared.of.is_open(),
            Coefficient::One | Coefficient::Rod(_) | Coefficient::Quadrature(_) | Coefficient::Torque(_) => false,
            Coefficient::Linkage(_) | Coefficient::Corrected(_) => false,
        }
    }

    /// Whether no theorem says that it is not zero where it is there.
    pub(super) fn may_be_zero(&self) -> bool {
        match self {
            Coefficient::Corrected(_) => true,
            Coefficient::Geared(geared) => geared.of.may_be_zero(),
            Coefficient::One | Coefficient::Common | Coefficient::Rod(_) | Coefficient::Linkage(_) => false,
            Coefficient::Quadrature(_) | Coefficient::CommonTorque | Coefficient::Torque(_) => false,
        }
    }

    /// The real numbers that it is made of in an order, each with the turns by which it turns a direct sum, and a reverse one the other way:
    /// that of a rod is real in even orders, imaginary in odd ones above 1, and 1 + iy in order 1.
    pub(super) fn real_parts(&self, order: u32) -> Vec<(Coefficient, BigRational)> {
        let none = || BigRational::zero();
        let quarter = |sign: i64| BigRational::new(sign.into(), 4.into());
        match self {
            Coefficient::Geared(geared) => {
                let parts = geared.of.real_parts(geared.own_order(order)).into_iter();
                parts.map(|(part, turn)| (part.geared(geared.speed), turn)).collect()
            }
            Coefficient::Rod(rod) if order == 1 => {
                let sign = if rod.offset.is_negative() { -1 } else { 1 };
                let y = Coefficient::Quadrature(RodClaim { ratio: rod.ratio.clone(), offset: rod.offset.abs() });
                vec![(Coefficient::One, none()), (y, quarter(sign))]
            }
            Coefficient::Rod(_) if order % 2 == 1 => vec![(self.clone(), quarter(1))],
            Coefficient::One | Coefficient::Common | Coefficient::Rod(_) | Coefficient::Quadrature(_) => {
                vec![(self.clone(), none())]
            }
            Coefficient::Linkage(_)
            | Coefficient::Corrected(_)
            | Coefficient::CommonTorque
            | Coefficient::Torque(_) => vec![(self.clone(), none())],
        }
    }

    /// The same of a crank that turns this many times while the reference turns once; 1 stays 1.
    pub(super) fn geared(self, speed: u32) -> Self {
        match (speed, self) {
            (_, Coefficient::One) => Coefficient::One,
            (1, own) => own,
            (_, own) => Coefficient::Geared(GearedClaim { speed, of: Box::new(own) }),
        }
    }
}

/// A number that terms of a cylinder are multiplied by.
#[derive(Clone, Debug)]
pub(super) struct Factor {
    pub coefficient: Coefficient,
    /// Whether the coefficient is zero: the motion of the rod has no such order.
    pub is_zero: bool,
    /// What the vector of the cylinder is multiplied by before it: a vector of length 1 in direction 0, its opposite, or several of
    /// a link. In a reverse sum they are turned the other way.
    pub parts: Vec<Vector>,
}

/// A vector in direction 0.
fn along(weight: BigRational) -> Vec<Vector> {
    vec![Vector { angle: BigRational::zero(), weight }]
}

impl Factor {
    /// Before the vector as it is.
    fn plain(coefficient: Coefficient, is_zero: bool) -> Self {
        Factor { coefficient, is_zero, parts: along(BigRational::one()) }
    }

    /// In the force. Centric rods have `c_1 = 1` and no other odd order; with the offset's sign the coefficients of odd
    /// orders above 1 change theirs.
    ///
    /// A link has its master's in part, and one of its own; in order 1 it is as a centric rod.
    pub fn of_force(rod: &RodStatement, order: u32, do_rods_differ: bool) -> Vec<Self> {
        let is_odd = order % 2 == 1;
        match rod {
            RodStatement::Unknown if order == 1 => vec![Factor::plain(Coefficient::One, false)],
            RodStatement::Unknown => vec![Factor::plain(Coefficient::Common, is_odd)],
            RodStatement::Known(rod) => Factor::of_rod_in_parts(rod, order, do_rods_differ),
            RodStatement::Link(link) if link.is_corrected() => Factor::of_corrected(link, order),
            RodStatement::Link(_) if order == 1 => vec![Factor::plain(Coefficient::One, false)],
            RodStatement::Link(link) => {
                let master = Factor { parts: link.with_the_master(order), ..Factor::of_rod(&link.master_rod(), order) };
                if is_odd {
                    // Neither coefficient is there: one stands for both.
                    return vec![master];
                }
                let linkage = link.linkage();
                let is_zero = linkage.lacks(order);
                vec![
                    master,
                    Factor { coefficient: Coefficient::Linkage(linkage), is_zero, parts: link.on_its_own(order) },
                ]
            }
        }
    }

    /// In the force of a link with a corrected knuckle angle, of every order.
    fn of_corrected(link: &LinkClaim, order: u32) -> Vec<Self> {
        let mut factors = Vec::new();
        if order == 1 {
            factors.push(Factor { coefficient: Coefficient::One, is_zero: false, parts: link.beside_its_own() });
        } else if order.is_multiple_of(2) {
            let master = Factor::of_rod(&link.master_rod(), order);
            factors.push(Factor { parts: link.swung_with_the_master(order), ..master });
        }
        factors.extend([Part::Real, Part::Imaginary].map(|part| {
            let linkage = link.corrected(part);
            let is_zero = linkage.lacks(order);
            Factor { coefficient: Coefficient::Corrected(linkage), is_zero, parts: vec![link.turned_into(part, order)] }
        }));
        factors
    }

    /// In the force, of a rod on the crankpin: c_1 = 1 + iy of an offset is taken apart where the engine has rods of several kinds. y changes its sign
    /// with the offset.
    fn of_rod_in_parts(rod: &RodClaim, order: u32, do_rods_differ: bool) -> Vec<Self> {
        if order != 1 || rod.offset.is_zero() || !do_rods_differ {
            return vec![Factor::of_rod(rod, order)];
        }
        let one = BigRational::one();
        let weight = if rod.offset.is_negative() { -one.clone() } else { one.clone() };
        let y = Coefficient::Quadrature(RodClaim { ratio: rod.ratio.clone(), offset: rod.offset.abs() });
        let turned = vec![Vector { angle: BigRational::new(1.into(), 4.into()), weight }];
        vec![
            Factor { coefficient: Coefficient::One, is_zero: false, parts: along(one) },
            Factor { coefficient: y, is_zero: false, parts: turned },
        ]
    }

    /// In the force, of a rod on the crankpin.
    pub fn of_rod(rod: &RodClaim, order: u32) -> Self {
        let is_odd = order % 2 == 1;
        match (order, rod.offset.is_zero()) {
            (1, true) => Factor::plain(Coefficient::One, false),
            (1, false) => Factor::plain(Coefficient::Rod(rod.clone()), false),
            _ => {
                let one = BigRational::one();
                Factor {
                    coefficient: Coefficient::Rod(RodClaim { ratio: rod.ratio.clone(), offset: rod.offset.abs() }),
                    is_zero: rod.ratio.is_zero() || (rod.offset.is_zero() && is_odd),
                    parts: along(if rod.offset.is_negative() && is_odd { -one } else { one }),
                }
            }
        }
    }

    /// In the force of a mass that turns: that of the rod that it names, or 1. It names no link.
    pub fn of_shaft(rod: Option<&RodStatement>, order: u32, do_rods_differ: bool) -> Vec<Self> {
        let plain = |coefficient, is_zero| vec![Factor::plain(coefficient, is_zero)];
        match rod {
            None => plain(Coefficient::One, false),
            Some(RodStatement::Unknown) if order == 1 => plain(Coefficient::One, false),
            Some(RodStatement::Unknown | RodStatement::Link(_)) => plain(Coefficient::Common, order % 2 == 1),
            Some(RodStatement::Known(rod)) => Factor::of_rod_in_parts(rod, order, do_rods_differ),
        }
    }

    /// In the inertia torque, where only an infinitely long rod lacks orders: it has the second and no other. That of a link is not
    /// judged.
    pub fn of_torque(rod: &RodStatement, order: u32) -> Self {
        let (coefficient, is_zero) = match rod {
            RodStatement::Unknown | RodStatement::Link(_) => (Coefficient::CommonTorque, false),
            RodStatement::Known(rod) => (Coefficient::Torque(rod.clone()), rod.ratio.is_zero() && order != 2),
        };
        Factor::plain(coefficient, is_zero)
    }
}
