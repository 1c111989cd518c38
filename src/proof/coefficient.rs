//! What does the term of a cylinder stand before, and is that zero?

use num_rational::BigRational;
use num_traits::{One, Signed, Zero};
use serde::{Deserialize, Serialize};

use super::engine::{RodClaim, RodStatement};

/// What stands before a sum.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord, Serialize, Deserialize)]
#[serde(rename_all = "lowercase", deny_unknown_fields)]
pub enum Coefficient {
    /// 1.
    One,
    /// The one that all rods have, where none is named.
    Common,
    /// c_k of this rod.
    Rod(RodClaim),
    /// t_k of the torque, which all rods have where none is named.
    #[serde(skip)]
    CommonTorque,
    /// t_k of this rod.
    #[serde(skip)]
    Torque(RodClaim),
}

impl Coefficient {
    /// Whether it is that of rods which are not named.
    pub(super) fn is_open(&self) -> bool {
        match self {
            Coefficient::Common | Coefficient::CommonTorque => true,
            Coefficient::One | Coefficient::Rod(_) | Coefficient::Torque(_) => false,
        }
    }
}

/// The number that a cylinder's term is multiplied by.
#[derive(Clone, Debug)]
pub(super) struct Factor {
    pub coefficient: Coefficient,
    /// Whether the coefficient is zero: the motion of the rod has no such order.
    pub is_zero: bool,
    /// 1, or −1.
    pub sign: BigRational,
}

impl Factor {
    /// In the force. Centric rods have `c_1 = 1` and no other odd order; with the offset's sign the coefficients of odd
    /// orders above 1 change theirs.
    pub fn of_force(rod: &RodStatement, order: u32) -> Self {
        let is_odd = order % 2 == 1;
        let plain = |coefficient, is_zero| Factor { coefficient, is_zero, sign: BigRational::one() };
        match rod {
            RodStatement::Unknown if order == 1 => plain(Coefficient::One, false),
            RodStatement::Unknown => plain(Coefficient::Common, is_odd),
            RodStatement::Known(rod) if order == 1 && rod.offset.is_zero() => plain(Coefficient::One, false),
            RodStatement::Known(rod) if order == 1 => plain(Coefficient::Rod(rod.clone()), false),
            RodStatement::Known(rod) => {
                let one = BigRational::one();
                Factor {
                    coefficient: Coefficient::Rod(RodClaim { ratio: rod.ratio.clone(), offset: rod.offset.abs() }),
                    is_zero: rod.ratio.is_zero() || (rod.offset.is_zero() && is_odd),
                    sign: if rod.offset.is_negative() && is_odd { -one } else { one },
                }
            }
        }
    }

    /// In the force of a mass that turns: that of the rod that it names, or 1.
    pub fn of_shaft(rod: Option<&RodStatement>, order: u32) -> Self {
        let one = || Factor { coefficient: Coefficient::One, is_zero: false, sign: BigRational::one() };
        rod.map_or_else(one, |rod| Factor::of_force(rod, order))
    }

    /// In the inertia torque, where only an infinitely long rod lacks orders: it has the second and no other.
    pub fn of_torque(rod: &RodStatement, order: u32) -> Self {
        let (coefficient, is_zero) = match rod {
            RodStatement::Unknown => (Coefficient::CommonTorque, false),
            RodStatement::Known(rod) => (Coefficient::Torque(rod.clone()), rod.ratio.is_zero() && order != 2),
        };
        Factor { coefficient, is_zero, sign: BigRational::one() }
    }
}
