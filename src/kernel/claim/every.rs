//! Do all orders vanish? One period of them decides, where each is one sum: a phase depends on the order only modulo the common denominator.

use num_traits::ToPrimitive;

use super::answer::{Answer, Evidence, Status};
use super::classes::{self, TORQUE, planar};
use super::condition::{of_vanishing, senses};
use super::finding::Finding;
use super::masses;
use super::statement::Orders;
use crate::engine::Engine;
use crate::proof::{Planar, Quantity};
use crate::verdict::{self, Balance, OrderBalance};

/// Longer periods than this are not gone through.
const LONGEST_PERIOD: u32 = 2000;

/// Answers a claim that orders vanish, of an engine whose pistons have one coefficient.
pub(super) fn answer(engine: &Engine, orders: &Orders, quantities: &[Quantity]) -> Answer {
    let Some(quantities) = planar(quantities) else { return Answer::nothing(TORQUE) };
    let (judged, period) = match (orders, period(engine)) {
        (Orders::Listed(list), _) => (list.clone(), None),
        (Orders::From(_), None) if engine.mechanisms().is_empty() => {
            return Answer::nothing("the phases repeat only after more than 2000 orders, and the layout names no rods");
        }
        (Orders::From(first), None) => return classes::every(engine, *first, &quantities),
        (Orders::From(first), Some(period)) => {
            // Without odd ones, 1 and the even ones.
            let is_there = |order: &u32| *order == 1 || order.is_multiple_of(2) || engine.has_odd_orders();
            ((*first..=period + 1).filter(is_there).collect(), Some(period))
        }
    };
    let balances: Vec<OrderBalance> = judged.iter().filter_map(|order| masses::pistons(engine, *order)).collect();
    // With infinitely long rods there are none above 1.
    let existing = balances.iter().filter(|order| order.exists);
    let (vanishing, surviving): (Vec<&OrderBalance>, Vec<&OrderBalance>) =
        existing.partition(|order| asked(order, &quantities).all(Balance::is_balanced));
    // A couple that is free of the reference plane is the plainest counterexample.
    let counterexample = surviving.iter().find(|order| order.moment_is_couple()).or(surviving.first());
    let status = match counterexample {
        Some(_) => Status::False,
        None => {
            let with_moment = quantities.contains(&Planar::Moment);
            let of_moment = vanishing.iter().filter(|_| with_moment);
            let mut once = Vec::new();
            for condition in of_moment.flat_map(|order| of_vanishing(engine, order, &senses(None))) {
                if !once.contains(&condition) {
                    once.push(condition);
                }
            }
            if once.is_empty() { Status::True } else { Status::TrueOnlyIf { conditions: once, met: true } }
        }
    };
    let shown: Vec<&OrderBalance> = counterexample.map_or(vanishing, |order| vec![order]);
    let verdicts = shown.iter().flat_map(|order| asked(order, &quantities).flat_map(Balance::verdicts));
    let evidence = verdicts.map(|verdict| Evidence::Verdict(verdict.clone())).collect();
    let first = counterexample.map(|order| Box::new((*order).clone()));
    let surviving = surviving.iter().map(|order| order.order).collect();
    Answer { status, finding: Finding::Orders { surviving, judged: judged.len(), period, first }, evidence }
}

fn asked<'a>(order: &'a OrderBalance, quantities: &'a [Planar]) -> impl Iterator<Item = &'a Balance> {
    quantities.iter().map(|quantity| order.balance(*quantity))
}

/// The even period of all phases kβ − (k−1)α and −kβ + (k+1)α.
pub(super) fn period(engine: &Engine) -> Option<u32> {
    verdict::period(engine).to_u32().filter(|period| *period <= LONGEST_PERIOD)
}
