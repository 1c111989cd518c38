//! How do the documents of the command line become dictionaries of Python?

use pyo3::prelude::*;
use serde::Serialize;

use super::error::told;
use crate::text;

/// A document as the text that `--json` prints.
pub(super) fn json(document: &impl Serialize) -> PyResult<String> {
    let json = serde_json::to_string_pretty(document).map_err(told)?;
    Ok(text::json(&json) + "\n")
}

/// The text of a document as dicts and lists.
pub(super) fn as_python<'py>(py: Python<'py>, json: &str) -> PyResult<Bound<'py, PyAny>> {
    py.import("json")?.call_method1("loads", (json,))
}
