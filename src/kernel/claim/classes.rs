//! Is it true of an engine with several kinds of rods, or crankshafts of several speeds, of whose orders but few are single sums?

use super::absolute::Numbers;
use super::answer::{Answer, Status};
use super::every::{TORQUE, planar};
use super::finding::Finding;
use super::order;
use super::shafts::evidence;
use super::statement::{Orders, Predicate, Statement, Subject};
use crate::engine::Engine;
use crate::order::Masses;
use crate::proof::{Planar, Quantity, Sense, Shape};
use crate::verdict::{self, OrderVerdict, Outcome, WholeOrder, both_vanish};

/// Answers whether orders vanish and which shape is left; sizes and directions are compared where an order is one sum.
pub(super) fn answer(engine: &Engine, statement: &Statement, numbers: Option<&Numbers>) -> Answer {
    match statement {
        Statement::Order { subject: subject @ Subject { quantity: Quantity::Planar(quantity), .. }, predicate } => {
            one(engine, *subject, *quantity, predicate, numbers)
        }
        Statement::Vanish { orders: Orders::Listed(orders), quantities } => listed(engine, orders, quantities),
        Statement::Order { .. }
        | Statement::Vanish { .. }
        | Statement::NoFreeMoment
        | Statement::Shafts { .. }
        | Statement::CanBalance(_)
        | Statement::CrankshaftMass(_)
        | Statement::BearingLoad(_)
        | Statement::WorstBearings(_)
        | Statement::LargestLoad(..)
        | Statement::ShakingForce(_)
        | Statement::Formula(_)
        | Statement::GasTorque { .. }
        | Statement::FiresEvenly { .. } => Answer::nothing(match engine.faster_crank() {
            Some(_) => "a crankshaft turns faster than the reference, so no order is a single sum",
            None => "the rods of the engine or their offsets differ, so no order is a single sum",
        }),
    }
}

fn judged(engine: &Engine, order: u32, masses: Masses) -> Option<OrderVerdict> {
    verdict::classify(engine, &[order], masses, &Quantity::PLANAR).ok()?.into_iter().next()
}

fn one(
    engine: &Engine,
    subject: Subject,
    quantity: Planar,
    predicate: &Predicate,
    numbers: Option<&Numbers>,
) -> Answer {
    let Some(order) = judged(engine, subject.order, subject.masses) else { return Answer::nothing("no order") };
    // Order 1 of centric rods and of links is one sum whatever the rods are, and an order that does not exist is 0.
    let is_single = order.parts.len() == 1 && engine.faster_crank().is_none();
    if is_single || !order.exists() {
        return order::answer(engine, subject, predicate, numbers);
    }
    let whole = order.whole(quantity);
    let vanishes = vanish(whole, subject.sense);
    let holds = match (predicate, subject.sense) {
        (Predicate::Vanishes(claimed), _) => vanishes.map(|vanishes| vanishes == *claimed),
        (Predicate::Is(shape), None) => match whole.shape {
            Shape::NotDecided => None,
            found => Some(found == *shape),
        },
        (Predicate::Is(_) | Predicate::Equals(..) | Predicate::Plane(_), _) => {
            return Answer::nothing(match engine.faster_crank() {
                Some(_) => {
                    "a crankshaft turns faster than the reference and an order has a sum for each speed, so that its size and direction are not compared"
                }
                None => {
                    "the rods of the engine or their offsets differ and this order has a sum for each kind, so that its size and direction are not compared"
                }
            });
        }
    };
    Answer { status: status(holds), evidence: evidence(&order), finding: Finding::CombinedOrders(vec![order]) }
}

fn listed(engine: &Engine, orders: &[u32], quantities: &[Quantity]) -> Answer {
    let Some(quantities) = planar(quantities) else { return Answer::nothing(TORQUE) };
    let orders: Vec<OrderVerdict> =
        orders.iter().filter_map(|order| judged(engine, *order, Masses::Reciprocating)).collect();
    let asked = orders.iter().filter(|order| order.exists());
    let outcomes: Vec<Option<bool>> =
        asked.flat_map(|order| quantities.iter().map(|quantity| vanish(order.whole(*quantity), None))).collect();
    let holds = match (outcomes.contains(&Some(false)), outcomes.contains(&None)) {
        (true, _) => Some(false),
        (false, true) => None,
        (false, false) => Some(true),
    };
    let evidence = orders.iter().flat_map(evidence).collect();
    Answer { status: status(holds), finding: Finding::CombinedOrders(orders), evidence }
}

fn vanish(whole: &WholeOrder, sense: Option<Sense>) -> Option<bool> {
    let [direct, reverse] = whole.outcomes.each_ref().map(Outcome::vanishes);
    match sense {
        Some(Sense::Direct) => direct,
        Some(Sense::Reverse) => reverse,
        None => both_vanish(direct, reverse),
    }
}

fn status(holds: Option<bool>) -> Status {
    holds.map_or(Status::NotDecided, Status::of)
}
