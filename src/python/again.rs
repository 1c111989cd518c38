//! How does an answer travel to another process, and how is it asked again there? As its question, in texts.

use pyo3::prelude::*;
use pyo3::types::{PyDict, PyTuple};
use serde_json::Value;

use super::documents;
use super::engine::Engine;
use super::reading::Source;

/// A question as Python asks it: a method of an engine, or a function of the module, with its keywords.
#[derive(Clone)]
pub(super) struct Asked {
    engine: Option<Source>,
    /// The method; on the command line the same word.
    pub name: String,
    /// The keywords as JSON.
    keywords: String,
}

/// What an [`Asked`] is in a pickle: the engine, the method, its keywords.
pub(super) type State = (Option<(String, String, Files)>, String, String);

/// Files beside a layout: their names, and what is in them.
pub(super) type Files = Vec<(String, String)>;

impl Asked {
    /// A method of an engine.
    pub fn of(engine: &Source, name: &str, keywords: &Value) -> Self {
        Asked { engine: Some(engine.clone()), name: name.to_owned(), keywords: keywords.to_string() }
    }

    /// A function of the module.
    pub fn function(name: &str, keywords: &Value) -> Self {
        Asked { engine: None, name: name.to_owned(), keywords: keywords.to_string() }
    }

    pub fn state(&self) -> State {
        (self.engine.as_ref().map(Source::state), self.name.clone(), self.keywords.clone())
    }

    pub fn restored((engine, name, keywords): State) -> Self {
        Asked { engine: engine.map(Source::restored), name, keywords }
    }

    /// Asks it.
    pub fn again<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyAny>> {
        let asked = match &self.engine {
            Some(source) => Bound::new(py, Engine::from_source(source.clone())?)?.into_any(),
            None => py.import("crankstar")?.into_any(),
        };
        let keywords = documents::as_python(py, &self.keywords)?;
        asked.call_method(self.name.as_str(), (), Some(keywords.cast::<PyDict>()?))
    }
}

/// What makes an object of a pickle: a function of the module, and its arguments.
pub(super) type Reduced<'py> = (Bound<'py, PyAny>, Bound<'py, PyTuple>);

/// The function of the module that makes an object of a pickle.
pub(super) fn maker<'py>(py: Python<'py>, name: &str) -> PyResult<Bound<'py, PyAny>> {
    py.import("crankstar._crankstar")?.getattr(name)
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
