//! What is asked for the loads? Forces, moments and torques of an engine at some orders.

use super::super::engine_page::Weighing;
use super::super::loads_document::{LoadsDocument, loads_document};
use super::super::question::{json_with_evidence, one_of_all, question};
use super::data;
use super::{Numbers, loads_answer, loads_page};
use crate::engine::Engine;
use crate::loads::{Missing, Needed};
use crate::table::Table;

/// The loads of an engine.
pub struct LoadsStudy {
    /// The engine.
    pub engine: Engine,
    /// Its loads.
    pub numbers: Numbers,
    /// The orders that an accuracy needs, where it was asked for.
    pub needed: Option<Needed>,
    /// Which orders have a row of their own in the short answer; all where this is not given.
    pub weighing: Option<Weighing>,
}

impl LoadsStudy {
    /// The loads at these orders, or at those that an accuracy needs.
    ///
    /// # Errors
    /// What the layout lacks.
    pub fn new(engine: &Engine, orders: &[u32], needed: Option<Needed>) -> Result<Self, Missing> {
        let numbers = Numbers::new(engine, orders, needed.as_ref())?;
        Ok(LoadsStudy { engine: engine.clone(), numbers, needed, weighing: None })
    }

    fn document(&self) -> LoadsDocument {
        loads_document(&self.engine, &self.numbers, self.needed.as_ref())
    }
}

question!(
    LoadsStudy,
    "loads",
    |study| Some(study.engine.title()),
    one_of_all,
    |study| loads_answer(&study.engine, &study.numbers, study.needed.as_ref(), study.weighing.as_ref()),
    |study| loads_page(&study.engine, &study.numbers, study.needed.as_ref()),
    {
        fn tables(&self) -> Vec<Table> {
            data::tables(&self.engine, &self.numbers, &self.document())
        }

        json_with_evidence!();
    }
);
