//! What is the case with the orders of the gas torque, in words?

use super::super::{firing, residual};
use crate::claim::{GasTorque, Statement};
use crate::engine::CycleOrder;
use crate::firing::StarOrder;
use crate::page::{Text, phrase};

/// The stars that a claim is about, or the strongest minor orders.
pub(super) fn found(orders: &[StarOrder], statement: &Statement) -> Text {
    match statement {
        Statement::GasTorque { says: GasTorque::StrongestMinor, .. } => strongest(orders),
        _ => Text::joined(orders.iter().map(of_order), " "),
    }
}

/// What the stars of an order leave.
fn of_order(order: &StarOrder) -> Text {
    let name = order.order.to_string();
    let lengths = Text::joined(order.stars.iter().map(|star| residual::modulus(star).into()), ", ");
    match (order.vanishes(), order.only()) {
        (true, _) => phrase!("The firing star of order {} is {}.", name, Text::zero()),
        (false, Some(_)) => phrase!("The firing star of order {} has length {}.", name, lengths),
        (false, None) => {
            phrase!("The firing stars of order {}, one for each kind of rod, have lengths {}.", name, lengths)
        }
    }
}

fn strongest(orders: &[StarOrder]) -> Text {
    let names: Vec<CycleOrder> = orders.iter().map(|order| order.order).collect();
    match orders.first().and_then(StarOrder::only) {
        Some(star) => firing::strongest_in_words(&names, residual::modulus(star)),
        None => "No minor order is left.".into(),
    }
}
