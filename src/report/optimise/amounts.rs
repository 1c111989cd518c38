//! How are the figures of a front written? With four digits at most, which neither solver nor machine changes.

use num_rational::BigRational;

use super::super::calculation;
use crate::engine::Engine;
use crate::loads::Arm;
use crate::numbers::float;
use crate::optimise::{Design, Front, Optimum, PlacedWeight, Residual};
use crate::page::{Piece, Text, Unit, phrase};

/// What loads and couples are counted in.
#[derive(Clone, Copy, Debug)]
pub(in crate::report) struct Units {
    pub force: Unit,
    /// Forces in a multiple of m r ω².
    pub newtons: f64,
    /// Newton-metres where positions are in metres.
    pub couple: Unit,
}

impl Units {
    /// Those of a front.
    pub fn of(layout: &Engine, front: &Front) -> Self {
        let scale = front.points.first().and_then(|point| point.design.scale.as_ref());
        let force = calculation::Unit::of_force(scale);
        let couple = match (scale, Arm::of(layout)) {
            (Some(_), Arm::Metre) => Unit::NEWTON_METRE,
            (None, Arm::Metre) => Unit::MULTIPLE_METRE,
            (_, Arm::Spacing) => Unit::MULTIPLE_SPACING,
        };
        Units { force: force.unit, newtons: force.factor, couple }
    }
}

/// Rounded to four digits.
pub(super) fn four(value: f64) -> f64 {
    format!("{value:.3e}").parse().unwrap_or(value)
}

fn quantity(value: f64, unit: Unit) -> Text {
    Piece::Quantity(four(value), unit).into()
}

/// A mass in kilograms.
pub(super) fn kilograms(mass: &BigRational) -> Text {
    quantity(float(mass), Unit::KILOGRAM)
}

/// The largest load of a design.
pub(super) fn load(design: &Design, units: Units) -> Text {
    quantity(design.peak() * units.newtons, units.force)
}

/// The bearings with the largest load, those within a thousandth of it among them.
pub(super) fn worst(design: &Design) -> Text {
    let near = |(_, peak): &(usize, &f64)| **peak >= design.peak() * (1.0 - 1e-3);
    let names = design.peaks.iter().enumerate().filter(near).map(|(index, _)| design.bearings[index].clone());
    Text::joined(names.map(Text::label), ", ")
}

/// What is left of a force or a couple: zero is proved, else the upper end of an enclosure.
pub(super) fn left(left: Residual, unit: Unit) -> Text {
    match left {
        Residual::Zero => Text::zero(),
        Residual::Between(_, high) => quantity(high, unit),
    }
}

/// Steps in which it is reported how near a design is to the least load that is possible, in percent.
const STEPS: [f64; 10] = [0.01, 0.02, 0.05, 0.1, 0.2, 0.5, 1.0, 2.0, 5.0, 10.0];

/// How near to the bound, in the steps of a ladder: `≤ 0.01 %`.
pub(super) fn within(point: &Optimum) -> Text {
    let above = (point.design.peak() - point.least) / point.design.peak().max(f64::MIN_POSITIVE) * 100.0;
    match STEPS.iter().find(|step| above <= **step) {
        Some(step) => Text::label(format!("≤ {step} %")),
        None => quantity(above, Unit::PERCENT),
    }
}

/// By how much the load of one design is smaller than that of another, in whole percent; none where it is not.
pub(super) fn less(best: &Design, other: &Design) -> Option<Text> {
    let less = 100.0 * (1.0 - best.peak() / other.peak());
    (less >= 0.5).then(|| Text::label(format!("{less:.0} %")))
}

/// A counterweight: its balance factor in percent and its skew, or the mass-radius and its direction where it belongs to no throw.
pub(super) fn weight(weight: &PlacedWeight) -> Text {
    let size = weight.mass_radius.norm();
    if size == 0.0 {
        return "none".into();
    }
    match (weight.factor, weight.skew) {
        (Some(factor), Some(skew)) => phrase!("{}, {}", quantity(factor * 100.0, Unit::PERCENT), tenths(skew)),
        (Some(_) | None, _) => {
            let angle = crate::numbers::degrees(weight.mass_radius);
            phrase!("{} at {}", quantity(size * 1000.0, Unit::KILOGRAM_MILLIMETRE), tenths(angle))
        }
    }
}

/// Degrees to a tenth, without a sign before what rounds to nothing.
fn tenths(degrees: f64) -> Text {
    let rounded = (degrees * 10.0).round() / 10.0 + 0.0;
    Text::label(format!("{rounded:.1}°").replace('-', "−"))
}
