//! `search`: which crank stars balance best?

use std::ops::ControlFlow;
use std::path::PathBuf;
use std::sync::atomic::{AtomicBool, Ordering};

use num_rational::BigRational;
use pyo3::prelude::*;

use crate::page::Document;
use crate::python::error::told;
use crate::report::data;
use crate::report::{self, Question};
use crate::search::{self, Front, Options, Problem, Torsion};
use crate::table::Table;
use crate::text::Untrusted;

struct Searched {
    front: Front,
    torsion: Option<Torsion>,
}

/// Searches until the flag stops it.
pub(in crate::python) fn search(
    problem: &Problem,
    torsion: Option<Option<Vec<BigRational>>>,
    resume: Option<PathBuf>,
    threads: Option<u16>,
    stop: &AtomicBool,
) -> PyResult<impl Question + use<>> {
    if let Some(shape) = &torsion {
        search::mode_shape(problem, shape.clone()).map_err(told)?;
    }
    let progress = |_| match stop.load(Ordering::Relaxed) {
        false => ControlFlow::Continue(()),
        true => ControlFlow::Break(()),
    };
    let threads = threads.map_or(Options::default().threads, usize::from);
    let options = Options { threads, resume, progress: &progress, stop: Some(stop), ..Options::default() };
    let front = search::search(problem, &options).map_err(told)?;
    let torsion = torsion.map(|shape| search::torsion(&front, shape)).transpose().map_err(told)?;
    Ok(Searched { front, torsion })
}

impl Searched {
    fn with_torsion(&self, mut page: Document) -> Document {
        page.blocks.extend(self.torsion.iter().flat_map(|torsion| report::search_torsion(&self.front, torsion)));
        page
    }
}

impl Question for Searched {
    fn command(&self) -> &'static str {
        "search"
    }

    fn title(&self) -> Option<&Untrusted> {
        None
    }

    fn table(&self, name: &str) -> Option<Table> {
        self.tables().into_iter().find(|table| table.name() == name)
    }

    fn tables(&self) -> Vec<Table> {
        data::search(&self.front, self.torsion.as_ref())
    }

    fn json(&self) -> serde_json::Result<String> {
        let document = search::document(&self.front);
        serde_json::to_string_pretty(&match &self.torsion {
            Some(torsion) => document.with_torsion(torsion),
            None => document,
        })
    }

    fn answer(&self) -> Document {
        self.with_torsion(report::search_answer(&self.front))
    }

    fn page(&self) -> Document {
        self.with_torsion(report::search_page(&self.front))
    }
}
