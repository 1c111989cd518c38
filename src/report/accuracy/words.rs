//! What is said of a load? Its name, its peak, which orders are enough, how the methods work.

use num_traits::{ToPrimitive, Zero};

use super::AccuracyCase;
use super::methods;
use crate::accuracy::Study;
use crate::engine::Engine;
use crate::page::{Piece, Text, phrase};
use crate::proof::Quantity;
use crate::report::texts::accuracy as text;

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
        return Some(text::vanishing(study.quantity));
    }
    let bound = study.peak.high.to_f64().unwrap_or(f64::INFINITY);
    Some(text::below(study.quantity, methods::power(bound), multiple(study.quantity)))
}

/// The digits of a peak that are sure, or the number that it is nearest to.
pub(super) fn sure_digits(study: &Study) -> Option<Text> {
    if study.rows.is_empty() {
        return None;
    }
    let (digits, multiple) = (methods::sure_digits(study), multiple(study.quantity));
    let is_cut =
        digits.as_deref().and_then(|digits| digits.split_once('.')).is_some_and(|(_, cut)| cut.len() == methods::CUT);
    match methods::rounded(study).filter(|_| !is_cut) {
        Some((number, power)) => Some(text::near(methods::power_of_ten(power), number, multiple)),
        None => Some(phrase!("Certain digits in multiples of {}: {}…", multiple, digits?)),
    }
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
        Some(order) => text::enough(order),
        None => text::none_enough(),
    };
    let fastest = methods::fastest_within_a_thousandth(study)
        .map(|(row, time)| text::fastest(methods::time(time), methods::name(row.method)));
    Text::joined([peak, orders].into_iter().chain(fastest), " ")
}
