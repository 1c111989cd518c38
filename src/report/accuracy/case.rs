//! What is looked at? An engine at one rod ratio, with its loads by all methods.

use num_rational::BigRational;

use super::engine_torque::{self, PeakRow};
use super::gas_bearings;
use crate::accuracy::{self, BearingRow, Study};
use crate::engine::Engine;
use crate::loads;
use crate::page::{Number, Text, phrase};
use crate::proof::Quantity;

/// An engine at one rod ratio, with its loads by all methods.
#[derive(Clone, Debug)]
pub struct AccuracyCase {
    /// The rod ratio λ; none where the rods differ.
    pub ratio: Option<BigRational>,
    /// Its loads.
    pub studies: Vec<Study>,
    /// The largest bearing load of inertia by several methods; none without main bearings.
    pub bearings: Option<Vec<BearingRow>>,
    /// The largest torque of gas and inertia by several methods; none without gas.
    pub(super) engine_torque: Option<Vec<PeakRow>>,
    /// The largest bearing load of gas and masses by several methods; none where the layout does not ask for the gas.
    pub(super) gas_bearings: Option<Vec<PeakRow>>,
}

impl AccuracyCase {
    /// The loads of a layout by all methods: force, moment, torque.
    ///
    /// # Errors
    /// What the layout lacks for numbers.
    pub fn of(engine: &Engine, quantities: &[Quantity], timing: accuracy::Timing) -> Result<Self, loads::Missing> {
        Self::step_by_step(engine, quantities, timing, &|| ())
    }

    /// How many steps [`Self::step_by_step`] tells of.
    pub fn steps(quantities: &[Quantity]) -> usize {
        quantities.len() + FURTHER
    }

    /// The same, with a call after each load, then after the bearings, the torque with gas and the bearings with gas.
    ///
    /// # Errors
    /// What the layout lacks for numbers.
    pub fn step_by_step(
        engine: &Engine,
        quantities: &[Quantity],
        timing: accuracy::Timing,
        done: &dyn Fn(),
    ) -> Result<Self, loads::Missing> {
        let told = |found| {
            done();
            found
        };
        let studies = quantities.iter().map(|quantity| told(accuracy::study(engine, *quantity, timing)));
        let mut rods = engine.rods().map(|rod| &rod.ratio);
        let first = rods.next().cloned();
        let ratio = first.filter(|first| rods.all(|ratio| ratio == first));
        let studies = studies.collect::<Result<_, _>>()?;
        let bearings = accuracy::bearings(engine, timing)?;
        done();
        let engine_torque = engine_torque::rows(engine, timing);
        done();
        let gas_bearings = gas_bearings::rows(engine, timing);
        done();
        Ok(AccuracyCase { ratio, studies, bearings, engine_torque, gas_bearings })
    }

    /// `λ = 0.3`.
    pub(super) fn label(&self) -> Text {
        match self.ratio.as_ref().map(Number::exact) {
            None => "each its own λ".into(),
            Some(Number::Decimal(decimal)) => phrase!("λ {}", Number::Decimal(decimal)),
            Some(Number::Zero) => "λ = 0".into(),
            Some(number @ (Number::Exact(_) | Number::Closed(..))) => phrase!("λ = {}", number),
        }
    }
}

/// Steps after the loads themselves.
const FURTHER: usize = 3;

/// As many loads as every case has.
pub(super) fn loads_of(cases: &[AccuracyCase]) -> usize {
    cases.iter().map(|case| case.studies.len()).min().unwrap_or(0)
}
