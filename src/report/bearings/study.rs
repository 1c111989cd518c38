//! What is asked for the main bearings? Both ways to share a load, and the gas where the layout asks for it.

use crate::engine::Engine;
use crate::journal::{CycleLoads, cycle_loads};
use crate::loads::{BearingLoads, Method, Missing, bearing_loads};

/// What the main bearings of an engine feel.
#[derive(Clone, Debug)]
pub struct BearingsStudy {
    /// The engine.
    pub engine: Engine,
    /// On one continuous beam.
    pub continuous: BearingLoads,
    /// Each span a beam of its own.
    pub determinate: BearingLoads,
    /// Gas and masses together, where the layout asks for the gas, or what it lacks.
    pub complete: Option<Result<CycleLoads, Missing>>,
}

impl BearingsStudy {
    /// The loads at these orders.
    ///
    /// # Errors
    /// What the layout lacks.
    pub fn new(engine: &Engine, orders: &[u32]) -> Result<Self, Missing> {
        let solve = |method| bearing_loads(engine, orders, method);
        let (continuous, determinate) = (solve(Method::Continuous)?, solve(Method::Determinate)?);
        // What nobody asks for costs nothing.
        let complete = engine.effects().gas.then(|| cycle_loads(engine));
        Ok(BearingsStudy { engine: engine.clone(), continuous, determinate, complete })
    }

    /// Gas and masses together, where there are both.
    pub fn with_gas(&self) -> Option<&CycleLoads> {
        self.complete.as_ref().and_then(|complete| complete.as_ref().ok())
    }
}
