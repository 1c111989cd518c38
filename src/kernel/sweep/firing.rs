//! How long is the firing star of each order at each point of a sweep, and at which exact angles does it vanish?
//!
//! Whole orders need the top dead centres alone. Half orders need to know when the cylinders fire: where the throws cannot fire in the
//! order of the file there is no star.

use std::collections::BTreeSet;

use num_rational::BigRational;
use num_traits::{Signed, ToPrimitive};

use super::SweepError;
use super::amplitude::{Amplitude, float};
use super::opened::{OpenAngle, opened_with_firing};
use super::parameter::Parameter;
use crate::engine::{CycleOrder, Engine, NoSpans};
use crate::exact::PhasorSum;
use crate::family::{self, OpenStar, Solutions};
use crate::file::Template;
use crate::firing::{self, NoStar, Weights};
use crate::numbers;

/// The length of a firing star in crank radii.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum StarLength {
    /// There is none: the cylinders cannot fire so.
    NotFired,
    /// Of such an engine it is not decided.
    NotDecided,
    /// Stars of several rods, not all of them zero: they have no common length, and the order does not vanish for every pressure law.
    OfSeveralRods,
    /// It is so long.
    Of(Amplitude),
}

impl StarLength {
    /// The length; none where there is none.
    pub fn amplitude(self) -> Option<Amplitude> {
        match self {
            StarLength::NotFired | StarLength::NotDecided | StarLength::OfSeveralRods => None,
            StarLength::Of(amplitude) => Some(amplitude),
        }
    }

    /// Whether it is zero, proved; none where that is not decided, or the cylinders cannot fire so.
    pub fn vanishes(self) -> Option<bool> {
        match self {
            StarLength::NotFired | StarLength::NotDecided => None,
            StarLength::OfSeveralRods => Some(false),
            StarLength::Of(amplitude) => Some(amplitude.vanishes),
        }
    }
}

/// The firing stars of a sweep.
#[derive(Clone, Debug)]
pub struct FiringSweep {
    /// The orders κ, rising.
    pub orders: Vec<CycleOrder>,
    /// The stars of these orders at each point of the sweep.
    pub points: Vec<Vec<StarLength>>,
    /// For one parameter: the same at each point from which curves are drawn, and at the exact zeros.
    pub curve: Vec<(BigRational, Vec<StarLength>)>,
    /// For one angle: where each star vanishes; none for other parameters.
    pub zeros: Option<Vec<FiringZeros>>,
}

/// Where the firing star of one order vanishes.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct FiringZeros {
    /// The order κ.
    pub order: CycleOrder,
    /// Whether the cylinders can fire in the order of the file somewhere in the range; at whole orders that does not matter.
    pub fires: bool,
    /// Whether it vanishes wherever they fire.
    pub everywhere: bool,
    /// The values in the range at which it vanishes, rising, in the unit of the range; empty where it does everywhere.
    pub at: Vec<BigRational>,
    /// Ends, narrow ones, between which it vanishes once each, at an angle that is no rational turn.
    pub irrational: Vec<[BigRational; 2]>,
    /// Whether these are proved to be all; else they are those found.
    pub complete: bool,
}

/// Whether these are orders of which the file tells enough.
pub(super) fn can_be_judged(template: &Template, orders: &[CycleOrder]) -> Result<(), SweepError> {
    let cycle = template.cycle();
    let known = cycle.map_or(Ok(()), |cycle| firing::are_orders_of(cycle, orders));
    known.map_err(|why| SweepError::new(why.to_string()))?;
    let has_half = orders.iter().any(|order| !order.is_whole());
    if has_half && !template.has("firing_order") && !template.has("firing_angles") {
        return Err(SweepError::new(NoSpans::NotSaid.to_string()));
    }
    Ok(())
}

/// The stars of these orders at one point.
pub(super) fn lengths(engine: &Engine, orders: &[CycleOrder]) -> Vec<StarLength> {
    orders.iter().map(|order| length(engine, *order)).collect()
}

fn length(engine: &Engine, order: CycleOrder) -> StarLength {
    match firing::star_sums(engine, order).as_deref() {
        Err(NoStar::NoFiring) => StarLength::NotFired,
        Err(_) => StarLength::NotDecided,
        Ok([only]) => StarLength::Of(amplitude(only)),
        Ok(several) => match several.iter().all(PhasorSum::vanishes) {
            true => StarLength::Of(Amplitude::ZERO),
            false => StarLength::OfSeveralRods,
        },
    }
}

fn amplitude(sum: &PhasorSum) -> Amplitude {
    let weights = sum.terms().iter().map(|term| term.weight.abs().to_f64().unwrap_or(f64::INFINITY));
    let (value, total) = (float(sum).norm(), weights.sum::<f64>());
    if value <= total * numbers::ALIKE && sum.vanishes() { Amplitude::ZERO } else { Amplitude::decided(value) }
}

/// Where the stars vanish; `None` where the parameter is no angle, or the rods differ.
pub(super) fn found(template: &Template, parameter: &Parameter, orders: &[CycleOrder]) -> Option<Vec<FiringZeros>> {
    let OpenAngle { family: open, unknown, per_unit } = opened_with_firing(template, parameter)?;
    let ends = [parameter.range.value(0), parameter.range.last()].map(|end| end * &per_unit);
    let range = [ends.iter().min()?, ends.iter().max()?];
    let stars = family::firing_stars(&open, orders, &Weights::Rigid, range, true).ok()?;
    let zeros = |star: &OpenStar| {
        let none = FiringZeros {
            order: star.order,
            fires: true,
            everywhere: false,
            at: Vec::new(),
            irrational: Vec::new(),
            complete: true,
        };
        let in_units = |values: Vec<BigRational>| values.into_iter().map(|value| value / &per_unit).collect();
        let spans = match &star.spans {
            Err(_) => return FiringZeros { complete: false, ..none },
            Ok(spans) if spans.is_empty() => return FiringZeros { fires: false, ..none },
            Ok(spans) => spans,
        };
        if star.always() {
            return FiringZeros { everywhere: true, ..none };
        }
        let known: Vec<Solutions> = spans.iter().filter_map(|span| span.solutions(unknown, range)).collect();
        let complete = known.len() == spans.len() && known.iter().all(|found| found.open.is_empty());
        let at: BTreeSet<BigRational> = known.iter().flat_map(|found| found.exact.iter().cloned()).collect();
        let at = in_units(at.into_iter().collect());
        let irrational = known.iter().flat_map(|found| &found.irrational);
        let irrational = irrational.map(|ends| ends.each_ref().map(|end| end / &per_unit)).collect();
        FiringZeros { at, irrational, complete, ..none }
    };
    Some(stars.iter().map(zeros).collect())
}
