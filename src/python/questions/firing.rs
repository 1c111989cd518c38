//! `firing`: which orders of the gas torque vanish, whatever the pressure is?

use pyo3::prelude::*;

use crate::engine::{CycleOrder, Engine};
use crate::firing::{NoStar, Weights};
use crate::page::Document;
use crate::python::answer::{Answer, Question};
use crate::python::documents;
use crate::python::error::told;
use crate::report::{self, FiringStudy};
use crate::table::Table;

struct Fired {
    json: String,
    answer: Document,
    page: Document,
}

/// Judges the firing stars of these orders, weighed by a mode shape where one is given.
pub(in crate::python) fn firing(engine: &Engine, orders: &[CycleOrder], weights: Weights) -> PyResult<Answer> {
    let study = FiringStudy::new(engine, orders, weights).map_err(|lack: NoStar| told(lack))?;
    Ok(Answer::new(Fired {
        json: documents::json(&report::firing_document(&study, false))?,
        answer: report::firing_answer(&study),
        page: report::firing_page(&study),
    }))
}

impl Question for Fired {
    fn command(&self) -> &'static str {
        "firing"
    }

    fn tables(&self) -> Vec<Table> {
        Vec::new()
    }

    fn json(&self) -> PyResult<String> {
        Ok(self.json.clone())
    }

    fn answer(&self) -> Document {
        self.answer.clone()
    }

    fn page(&self) -> Document {
        self.page.clone()
    }
}
