//! How does an answer travel to another process, and how is it asked again there? As its question, in texts.

use pyo3::prelude::*;
use pyo3::types::{PyDict, PyTuple};
use serde_json::Value;

use super::documents;
use super::engine::Engine;
use super::reading::Source;

/// A question as Python asks it: a method of an engine, or a function of the module, of engines or of none; with its keywords.
#[derive(Clone)]
pub(super) struct Asked {
    of: Of,
    engines: Vec<Source>,
    /// The method; on the command line the same word.
    pub name: String,
    /// The keywords as JSON.
    keywords: String,
}

/// What has the name that is asked.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Of {
    Engine,
    Module,
}

/// What an [`Asked`] is in a pickle: whether it is a method, the engines, the name, its keywords.
pub(super) type State = (bool, Vec<(String, String, Files)>, String, String);

/// Files beside a layout: their names, and what is in them.
pub(super) type Files = Vec<(String, String)>;

impl Asked {
    /// A method of an engine.
    pub fn of(engine: &Source, name: &str, keywords: &Value) -> Self {
        Asked { of: Of::Engine, engines: vec![engine.clone()], name: name.to_owned(), keywords: keywords.to_string() }
    }

    /// A function of the module; where there are engines, they are a list before its keywords.
    pub fn function(name: &str, engines: Vec<Source>, keywords: &Value) -> Self {
        Asked { of: Of::Module, engines, name: name.to_owned(), keywords: keywords.to_string() }
    }

    pub fn state(&self) -> State {
        let engines = self.engines.iter().map(Source::state).collect();
        (self.of == Of::Engine, engines, self.name.clone(), self.keywords.clone())
    }

    pub fn restored((is_method, engines, name, keywords): State) -> Self {
        let of = if is_method { Of::Engine } else { Of::Module };
        Asked { of, engines: engines.into_iter().map(Source::restored).collect(), name, keywords }
    }

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
