//! What is looked at? An engine at one rod ratio, with its loads by all methods.

use num_rational::BigRational;

use super::further::{Further, FurtherLoad};
use crate::accuracy::{self, Study};
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
    /// The largest loads of bearings, and what is largest with gas, where the layout asks for them.
    pub further: Vec<Further>,
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
        quantities.len() + FurtherLoad::ALL.len()
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
        let studies = quantities.iter().map(|quantity| step(done, accuracy::study(engine, *quantity, timing)));
        let mut rods = engine.rods().map(|rod| &rod.ratio);
        let first = rods.next().cloned();
        let ratio = first.filter(|first| rods.all(|ratio| ratio == first));
        let studies = studies.collect::<Result<_, _>>()?;
        let further = FurtherLoad::ALL.map(|load| step(done, Further::new(engine, load, timing)));
        let further = further.into_iter().filter_map(Result::transpose).collect::<Result<_, _>>()?;
        Ok(AccuracyCase { ratio, studies, further })
    }

    /// `λ = 0.3`.
    pub(super) fn label(&self) -> Text {
        match self.ratio.as_ref().map(Number::exact) {
            None => "different λ".into(),
            Some(Number::Decimal(decimal)) => phrase!("λ {}", Number::Decimal(decimal)),
            Some(Number::Zero) => "λ = 0".into(),
            Some(number @ (Number::Exact(_) | Number::Closed(..))) => phrase!("λ = {}", number),
        }
    }
}

/// Tells that one thing was found.
fn step<T>(done: &dyn Fn(), found: T) -> T {
    done();
    found
}
