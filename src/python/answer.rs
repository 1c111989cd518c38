//! What has every answer in columns in Python? Tables, a document, the words of the command line, a page.

use std::sync::OnceLock;

use pyo3::prelude::*;
use pyo3::types::PyDict;

use super::error::told;
use super::{columns, documents, notebook, pages};
use crate::page::{Format, Options};
use crate::report::Question;
use crate::table::Table;
use crate::text;

/// An answer: its columns, its document, its page.
#[pyclass(frozen, subclass, module = "crankstar")]
pub(super) struct Answer {
    question: Box<dyn Question>,
    tables: OnceLock<Vec<Table>>,
}

impl Answer {
    pub(super) fn new(question: impl Question + 'static) -> Self {
        Answer { question: Box::new(question), tables: OnceLock::new() }
    }

    fn made(&self, py: Python<'_>) -> &[Table] {
        py.detach(|| self.tables.get_or_init(|| self.question.tables()))
    }
}

#[pymethods]
impl Answer {
    /// The columns of the main table, by the names of the CSV file: a dict of NumPy arrays and lists that pandas.DataFrame and
    /// polars.DataFrame take.
    #[getter]
    fn columns<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyDict>> {
        columns::main(py, self.made(py))
    }

    /// The columns of all tables by their names, the main one first: `{table: columns}`.
    #[getter]
    fn tables<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyDict>> {
        columns::all(py, self.made(py))
    }

    /// What each column is counted in and means: `{table: {column: (unit, meaning)}}`.
    #[getter]
    fn about<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyDict>> {
        columns::about(py, self.made(py))
    }

    /// What the command line prints with `--json`, as a str; where it has certificates, `verify` takes it.
    #[getter]
    fn json(&self, py: Python<'_>) -> PyResult<String> {
        py.detach(|| Ok(text::json(&self.question.json().map_err(told)?) + "\n"))
    }

    /// The same as dicts and lists.
    fn document<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyAny>> {
        documents::as_python(py, &self.json(py)?)
    }

    /// The page of this answer as one text: "markdown", "html", "latex", "typst" or "text".
    #[pyo3(signature = (format="markdown", *, language="en"))]
    fn report(&self, py: Python<'_>, format: &str, language: &str) -> PyResult<String> {
        let (format, options) = (pages::format(format)?, pages::options(language)?);
        Ok(py.detach(|| pages::text(&self.question.page(), format, &options)))
    }

    /// One drawing of the page as SVG.
    fn figure(&self, py: Python<'_>, name: &str) -> PyResult<String> {
        py.detach(|| pages::figure(&self.question.page(), name))
    }

    fn __str__(&self, py: Python<'_>) -> String {
        py.detach(|| pages::text(&self.question.answer(), Format::PLAIN, &Options::default()))
    }

    fn __repr__(&self, py: Python<'_>) -> String {
        let tables: Vec<String> =
            self.made(py).iter().map(|table| format!("{} ({})", table.name(), table.rows())).collect();
        format!("<Answer to {}: {}>", self.question.command(), tables.join(", "))
    }

    fn _repr_html_(&self, py: Python<'_>) -> String {
        py.detach(|| notebook::html(&self.question.answer()))
    }
}
