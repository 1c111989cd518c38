//! What is made of a pickle? An engine as it was read, an answer by asking again.

use pyo3::prelude::*;
use pyo3::types::PyDict;

use super::again::{Asked, Of, State};
use super::documents;
use super::engine::Engine;
use super::reading::{Files, Source};

impl Asked {
    /// Asks it.
    pub fn again<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyAny>> {
        let engines = self.engines.iter().map(|source| Bound::new(py, Engine::from_source(source.clone())?));
        let engines = engines.collect::<PyResult<Vec<_>>>()?;
        let keywords = documents::as_python(py, &self.keywords)?;
        let keywords = Some(keywords.cast::<PyDict>()?);
        match (self.of, engines.as_slice()) {
            (Of::Engine, [engine, ..]) => engine.call_method(self.name.as_str(), (), keywords),
            (Of::Engine | Of::Module, []) => py.import("crankstar")?.call_method(self.name.as_str(), (), keywords),
            // A search takes an engine for the sizes of its moments.
            (Of::Module, [sizes]) if self.name == "search" => {
                let keywords =
                    keywords.map(|keywords| keywords.set_item("sizes", sizes).map(|()| keywords)).transpose()?;
                py.import("crankstar")?.call_method(self.name.as_str(), (), keywords)
            }
            (Of::Module, _) => py.import("crankstar")?.call_method(self.name.as_str(), (engines,), keywords),
        }
    }
}

/// Makes the engine of a pickle.
#[pyfunction]
pub(super) fn _engine(py: Python<'_>, name: String, text: String, files: Files) -> PyResult<Engine> {
    py.detach(|| Engine::from_source(Source::restored((name, text, files))))
}

/// Asks the question of a pickle again.
#[pyfunction]
pub(super) fn _asked<'py>(py: Python<'py>, state: State) -> PyResult<Bound<'py, PyAny>> {
    Asked::restored(state).again(py)
}
