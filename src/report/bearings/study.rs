//! What is asked for the main bearings? Both ways to share a load, and the gas where the layout asks for it.

use super::super::journal::{complete_bearings_answer, complete_bearings_page, without_gas};
use super::super::question::Question;
use super::{bearings_answer, bearings_page, data};
use crate::engine::Engine;
use crate::journal::{CycleLoads, cycle_loads};
use crate::loads::{BearingLoads, Method, Missing, bearing_loads};
use crate::page::Document;
use crate::table::Table;
use crate::text::Untrusted;

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

impl Question for BearingsStudy {
    fn command(&self) -> &'static str {
        "bearings"
    }

    fn title(&self) -> Option<&Untrusted> {
        Some(self.engine.title())
    }

    fn table(&self, name: &str) -> Option<Table> {
        data::table(self, name)
    }

    fn answer(&self) -> Document {
        let answer = || bearings_answer(&self.engine, &self.continuous, &self.determinate);
        match &self.complete {
            None => answer(),
            Some(Err(lack)) => without_gas(answer(), lack),
            Some(Ok(loads)) => complete_bearings_answer(&self.engine, loads),
        }
    }

    fn page(&self) -> Document {
        let page = || bearings_page(&self.engine, &self.continuous, &self.determinate);
        match &self.complete {
            None => page(),
            Some(Err(lack)) => without_gas(page(), lack),
            Some(Ok(loads)) => complete_bearings_page(&self.engine, loads, &self.continuous),
        }
    }
}
