//! What is left of an order, and how is it put in a few words?

use num_rational::BigRational;
use num_traits::Zero;

use super::typeset::{self, Amount, Bearing, number, signed_degrees};
use crate::exact::{PhasorSum, Turn};
use crate::layout::{DOES_NOT_EXIST, Layout};
use crate::numbers::{self, Direction};
use crate::order;
use crate::proof::{Quantity, Shape};
use crate::verdict::{Balance, Class, OrderBalance, Verdict};

/// `|S|` of a verdict.
pub(super) fn modulus(verdict: &Verdict) -> Amount {
    if verdict.vanishes() { Amount::zero() } else { modulus_of(&verdict.sum) }
}

/// `|S|` of a sum that is not zero.
pub(super) fn modulus_of(sum: &PhasorSum) -> Amount {
    Amount { exact: numbers::modulus(sum), decimal: numbers::evaluate(sum).norm() }
}

/// The direction of a sum that is not zero.
pub(super) fn bearing(sum: &PhasorSum) -> Bearing {
    Bearing { exact: numbers::direction_of(sum), decimal: numbers::degrees(numbers::evaluate(sum)) }
}

/// The largest value through a revolution, `½(|P⁺| + |P⁻|)`.
pub(super) fn largest(balance: &Balance) -> Amount {
    modulus(&balance.direct).mean(&modulus(&balance.reverse))
}

/// The word for a shape.
pub(super) fn shape_name(shape: Shape) -> &'static str {
    match shape {
        Shape::Balanced => "balanced",
        Shape::Rotating => "rotating",
        Shape::CounterRotating => "counter-rotating",
        Shape::Planar => "planar",
        Shape::Elliptical => "elliptical",
        Shape::NotDecided => "not decided",
    }
}

/// The number of an order, and the cylinders that it is about where not all are meant.
pub fn order_name(order: &OrderBalance) -> String {
    match &order.class {
        None => order.order.to_string(),
        Some(class) => format!("{} ({})", order.order, class_words(class)),
    }
}

/// `cylinders 1–3, λ = 0.25`.
fn class_words(class: &Class) -> String {
    let offset = match class.rod.offset.is_zero() {
        true => String::new(),
        false => format!(", δ = {}", number(&class.rod.offset)),
    };
    format!("{}, λ = {}{offset}", class_cylinders(class), number(&class.rod.ratio))
}

/// `cylinders 1–3`.
pub(super) fn class_cylinders(class: &Class) -> String {
    let names: Vec<&str> = class.cylinders.iter().map(String::as_str).collect();
    let several = if names.len() == 1 { "" } else { "s" };
    format!("cylinder{several} {}", typeset::names(&names))
}

/// The force of an order in a few words: `0`, `= 4, planar`, or that the order does not exist.
pub fn force_summary(order: &OrderBalance) -> String {
    force_words(order, Amount::plain)
}

/// The moment of an order in a few words: `0` or `couple = √10 ≈ 3.1623, rotating`.
pub fn moment_summary(order: &OrderBalance) -> String {
    moment_words(order, Amount::plain)
}

/// The inertia torque of an order in a few words: `0` or `= 4`.
pub fn torque_summary(order: &OrderBalance, torque: &Verdict) -> String {
    if !order.torque_exists {
        DOES_NOT_EXIST.to_owned()
    } else if torque.vanishes() {
        "0".to_owned()
    } else {
        modulus(torque).plain()
    }
}

/// The same two cells as prose, with formulas.
pub(super) fn summary_prose(order: &OrderBalance) -> [String; 2] {
    [force_words(order, Amount::prose), moment_words(order, Amount::prose)]
}

/// What the summaries are counted in.
pub const LEGEND: &str = "0 is exact and proved; else the largest value ½(|P⁺| + |P⁻|): forces in m r ω² c_k, moments in that \
                          times the unit of the positions; = exact, ≈ decimal.";

/// Whose masses the verdicts are about, where the layout has others than the reciprocating ones.
pub fn whose_masses(layout: &Layout) -> Option<&'static str> {
    (order::groups_of(layout).len() > 1).then_some(
        "These are the verdicts on the reciprocating masses alone; loads, remedies and bearings reckon with all masses of the layout.",
    )
}

fn force_words(order: &OrderBalance, set: fn(&Amount) -> String) -> String {
    if order.exists { summary(&order.force, "", set) } else { DOES_NOT_EXIST.to_owned() }
}

fn moment_words(order: &OrderBalance, set: fn(&Amount) -> String) -> String {
    if order.exists { summary(&order.moment, moment_name(order), set) } else { DOES_NOT_EXIST.to_owned() }
}

fn summary(balance: &Balance, kind: &str, set: fn(&Amount) -> String) -> String {
    let space = if kind.is_empty() { "" } else { " " };
    match balance.shape {
        Shape::Balanced => "0".to_owned(),
        shape => format!("{kind}{space}{}, {}", set(&largest(balance)), shape_name(shape)),
    }
}

/// What a moment is called: a couple only where the force of its order vanishes.
pub(super) fn moment_name(order: &OrderBalance) -> &'static str {
    if order.moment_is_couple() { "couple" } else { "moment" }
}

/// A sentence on what the two vectors together trace.
pub(super) fn sentence(balance: &Balance) -> String {
    let k = balance.direct.order;
    let speed = if k == 1 { "crank speed".to_owned() } else { format!("{k} times crank speed") };
    let largest = largest(balance).prose();
    let symbol = if balance.direct.quantity == Quantity::Force { "F" } else { "C" };
    match balance.shape {
        Shape::Balanced => "Nothing is left: both vectors vanish.".to_owned(),
        Shape::Rotating => format!(
            "What is left is **rotating**: a vector of constant length {largest} that turns with the crank at {speed}. {}",
            if k == 1 { "Counterweights on the crankshaft remove it." } else { "A balancer shaft geared to that speed removes it." }
        ),
        Shape::CounterRotating => format!(
            "What is left is **counter-rotating**: a vector of constant length {largest} that turns against the crank at {speed}. \
             One balancer shaft removes it."
        ),
        Shape::Planar => format!(
            "What is left is **planar**: both vectors are equally long ($|P_{{{k}}}^{{+}}|^2 - |P_{{{k}}}^{{-}}|^2 = 0$, proved), so \
             ${symbol}_{{{k}}}$ swings along the line of angle {}; its largest value {largest}.",
            line_bearing(balance).prose()
        ),
        Shape::Elliptical => format!(
            "What is left is **elliptical**: the vectors differ in length ($|P_{{{k}}}^{{+}}|^2 - |P_{{{k}}}^{{-}}|^2 \\ne 0$, proved); the \
             largest value {largest}, along the line of angle {}.",
            line_bearing(balance).prose()
        ),
        Shape::NotDecided => "Whether the vectors are equally long is not decided.".to_owned(),
    }
    .replace("|P", "\\lvert P")
    .replace("}|^2", "}\\rvert^2")
}

/// The major axis, `(arg P⁺ + arg P⁻)/2` (theory, section 3), as a line in `(−90°, 90°]`.
pub(super) fn line_bearing(balance: &Balance) -> Bearing {
    let product = bearing(&balance.direct.sum.times(&balance.reverse.sum));
    let half = |turn: &Turn| {
        let degrees = signed_degrees(turn) / BigRational::from_integer(2.into());
        Turn::from_degrees(&degrees)
    };
    let exact = match &product.exact {
        Some(Direction::Turn(turn)) => Some(Direction::Turn(half(turn))),
        _ => None,
    };
    Bearing { exact, decimal: product.decimal / 2.0 }
}
