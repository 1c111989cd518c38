//! What is the case with the orders of the gas torque, in words?

use super::super::argument::listed;
use super::super::{firing, residual};
use crate::claim::{GasTorque, Statement};
use crate::engine::CycleOrder;
use crate::firing::StarOrder;
use crate::page::{Text, phrase};
use crate::report::texts::claims as text;

/// The stars that a claim is about, or the strongest minor orders.
pub(super) fn found(orders: &[StarOrder], statement: &Statement, holds: bool) -> Text {
    match (statement, orders) {
        (Statement::GasTorque { says: GasTorque::StrongestMinor, orders: claimed, .. }, _) => {
            // What holds of orders that are not in the first half of the period, holds as they mirror or repeat those.
            let others = claimed.iter().filter(|order| holds && orders.iter().all(|found| found.order != **order));
            let others: Vec<Text> = others.map(|order| order.to_string().into()).collect();
            let are_as_strong = (!others.is_empty()).then(|| text::as_strong(listed(others)));
            Text::joined([strongest(orders)].into_iter().chain(are_as_strong), " ")
        }
        (_, [only]) => of_order(only),
        _ => of_several(orders),
    }
}

/// The orders that vanish in one sentence, those that do not in another.
fn of_several(orders: &[StarOrder]) -> Text {
    let (zeros, left): (Vec<&StarOrder>, Vec<&StarOrder>) = orders.iter().partition(|order| order.vanishes());
    let zeros = match zeros.as_slice() {
        [] => None,
        [only] => Some(of_order(only)),
        several => {
            let names = several.iter().map(|order| order.order.to_string().into()).collect();
            Some(text::zero_stars(listed(names), Text::zero()))
        }
    };
    let left = match left.as_slice() {
        [] => None,
        [only] => Some(of_order(only)),
        several => {
            let lengths = several.iter().map(|order| phrase!("{}: {}", order.order.to_string(), lengths(order)));
            Some(text::star_lengths(Text::joined(lengths, "; ")))
        }
    };
    Text::joined(zeros.into_iter().chain(left), " ")
}

fn lengths(order: &StarOrder) -> Text {
    Text::joined(order.stars.iter().map(|star| residual::modulus(star).into()), ", ")
}

/// What the stars of an order leave.
fn of_order(order: &StarOrder) -> Text {
    let name = order.order.to_string();
    let lengths = lengths(order);
    match (order.vanishes(), order.only()) {
        (true, _) => text::zero_star(name, Text::zero()),
        (false, Some(_)) => text::star_length(name, lengths),
        (false, None) => text::lengths_by_rods(name, lengths),
    }
}

fn strongest(orders: &[StarOrder]) -> Text {
    let names: Vec<CycleOrder> = orders.iter().map(|order| order.order).collect();
    match orders.first().and_then(StarOrder::only) {
        Some(star) => firing::strongest_in_words(&names, residual::modulus(star)),
        None => text::no_minor_order(),
    }
}
