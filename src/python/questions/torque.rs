//! `torque`: which torque does the engine give, and which flywheel does it need?

use pyo3::prelude::*;

use crate::engine::Engine;
use crate::page::Document;
use crate::python::answer::{Answer, Question};
use crate::python::documents;
use crate::python::error::told;
use crate::report;
use crate::table::Table;
use crate::torque::{self, EngineTorque};

struct Torque {
    engine: Engine,
    torque: EngineTorque,
}

/// The torque of gas and inertia.
pub(in crate::python) fn torque(engine: &Engine) -> PyResult<Answer> {
    let torque = torque::torque(engine).map_err(told)?;
    Ok(Answer::new(Torque { engine: engine.clone(), torque }))
}

impl Question for Torque {
    fn command(&self) -> &'static str {
        "torque"
    }

    fn tables(&self) -> Vec<Table> {
        Vec::new()
    }

    fn json(&self) -> PyResult<String> {
        documents::json(&report::torque_document(&self.engine, &self.torque))
    }

    fn answer(&self) -> Document {
        report::torque_answer(&self.engine, &self.torque)
    }

    fn page(&self) -> Document {
        report::torque_page(&self.engine, &self.torque)
    }
}
