//! What does an exact sum stand before? 1, or a number of the motion of a piston.

use num_rational::BigRational;
use num_traits::{One, Signed, Zero};

use crate::engine::{Mechanism, Rod};
use crate::proof::Quantity;

/// The number that a sum stands before in an order.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Factor {
    /// 1: masses that turn, and order 1 of centric rods.
    One,
    /// c_k of this mechanism, whose offset is not negative above order 1; conjugated in reverse sums.
    Motion(Mechanism),
    /// t_k, the coefficient of the inertia torque, of this mechanism.
    Torque(Mechanism),
    /// The same of the rods of an engine that names none: centric, alike, and not zero where it is looked at.
    Open,
}

impl Factor {
    /// What the force of a cylinder with this mechanism stands before, and with which sign; none where it is zero: such an
    /// order does not exist. A mechanism of which nothing is known is a centric crank.
    ///
    /// The root `√(1−(λ sinψ−δ)²)` stays as it is where δ changes its sign and ψ goes on by half a turn, so that its
    /// coefficient of order k then changes by (−1)^k; c_1 has the crank's own 1 beside it.
    pub fn of_force(mechanism: Option<&Mechanism>, order: u32) -> Option<(Factor, BigRational)> {
        let one = BigRational::one();
        let is_odd = order % 2 == 1;
        let Some(mechanism) = mechanism else {
            return match order {
                1 => Some((Factor::One, one)),
                _ if is_odd => None,
                _ => Some((Factor::Open, one)),
            };
        };
        match mechanism {
            _ if !mechanism.has_order(Quantity::Force, order) => None,
            Mechanism::SliderCrank(rod) if order == 1 && rod.offset.is_zero() => Some((Factor::One, one)),
            Mechanism::SliderCrank(_) if order == 1 => Some((Factor::Motion(mechanism.clone()), one)),
            Mechanism::SliderCrank(rod) => {
                let sign = if rod.offset.is_negative() && is_odd { -one } else { one };
                let mirrored = Rod { ratio: rod.ratio.clone(), offset: rod.offset.abs() };
                Some((Factor::Motion(Mechanism::SliderCrank(mirrored)), sign))
            }
        }
    }

    /// What the inertia torque of a cylinder with this mechanism stands before; none where it is zero.
    pub fn of_torque(mechanism: Option<&Mechanism>, order: u32) -> Option<Factor> {
        let Some(mechanism) = mechanism else { return Some(Factor::Open) };
        mechanism.has_order(Quantity::Torque, order).then(|| Factor::Torque(mechanism.clone()))
    }
}
