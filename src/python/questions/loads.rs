//! `loads`: how large are the forces, moments and torques?

use pyo3::prelude::*;

use crate::engine::Engine;
use crate::page::Document;
use crate::python::answer::Question;
use crate::python::documents;
use crate::python::error::told;
use crate::report::{self, Numbers, data};
use crate::table::Table;

struct Loads {
    engine: Engine,
    numbers: Numbers,
}

/// The loads of an engine at these orders.
pub(in crate::python) fn loads(engine: &Engine, orders: &[u32]) -> PyResult<impl Question + use<>> {
    let numbers = Numbers::new(engine, orders, None).map_err(told)?;
    Ok(Loads { engine: engine.clone(), numbers })
}

impl Question for Loads {
    fn tables(&self) -> Vec<Table> {
        data::loads(&self.engine, &self.numbers, &report::loads_document(&self.engine, &self.numbers, None))
    }

    fn json(&self) -> PyResult<String> {
        documents::json(&report::loads_document(&self.engine, &self.numbers, None))
    }

    fn answer(&self) -> Document {
        report::loads_answer(&self.engine, &self.numbers, None)
    }

    fn page(&self) -> Document {
        report::loads_page(&self.engine, &self.numbers, None)
    }
}
