//! What is asked for the accuracy? The largest loads of an engine by all methods, at one rod ratio or several.

use num_rational::BigRational;

use super::super::question::{Unanswered, question};
use super::{AccuracyCase, data, page};
use crate::accuracy::{Timing, with_rod_ratio};
use crate::engine::Engine;
use crate::proof::Quantity;

/// The largest loads of an engine by all methods.
pub struct AccuracyStudy {
    /// The engine.
    pub engine: Engine,
    /// The engine as it is, or with each of the rod ratios asked for.
    pub cases: Vec<AccuracyCase>,
}

/// The loads that are compared.
const LOADS: [Quantity; 3] = [Quantity::FORCE, Quantity::MOMENT, Quantity::TORQUE];

impl AccuracyStudy {
    /// Compares the methods, at these rod ratios in place of that of the layout; calls `step` after each load, of all `steps` of them.
    ///
    /// # Errors
    /// What the layout lacks.
    pub fn new(
        engine: &Engine,
        ratios: &[BigRational],
        timing: Timing,
        step: &dyn Fn(u64),
    ) -> Result<Self, Unanswered> {
        if engine.mechanisms().is_empty() && ratios.is_empty() {
            return Err("the layout gives no rods; name some with --rod-ratio 0.3".into());
        }
        let engines = match ratios {
            [] => vec![engine.clone()],
            ratios => ratios.iter().map(|ratio| with_rod_ratio(engine, ratio)).collect::<Result<_, _>>()?,
        };
        let steps = (engines.len() * AccuracyCase::steps(&LOADS)) as u64;
        let cases = engines.iter().map(|engine| AccuracyCase::step_by_step(engine, &LOADS, timing, &|| step(steps)));
        Ok(AccuracyStudy { cases: cases.collect::<Result<_, _>>()?, engine: engine.clone() })
    }
}

question!(AccuracyStudy, "accuracy", |study| Some(study.engine.title()));
