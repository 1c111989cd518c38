//! How are the numbers of a sweep written, and what are its amplitudes called?

use num_bigint::BigInt;
use num_integer::Integer;
use num_rational::BigRational;
use num_traits::{One, Zero};

use crate::loads::Arm;
use crate::proof::Quantity;
use crate::sweep::{Amplitude, Amplitudes, Parameter, Sweep, SweptOrder, Zeros};

/// Digits of an amplitude.
const DIGITS: usize = 10;

/// A decimal of ten digits without zeros that say nothing.
pub(super) fn digits(value: f64) -> String {
    let rounded: f64 = format!("{value:.*e}", DIGITS - 1).parse().unwrap_or(value);
    match rounded.abs() {
        size if size != 0.0 && !(1e-5..1e15).contains(&size) => format!("{rounded:e}"),
        _ => rounded.to_string(),
    }
}

/// An amplitude: 0 is proved.
pub(super) fn amount(part: Amplitude) -> String {
    if part.vanishes { "0".to_owned() } else { digits(part.value) }
}

/// A rational number: a decimal where it ends, else a fraction.
pub(super) fn exact(value: &BigRational) -> String {
    let mut rest = value.denom().clone();
    let mut places = 0_u32;
    let ten = BigInt::from(10);
    while !rest.is_one() {
        let common = rest.gcd(&ten);
        if common.is_one() || places > 12 {
            return value.to_string();
        }
        rest /= common;
        places += 1;
    }
    let scaled = (value * BigRational::from_integer(ten.pow(places))).to_integer();
    let (sign, size) = if scaled < BigInt::zero() { ("-", -scaled) } else { ("", scaled) };
    let text = format!("{size:0>width$}", width = places as usize + 1);
    match text.split_at(text.len() - places as usize) {
        (whole, "") => format!("{sign}{whole}"),
        (whole, part) => format!("{sign}{whole}.{part}"),
    }
}

/// `bank angle in °`.
pub(super) fn axis(parameter: &Parameter, is_angle: bool) -> String {
    match parameter.range.unit() {
        "" | "°" | "deg" if is_angle => format!("{} in °", parameter.label),
        "" => parameter.label.clone(),
        unit => format!("{} in {unit}", parameter.label),
    }
}

/// The amplitudes of an order by name, as columns and curves have them.
pub(super) fn named(amplitudes: &Amplitudes) -> [(&'static str, Amplitude); 6] {
    [
        ("largest", amplitudes.largest),
        ("smallest", amplitudes.smallest),
        ("along", amplitudes.along),
        ("across", amplitudes.across),
        ("direct", amplitudes.direct),
        ("reverse", amplitudes.reverse),
    ]
}

/// Force and moment of an order.
pub(super) fn quantities(order: &SweptOrder) -> [(Quantity, &Amplitudes); 2] {
    [(Quantity::Force, &order.force), (Quantity::Moment, &order.moment)]
}

pub(super) fn quantity_name(quantity: Quantity) -> &'static str {
    match quantity {
        Quantity::Force => "force",
        Quantity::Moment => "moment",
        Quantity::Torque | Quantity::Roll => "torque",
    }
}

/// What an amplitude is a multiple of.
pub(super) fn unit(sweep: &Sweep, quantity: Quantity) -> String {
    let coefficient = if sweep.rods_known { "" } else { " c_k" };
    let arm = match (quantity, sweep.arm) {
        (Quantity::Moment, Arm::Spacing) => " a",
        (Quantity::Moment, Arm::Metre) => " · m",
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
