//! How does an answer travel to another process, and how is it asked again there? As its question, in texts.

use pyo3::prelude::*;
use pyo3::types::PyTuple;
use serde_json::Value;

use super::reading::{Files, Source};

/// A question as Python asks it: a method of an engine, or a function of the module, of engines or of none; with its keywords.
#[derive(Clone)]
pub(super) struct Asked {
    pub of: Of,
    pub engines: Vec<Source>,
    /// The method; on the command line the same word.
    pub name: String,
    /// The keywords as JSON.
    pub keywords: String,
}

/// What has the name that is asked.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) enum Of {
    Engine,
    Module,
}

/// What an [`Asked`] is in a pickle: whether it is a method, the engines, the name, its keywords.
pub(super) type State = (bool, Vec<(String, String, Files)>, String, String);

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
}

/// What makes an object of a pickle: a function of the module, and its arguments.
pub(super) type Reduced<'py> = (Bound<'py, PyAny>, Bound<'py, PyTuple>);

/// The function of the module that makes an object of a pickle.
pub(super) fn maker<'py>(py: Python<'py>, name: &str) -> PyResult<Bound<'py, PyAny>> {
    py.import("crankstar._crankstar")?.getattr(name)
}
