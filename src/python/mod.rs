//! What can be asked from Python? The module `crankstar`, which `pip install .` builds: every answer is that of the command line.
//!
//! `keywords, text, file, name → layout → Engine → answers: objects, columns, documents, pages`

mod again;
mod answer;
mod asked;
mod bits;
mod columns;
mod documents;
mod engine;
mod error;
mod functions;
mod interrupt;
mod judged;
mod keys;
mod notebook;
mod pages;
mod pickle;
mod questions;
mod reading;
mod star;
mod verdict;
mod verdicts;

use pyo3::prelude::*;

/// Decides exactly how a reciprocating engine balances, and writes the proof.
#[pymodule]
fn _crankstar(module: &Bound<'_, PyModule>) -> PyResult<()> {
    let py = module.py();
    module.add("__version__", env!("CARGO_PKG_VERSION"))?;
    module.add("CrankstarError", py.get_type::<error::CrankstarError>())?;
    module.add("LayoutError", py.get_type::<error::LayoutError>())?;
    module.add("ProofError", py.get_type::<error::ProofError>())?;
    module.add_class::<engine::Engine>()?;
    module.add_class::<star::Star>()?;
    module.add_class::<verdict::Verdict>()?;
    module.add_class::<verdicts::Verdicts>()?;
    module.add_class::<answer::Answer>()?;
    module.add_class::<questions::Remedy>()?;
    module.add_class::<questions::Checked>()?;
    module.add_function(wrap_pyfunction!(pickle::_engine, module)?)?;
    module.add_function(wrap_pyfunction!(pickle::_asked, module)?)?;
    module.add_function(wrap_pyfunction!(answer::_answer, module)?)?;
    module.add_function(wrap_pyfunction!(verdict::_verdict, module)?)?;
    module.add_function(wrap_pyfunction!(functions::catalogue, module)?)?;
    module.add_function(wrap_pyfunction!(functions::compare, module)?)?;
    module.add_function(wrap_pyfunction!(functions::moments, module)?)?;
    module.add_function(wrap_pyfunction!(functions::rotor, module)?)?;
    module.add_function(wrap_pyfunction!(functions::flywheel, module)?)?;
    module.add_function(wrap_pyfunction!(functions::values, module)?)?;
    module.add_function(wrap_pyfunction!(functions::search, module)?)?;
    #[cfg(feature = "cli")]
    module.add_function(wrap_pyfunction!(functions::_program, module)?)?;
    module.add_function(wrap_pyfunction!(functions::verify, module)?)
}
