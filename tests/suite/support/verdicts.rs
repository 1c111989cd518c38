//! The verdicts on the pistons of an engine, as most tests want them.

use crankstar::engine::Engine;
use crankstar::order::Masses;
use crankstar::proof::{Document, Quantity};
use crankstar::verdict::{self, EveryOrderTheorem, OrderBalance, OrderVerdict};

pub fn quantities(torque: bool) -> Vec<Quantity> {
    [Quantity::FORCE, Quantity::MOMENT].into_iter().chain(torque.then_some(Quantity::TORQUE)).collect()
}

/// One verdict per order.
pub fn judged(engine: &Engine, orders: &[u32], torque: bool) -> Vec<OrderVerdict> {
    verdict::classify(engine, orders, Masses::Reciprocating, &quantities(torque)).expect("orders")
}

/// The sums of each order.
pub fn pistons(engine: &Engine, orders: &[u32]) -> Vec<OrderBalance> {
    judged(engine, orders, false).into_iter().flat_map(|order| order.parts).collect()
}

pub fn theorem(engine: &Engine) -> Result<EveryOrderTheorem, verdict::NoTheorem> {
    verdict::every_order(engine, Masses::Reciprocating)
}

pub fn document(engine: &Engine, orders: &[OrderVerdict], torque: bool, every: Option<&EveryOrderTheorem>) -> Document {
    crankstar::report::document(engine, Masses::Reciprocating, orders, &quantities(torque), every)
}
