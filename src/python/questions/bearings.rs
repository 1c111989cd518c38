//! `bearings`: what do the main bearings feel?

use pyo3::prelude::*;

use crate::engine::Engine;
use crate::journal::{CycleLoads, NoCycleLoads, cycle_loads};
use crate::loads::{BearingLoads, Method, bearing_loads};
use crate::page::Document;
use crate::python::answer::Question;
use crate::python::documents;
use crate::python::error::told;
use crate::report::{self, BearingsDocument, data};
use crate::table::Table;

struct Bearings {
    engine: Engine,
    continuous: BearingLoads,
    determinate: BearingLoads,
    complete: Option<Result<CycleLoads, NoCycleLoads>>,
}

/// What the main bearings feel at these orders, with the gas where the layout asks for it.
pub(in crate::python) fn bearings(engine: &Engine, orders: &[u32]) -> PyResult<impl Question + use<>> {
    let solve = |method| bearing_loads(engine, orders, method).map_err(told);
    let (continuous, determinate) = (solve(Method::Continuous)?, solve(Method::Determinate)?);
    let complete = engine.effects().gas.then(|| cycle_loads(engine));
    Ok(Bearings { engine: engine.clone(), continuous, determinate, complete })
}

impl Bearings {
    fn document(&self) -> BearingsDocument {
        let document = report::bearings_document(&self.engine, &self.continuous, &self.determinate);
        match &self.complete {
            Some(Ok(loads)) => document.with_gas(report::CycleLoadsDocument::new(&self.engine, loads)),
            Some(Err(_)) | None => document,
        }
    }
}

impl Question for Bearings {
    fn tables(&self) -> Vec<Table> {
        let complete = self.complete.as_ref().and_then(|loads| loads.as_ref().ok());
        data::bearings(&self.engine, [&self.continuous, &self.determinate], &self.document(), complete)
    }

    fn json(&self) -> PyResult<String> {
        documents::json(&self.document())
    }

    fn answer(&self) -> Document {
        let answer = || report::bearings_answer(&self.engine, &self.continuous, &self.determinate);
        match &self.complete {
            None => answer(),
            Some(Err(lack)) => report::without_gas(answer(), lack),
            Some(Ok(loads)) => report::complete_bearings_answer(&self.engine, loads),
        }
    }

    fn page(&self) -> Document {
        let page = || report::bearings_page(&self.engine, &self.continuous, &self.determinate);
        match &self.complete {
            None => page(),
            Some(Err(lack)) => report::without_gas(page(), lack),
            Some(Ok(loads)) => report::complete_bearings_page(&self.engine, loads, &self.continuous),
        }
    }
}
