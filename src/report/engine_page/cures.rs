//! What takes away what is left: counterweights for what turns with the crank, balancer shafts for the rest?

use super::answer::{is_as_built, left_vectors};
use crate::engine::Engine;
use crate::page::{self, Piece, Text, phrase};
use crate::remedy::{self, Wish};
use crate::verdict::{Judgement, OrderVerdict};

/// Orders above this are usually left as they are.
const USUALLY_CURED: u32 = 2;

/// What takes away what is left, orders that need the same told together.
pub(super) fn cures(engine: &Engine, judged: &Judgement, orders: &[&OrderVerdict]) -> Vec<Text> {
    let first = orders.iter().find(|order| order.order == 1);
    let mut cures: Vec<Text> = first.and_then(|order| first_order_cure(engine, judged, order)).into_iter().collect();
    for vectors in [[true, true], [true, false], [false, true]] {
        let alike = orders.iter().filter(|order| order.order > 1 && left_vectors(order) == vectors);
        let alike: Vec<u32> = alike.map(|order| order.order).collect();
        cures.extend(higher_cure(vectors, &alike));
    }
    let is_left = |order: &&OrderVerdict| order.order > USUALLY_CURED && left_vectors(order) != [false, false];
    if orders.iter().any(is_left) {
        cures.push(phrase!("Orders above {} are usually left as they are.", USUALLY_CURED));
    }
    cures
}

/// What takes order 1 away; none where nothing is left.
fn first_order_cure(engine: &Engine, judged: &Judgement, order: &OrderVerdict) -> Option<Text> {
    match left_vectors(order) {
        [false, false] => None,
        [true, false] => Some(phrase!("Order 1: {}.", counterweights(engine, judged))),
        [false, true] => Some("Order 1: one balancer shaft at crank speed, turning against the crank.".into()),
        [true, true] => Some(phrase!(
            "Order 1: {} for what turns with the crank, and one balancer shaft at crank speed for what turns against it.",
            counterweights(engine, judged)
        )),
    }
}

/// What takes higher orders away that leave the same vectors.
fn higher_cure(vectors: [bool; 2], orders: &[u32]) -> Option<Text> {
    let [one, several] = match vectors {
        [false, false] => return None,
        [true, false] => WITH,
        [false, true] => AGAINST,
        [true, true] => PAIR,
    };
    match orders {
        [] => None,
        [only] => Some(phrase!(one, *only, times(*only))),
        many => {
            let names: Vec<String> = many.iter().map(u32::to_string).collect();
            Some(phrase!(several, names.join(", ")))
        }
    }
}

const WITH: [&str; 2] = [
    "Order {}: one balancer shaft at {} crank speed, turning with the crank.",
    "Orders {}: one balancer shaft for each, at that many times crank speed, turning with the crank.",
];
const AGAINST: [&str; 2] = [
    "Order {}: one balancer shaft at {} crank speed, turning against the crank.",
    "Orders {}: one balancer shaft for each, at that many times crank speed, turning against the crank.",
];
const PAIR: [&str; 2] = [
    "Order {}: two balancer shafts at {} crank speed, one turning each way.",
    "Orders {}: two balancer shafts for each, at that many times crank speed, one turning each way.",
];

fn times(order: u32) -> Text {
    match order {
        2 => "twice".into(),
        3 => "three times".into(),
        4 => "four times".into(),
        6 => "six times".into(),
        other => phrase!("{} times", other),
    }
}

/// Counterweights on the crankshaft, with their sizes where the file gives numbers.
fn counterweights(engine: &Engine, judged: &Judgement) -> Text {
    let bare = Text::from("counterweights on the crankshaft");
    if !is_as_built(engine, judged) {
        return bare;
    }
    let Ok(remedy) = remedy::remedy(engine, &Wish { orders: vec![1], ..Wish::default() }) else { return bare };
    let weights = remedy.crankshaft.iter().flat_map(|shaft| &shaft.weights);
    let weights = weights.filter_map(|weight| remedy.as_built(weight));
    let sizes: Option<Vec<f64>> = weights.map(|weight| weight.mass_radius(&remedy.subject)).collect();
    let size = |size: f64| Text::from(Piece::Quantity(size, page::Unit::KILOGRAM_METRE));
    match sizes.as_deref() {
        None | Some([]) => bare,
        Some([only]) => phrase!("a counterweight of {} on the crankshaft", size(*only)),
        Some(several) => {
            let alike = several.iter().all(|other| (other - several[0]).abs() <= 1e-9 * several[0]);
            match (alike, several.len()) {
                (true, 2) => phrase!("two counterweights of {} each on the crankshaft", size(several[0])),
                (true, count) => phrase!("{} counterweights of {} each on the crankshaft", count, size(several[0])),
                (false, _) => phrase!(
                    "counterweights of {} on the crankshaft",
                    Text::joined(several.iter().map(|value| size(*value)), ", ")
                ),
            }
        }
    }
}
