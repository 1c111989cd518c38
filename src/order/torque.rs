//! Which sums make the inertia torque of an order?

use super::factor::Factor;
use super::phase::phase;
use super::sum::OrderSum;
use super::turning::mass_radius;
use crate::engine::Engine;
use crate::exact::Term;
use crate::proof::Quantity;

/// The inertia torque of one order: `Σ m r² e^{ik(β−α)}` before t_k of each rod, in multiples of m r².
pub fn torque(engine: &Engine, order: u32) -> OrderSum {
    OrderSum::new(engine.cylinders().iter().filter_map(|cylinder| {
        let factor = Factor::of_torque(cylinder.mechanism.as_ref());
        let weight = mass_radius(engine, cylinder) * &cylinder.crank_radius;
        let term = Term { angle: phase(cylinder, order, None), weight };
        factor.exists(Quantity::Torque, order).then_some((factor, term))
    }))
}
