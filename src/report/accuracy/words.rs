//! What is said of a load? Its name, its peak, which orders are enough, how the methods work.

use num_traits::{ToPrimitive, Zero};

use super::AccuracyCase;
use super::methods;
use crate::accuracy::Study;
use crate::engine::Engine;
use crate::page::{Piece, Text, phrase};
use crate::proof::Quantity;

/// How the methods work, and what the columns mean.
pub(super) const METHODS: [&str; 5] = [
    "Each method computes the same peak; errors are parts of it.",
    "**Orders** are summed in doubles; an order that adds nothing is skipped. What the higher orders can add is bounded by their exact sums and, above order 60, by the sum of all coefficients; that bound excludes roundings.",
    "The **closed form** is the acceleration of each piston without any series, at equal steps of the crank angle, in floats of 64 bits.",
    "**Intervals** enclose load and slope over spans of the crank angle and cut the highest span in two, until the digits asked for are certain; they stop at 4000 spans, and their bound then shows the accuracy reached.",
    "**Intervals of fractions** carry some fifty digits, fewer where the load is nearly constant. Narrowed by all other guaranteed bounds, they are the reference of the others; an error that is smaller than their own is said to be below it.",
];

pub(super) const TIMES: &str = "A time is the median of seven evaluations of the peak on the machine that wrote this page, with all data of the engine precomputed; methods slower than 20 ms are timed once.";

/// The heading of a load.
pub(super) fn heading(case: &AccuracyCase, study: &Study) -> Text {
    match study.quantity {
        Quantity::FORCE => phrase!("Peak force, {}", case.label()),
        Quantity::MOMENT => phrase!("Peak moment, {}", case.label()),
        Quantity::Axial(_) => phrase!("Peak inertia torque, {}", case.label()),
    }
}

/// The name of a load in tables.
pub(super) fn name(quantity: Quantity) -> &'static str {
    match quantity {
        Quantity::FORCE => "force",
        Quantity::MOMENT => "moment",
        Quantity::Axial(_) => "inertia_torque",
    }
}

/// What multiples of a load are multiples of.
fn multiple(quantity: Quantity) -> &'static str {
    match quantity {
        Quantity::FORCE => "m r ω²",
        Quantity::MOMENT => "m r ω² times the unit of the positions",
        Quantity::Axial(_) => "m r² ω²",
    }
}

/// That there is no peak, where there is none.
pub(super) fn vanishing(study: &Study) -> Option<Text> {
    if !study.rows.is_empty() {
        return None;
    }
    if study.peak.high.is_zero() {
        return Some(phrase!(
            "The {force|moment|inertia torque} vanishes at every order, proved: there is no peak to compare.",
            study.quantity
        ));
    }
    let bound = study.peak.high.to_f64().unwrap_or(f64::INFINITY);
    Some(phrase!(
        "The {force|moment|inertia torque} vanishes at every order examined, and the others add less than {} {}: there is no peak to compare.",
        study.quantity,
        methods::power(bound),
        multiple(study.quantity)
    ))
}

/// The digits of a peak that are sure.
pub(super) fn sure_digits(study: &Study) -> Option<Text> {
    let digits = methods::sure_digits(study).filter(|_| !study.rows.is_empty())?;
    Some(phrase!("Certain digits in multiples of {}: {}…", multiple(study.quantity), digits))
}

/// What a designer wants to know of a load: its peak, the orders that are enough, the fastest method.
pub(super) fn answer(engine: &Engine, case: &AccuracyCase, study: &Study) -> Text {
    if let Some(nothing) = vanishing(study) {
        return phrase!("{}. {}", heading(case, study), nothing);
    }
    let (unit, factor) = methods::unit(engine, study.quantity);
    let peak = Piece::Quantity(study.peak.to_float() * factor, unit);
    let peak = phrase!("{}: {}.", heading(case, study), peak);
    let orders = match methods::orders_for_a_thousandth(study) {
        Some(order) => phrase!("Orders up to {} give it within 0.1 %, guaranteed.", order),
        None => "The orders compared here do not give it within 0.1 %.".into(),
    };
    let fastest = methods::fastest_within_a_thousandth(study).map(|(row, time)| {
        phrase!("The fastest method within 0.1 % takes {}: {}.", methods::time(time), methods::name(row.method))
    });
    Text::joined([peak, orders].into_iter().chain(fastest), " ")
}
