//! What does an exact sum stand before? 1, or a number of the motion of a rod.

use num_rational::BigRational;
use num_traits::{One, Signed, Zero};

use crate::engine::Rod;
use crate::proof::Quantity;

/// The number that a sum stands before in an order.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Factor {
    /// 1: masses that turn, and order 1 of centric rods.
    One,
    /// c_k of this rod, whose offset is not negative above order 1; conjugated in reverse sums.
    Motion(Rod),
    /// t_k, the coefficient of the inertia torque, of this rod.
    Torque(Rod),
    /// The same of the rods of an engine that names none: centric, alike, and not zero where it is looked at.
    Open,
}

impl Factor {
    /// What the force of a cylinder with this rod stands before, and with which sign; none where it is zero: such an order
    /// does not exist. A rod that the layout does not
    /// name is centric.
    ///
    /// The root `√(1−(λ sinψ−δ)²)` stays as it is where δ changes its sign and ψ goes on by half a turn, so that its
    /// coefficient of order k then changes by (−1)^k; c_1 has the crank's own 1 beside it.
    pub fn of_force(rod: Option<&Rod>, order: u32) -> Option<(Factor, BigRational)> {
        let one = BigRational::one();
        let is_odd = order % 2 == 1;
        let Some(rod) = rod else {
            return match order {
                1 => Some((Factor::One, one)),
                _ if is_odd => None,
                _ => Some((Factor::Open, one)),
            };
        };
        match order {
            1 if rod.offset.is_zero() => Some((Factor::One, one)),
            1 => Some((Factor::Motion(rod.clone()), one)),
            _ if !rod.has_order(Quantity::Force, order) => None,
            _ => {
                let sign = if rod.offset.is_negative() && is_odd { -one } else { one };
                Some((Factor::Motion(Rod { ratio: rod.ratio.clone(), offset: rod.offset.abs() }), sign))
            }
        }
    }

    /// What the inertia torque of a cylinder with this rod stands before; none where it is zero.
    pub fn of_torque(rod: Option<&Rod>, order: u32) -> Option<Factor> {
        let Some(rod) = rod else { return Some(Factor::Open) };
        rod.has_order(Quantity::Torque, order).then(|| Factor::Torque(rod.clone()))
    }
}
