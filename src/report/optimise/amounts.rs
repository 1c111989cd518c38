//! How are the figures of a front written? With four digits, which neither solver nor machine changes.

use num_rational::BigRational;
use num_traits::ToPrimitive;

use super::super::typeset;
use crate::loads::Scale;
use crate::optimise::{Design, Optimum, Residual};

/// What loads and couples are counted in.
#[derive(Clone, Copy, Debug)]
pub(super) struct Units {
    pub force: &'static str,
    /// Forces in a multiple of m r ω².
    pub newtons: f64,
    pub couple: &'static str,
}

impl Units {
    /// Those of a front; its couples are in newton-metres where positions are in metres.
    pub fn of(scale: Option<&Scale>, metres: bool) -> Self {
        let couple = match (scale.is_some(), metres) {
            (true, true) => "N·m",
            _ => "m r ω² times the unit of the positions",
        };
        let (force, newtons) = scale.map_or(("m r ω²", 1.0), |scale| ("N", scale.force()));
        Units { force, newtons, couple }
    }
}

/// Four digits; whole numbers above.
pub(super) fn four(value: f64) -> String {
    if value == 0.0 || !value.is_finite() {
        return "0".to_owned();
    }
    let written = format!("{value:.3e}");
    let exponent = written.split_once('e').and_then(|(_, power)| power.parse::<i32>().ok()).unwrap_or(0);
    let rounded: f64 = written.parse().unwrap_or(value);
    match exponent {
        -4..=8 => format!("{rounded:.*}", (3 - exponent).max(0) as usize).replace('-', "−"),
        _ => written.replace('-', "−"),
    }
}

/// A mass in kilograms.
pub(super) fn kilograms(mass: &BigRational) -> String {
    format!("≈ {}", four(mass.to_f64().unwrap_or(f64::NAN)))
}

/// The largest load of a design.
pub(super) fn load(design: &Design, units: Units) -> String {
    format!("≈ {}", four(design.peak() * units.newtons))
}

/// The bearings with the largest load, those within a thousandth of it among them.
pub(super) fn worst(design: &Design) -> String {
    let near = |(_, peak): &(usize, &f64)| **peak >= design.peak() * (1.0 - 1e-3);
    let numbers = design.peaks.iter().enumerate().filter(near).map(|(index, _)| (index + 1).to_string());
    numbers.collect::<Vec<_>>().join(", ")
}

/// What is left of a couple: 0 is proved.
pub(super) fn left(left: Residual) -> String {
    match left {
        Residual::Zero => "0".to_owned(),
        Residual::Between(_, high) => format!("≈ {}", four(high)),
    }
}

/// Steps in which it is told how near a design is to the least load that is possible, in percent.
const STEPS: [f64; 10] = [0.01, 0.02, 0.05, 0.1, 0.2, 0.5, 1.0, 2.0, 5.0, 10.0];

/// How near to the bound, in the steps of a ladder: `0.01 %`.
pub(super) fn within(point: &Optimum) -> String {
    let above = (point.design.peak() - point.least) / point.design.peak().max(f64::MIN_POSITIVE) * 100.0;
    match STEPS.iter().find(|step| above <= **step) {
        Some(step) => format!("{step} %"),
        None => format!("{} %", four(above)),
    }
}

/// A balance factor, exact.
pub(super) fn factor(value: &BigRational) -> String {
    typeset::number(value)
}
