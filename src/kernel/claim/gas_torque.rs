//! Which orders of the gas torque vanish, or are the strongest that even firing would not leave?

use std::collections::BTreeSet;

use super::answer::{Answer, Evidence, Status};
use super::error::ClaimError;
use super::finding::Finding;
use super::statement::{GasTorque, Statement};
use crate::engine::{CycleOrder, Engine};
use crate::file::parse_number;
use crate::firing::{self, StarOrder, Weights};

const RIGHT: &str = "such as \"the half order vanishes\", \"order 3/2 of the gas torque does not vanish\" or \"order 3/2 is the \
                     strongest minor order in the mode 6, 5, 4, 3, 2, 1\"";
const MODE: &str = " in the mode ";

/// Reads a claim about the gas torque from words in lower case; none where they are about something else.
pub(super) fn parse(text: &str) -> Option<Result<Statement, ClaimError>> {
    let (rest, weights) = match text.split_once(MODE) {
        Some((rest, shape)) => (rest, mode_shape(shape)),
        None => (text, Ok(Weights::Rigid)),
    };
    let statement = |says: GasTorque, orders: Result<Vec<CycleOrder>, ClaimError>| {
        Some(weights.and_then(|weights| Ok(Statement::GasTorque { orders: orders?, says, weights })))
    };
    let says = |predicate: &str| rest.strip_suffix(predicate);
    for predicate in [" is the strongest minor order", " are the strongest minor orders"] {
        if let Some(subject) = says(predicate) {
            return statement(GasTorque::StrongestMinor, orders(subject));
        }
    }
    let predicates = [
        (" does not vanish", GasTorque::Vanishes(false)),
        (" do not vanish", GasTorque::Vanishes(false)),
        (" vanishes", GasTorque::Vanishes(true)),
        (" vanish", GasTorque::Vanishes(true)),
    ];
    let (subject, says) = predicates.into_iter().find_map(|(words, meant)| Some((says(words)?, meant)))?;
    if matches!(subject, "the half order" | "half order") {
        return statement(says, orders("order 1/2"));
    }
    let subject = subject.strip_suffix(" of the gas torque")?;
    statement(says, orders(subject))
}

/// `order 3/2`, `orders 1/2, 5/2 and 7/2`.
fn orders(subject: &str) -> Result<Vec<CycleOrder>, ClaimError> {
    let list = subject.strip_prefix("orders ").or_else(|| subject.strip_prefix("order "));
    let list = list.ok_or_else(|| ClaimError::new(format!("`{subject}` names no order"), RIGHT))?;
    let list = list.replace(" and ", ",");
    let order = |word: &str| word.trim().parse().map_err(|error| ClaimError::new(format!("{error}"), RIGHT));
    list.split(',').map(order).collect()
}

fn mode_shape(shape: &str) -> Result<Weights, ClaimError> {
    let value = |word: &str| {
        let word = word.trim();
        parse_number(word).map_err(|error| ClaimError::new(format!("`{word}`: {error}"), RIGHT))
    };
    Ok(Weights::ModeShape(shape.split(',').map(value).collect::<Result<_, _>>()?))
}

/// Answers a claim about the gas torque.
pub(super) fn answer(engine: &Engine, orders: &[CycleOrder], says: GasTorque, weights: &Weights) -> Answer {
    if engine.gas().is_some_and(|gas| !gas.is_shared()) {
        return Answer::nothing(
            "the gas of the layout differs between its cylinders, and a firing star is about one that they share",
        );
    }
    match says {
        GasTorque::Vanishes(claimed) => match firing::firing_stars(engine, orders, weights) {
            Err(why) => Answer::nothing(why.to_string()),
            Ok(found) => {
                let holds = found.iter().all(|order| order.vanishes() == claimed);
                answered(holds, &found, found.iter())
            }
        },
        GasTorque::StrongestMinor => match firing::pattern(engine, weights) {
            Err(why) => Answer::nothing(why.to_string()),
            Ok(pattern) if pattern.orders.iter().any(|order| order.only().is_none()) => {
                Answer::nothing("the rods differ, so that no order of the gas torque is a single star")
            }
            Ok(pattern) => {
                let strongest: Vec<StarOrder> = pattern.strongest_minor().into_iter().cloned().collect();
                let claimed: BTreeSet<CycleOrder> = orders.iter().map(|order| pattern.folded(*order)).collect();
                let found: BTreeSet<CycleOrder> = strongest.iter().map(|order| order.order).collect();
                answered(!found.is_empty() && claimed == found, &strongest, pattern.orders.iter())
            }
        },
    }
}

fn answered<'a>(holds: bool, found: &[StarOrder], evidence: impl Iterator<Item = &'a StarOrder>) -> Answer {
    let stars = evidence.flat_map(|order| order.stars.iter().map(move |star| (order.order, star)));
    Answer {
        status: Status::of(holds),
        finding: Finding::FiringStars(found.to_vec()),
        evidence: stars.map(|(order, star)| Evidence::FiringStar(order, star.clone())).collect(),
    }
}
