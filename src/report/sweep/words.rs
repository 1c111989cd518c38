//! How are the numbers of a sweep written, and what are its amplitudes called?

pub(super) use super::super::data::exact_number as exact;
use crate::loads::Arm;
use crate::proof::Planar;
use crate::sweep::{Amplitudes, Parameter, Sweep, SweptOrder, Zeros};

/// `bank angle in °`.
pub(super) fn axis(parameter: &Parameter, is_angle: bool) -> String {
    match parameter.range.unit() {
        "" | "°" | "deg" if is_angle => format!("{} in °", parameter.label),
        "" => parameter.label.clone(),
        unit => format!("{} in {unit}", parameter.label),
    }
}

/// Force and moment of an order.
pub(super) fn quantities(order: &SweptOrder) -> [(Planar, &Amplitudes); 2] {
    [(Planar::Force, &order.force), (Planar::Moment, &order.moment)]
}

/// What an amplitude is a multiple of.
pub(super) fn unit(sweep: &Sweep, quantity: Planar) -> String {
    let coefficient = if sweep.rods_known { "" } else { " c_k" };
    let arm = match (quantity, sweep.arm) {
        (Planar::Moment, Arm::Spacing) => " a",
        (Planar::Moment, Arm::Metre) => " · m",
        _ => "",
    };
    format!("m r ω²{coefficient}{arm}")
}

/// What vanishes, in words.
pub(super) fn zeros_name(of: Zeros) -> &'static str {
    match of {
        Zeros::Direct => "direct",
        Zeros::Reverse => "reverse",
        Zeros::Largest => "all",
        Zeros::Along => "along",
        Zeros::Across => "across",
    }
}
