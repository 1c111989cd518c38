//! `search`: which crank stars balance best?

use std::ops::ControlFlow;
use std::path::PathBuf;
use std::sync::atomic::{AtomicBool, Ordering};

use num_rational::BigRational;
use pyo3::prelude::*;

use crate::python::error::told;
use crate::report::SearchStudy;
use crate::search::{self, Limit, Options, Problem, Sizes};

/// What is asked of the stars that are found.
pub(in crate::python) struct StarRequest {
    /// Their firing orders in a mode of torsional vibration, with its deflections where they are given.
    pub torsion: Option<Option<Vec<BigRational>>>,
    /// The largest moments that are allowed.
    pub limits: Vec<Limit>,
    /// What turns moments into newton-metres.
    pub sizes: Option<Sizes>,
}

/// Searches until the flag stops it.
pub(in crate::python) fn search(
    problem: &Problem,
    StarRequest { torsion, limits, sizes }: StarRequest,
    resume: Option<PathBuf>,
    threads: Option<u16>,
    stop: &AtomicBool,
) -> PyResult<SearchStudy> {
    if let Some(shape) = &torsion {
        search::mode_shape(problem, shape.clone()).map_err(told)?;
    }
    let progress = |_| if stop.load(Ordering::Relaxed) { ControlFlow::Break(()) } else { ControlFlow::Continue(()) };
    let threads = threads.map_or(Options::default().threads, usize::from);
    let options = Options { threads, resume, progress: &progress, stop: Some(stop), ..Options::default() };
    let front = search::answer(problem, &options).map_err(told)?.limited(limits, sizes).map_err(told)?;
    let torsion = torsion.map(|shape| search::torsion(&front, shape)).transpose().map_err(told)?;
    Ok(SearchStudy { front, torsion })
}
