//! What does the layout give of a cylinder?

use num_traits::ToPrimitive;

use crate::engine::{Engine, Given, Measure};

/// What is given of a cylinder, or of all.
pub(super) fn of_measure(engine: &Engine, index: usize, measure: Measure) -> Option<f64> {
    let of = |given: &&Given| given.quantity == measure && given.cylinder.is_none_or(|of| of == index);
    engine.dimensions().given.iter().find(of).and_then(|given| given.value.to_f64())
}

/// The crank radius of a cylinder, given itself or by its stroke.
pub(super) fn crank_radius(engine: &Engine, index: usize) -> Option<f64> {
    let half_stroke = || Some(of_measure(engine, index, Measure::Stroke)? / 2.0);
    of_measure(engine, index, Measure::CrankRadius).or_else(half_stroke)
}
