//! Which orders does an engine have at all, and how is it said that one is missing?
//!
//! The theorem is that of [`crate::motion`]: order 1 of the force always exists; for λ > 0 the even ones do, and with a pin offset
//! every one; in the inertia torque every order. A link with a corrected knuckle angle may have every order. An infinitely long rod, λ = 0, has order 1 of the force and order 2 of the torque.

use std::ops::RangeInclusive;

use num_traits::Zero;

use super::cylinder::Cylinder;
use super::geared_crank::{GearedCrank, own_order};
use super::mechanism::{Mechanism, Rod};
use super::ray::Ray;
use crate::proof::Quantity;

/// The highest order that is answered.
pub const HIGHEST_ORDER: u32 = 1000;
/// The orders that are answered.
pub const ORDERS: RangeInclusive<u32> = 1..=HIGHEST_ORDER;

/// A number that is no order.
#[derive(Clone, Copy, Debug, PartialEq, Eq, thiserror::Error)]
#[error("{0} is not an order; an order is a whole number from 1 to {HIGHEST_ORDER}")]
pub struct NotAnOrder(pub u32);

/// Whether every number of a list is an order.
///
/// # Errors
/// The first that is none.
pub fn are_orders(numbers: &[u32]) -> Result<(), NotAnOrder> {
    match numbers.iter().find(|number| !ORDERS.contains(number)) {
        None => Ok(()),
        Some(&number) => Err(NotAnOrder(number)),
    }
}

/// What every page and table says of an order whose coefficient is 0.
pub const DOES_NOT_EXIST: &str = "does not exist";

/// Why an order does not exist, as a sentence.
pub const WHY_NOT: &str = "“Does not exist”: the coefficient of the order is 0: without a pin offset the odd orders above 1 of force and moment; with infinitely long rods every order of force and moment but 1, and of the torque but 2.";

impl Mechanism {
    /// Whether the coefficient of an order is not zero; there is no order 0.
    pub fn has_order(&self, quantity: Quantity, order: u32) -> bool {
        if let Some(rod) = self.rod() {
            return rod.has_order(quantity, order);
        }
        let mut laws = Ray::of(self).into_iter().map(|ray| ray.law).filter(|law| !law.is_endless());
        match (quantity, order) {
            (_, 0) => false,
            (Quantity::Axial(_), _) => order == 2 || laws.next().is_some(),
            (Quantity::Planar(_), _) => order == 1 || laws.any(|law| law.has_parity_of(order)),
        }
    }
}

impl Rod {
    /// Whether the coefficient of an order is not zero.
    pub fn has_order(&self, quantity: Quantity, order: u32) -> bool {
        match (quantity, order) {
            (_, 0) => false,
            (Quantity::Axial(_), _) => order == 2 || !self.ratio.is_zero(),
            (Quantity::Planar(_), 1) => true,
            (Quantity::Planar(_), _) => !self.ratio.is_zero() && (order.is_multiple_of(2) || !self.offset.is_zero()),
        }
    }
}

/// Whether one of these pistons has an order; each that of its own crank.
pub(super) fn pistons_have_order<A, L>(
    cylinders: &[Cylinder<A, L>],
    cranks: &[GearedCrank],
    quantity: Quantity,
    order: u32,
) -> bool {
    cylinders.iter().any(|cylinder| {
        let own = own_order(cranks.get(cylinder.crank).map_or(1, |crank| crank.speed), order);
        own.is_some_and(|own| has_order(cylinder.mechanism.as_ref(), quantity, own))
    })
}

/// Of one piston, in the orders of its own crank.
pub(super) fn has_order(mechanism: Option<&Mechanism>, quantity: Quantity, order: u32) -> bool {
    match (mechanism, quantity) {
        (Some(mechanism), _) => mechanism.has_order(quantity, order),
        (None, Quantity::Axial(_)) => order > 0,
        (None, Quantity::Planar(_)) => order == 1 || (order > 0 && order.is_multiple_of(2)),
    }
}
