//! How does the frame roll? With what answers the inertia torque, and with the forces whose lines pass beside its middle: those of
//! pistons with an offset or on several crankshafts, and of balancer shafts (theory, sections 12 and 14).

use super::order_loads::{Torque, TorqueOrder, turning_orders};
use super::{Missing, Motion, Vector};
use crate::engine::{Engine, are_orders};
use crate::order;

/// The roll moment on the frame at these orders, and at those of the shafts and the faster crankshafts, in multiples of m r² ω².
pub(super) fn roll(engine: &Engine, motion: &Motion, orders: &[u32]) -> Torque {
    let mut all: Vec<u32> = orders.iter().copied().chain(turning_orders(engine)).collect();
    all.sort_unstable();
    all.dedup();
    Torque::new(all.into_iter().map(|order| of_order(engine, motion, order)).collect())
}

/// The roll moment of the masses on the frame about the middle of the engine at these orders, in multiples of m r² ω²; every length that
/// it hangs on has to be there ([`order::roll_lacks`]).
///
/// # Errors
/// What the layout lacks, and orders that are none.
pub fn roll_moments(engine: &Engine, orders: &[u32]) -> Result<Vec<TorqueOrder>, Missing> {
    are_orders(orders)?;
    Missing::unless_torque_is_judged(engine, "roll moments")?;
    let motion = Motion::new(engine)?;
    Ok(orders.iter().map(|&order| of_order(engine, &motion, order)).collect())
}

fn of_order(engine: &Engine, motion: &Motion, order: u32) -> TorqueOrder {
    let roll = order::roll(engine, order);
    let pairs: Vec<_> = roll.parts().iter().map(|(factor, sum)| (motion.coefficient(factor, order), sum)).collect();
    TorqueOrder { order, coefficient: None, vector: Vector::of(&pairs, false) }
}
