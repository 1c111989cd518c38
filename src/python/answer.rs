//! What has every answer in columns in Python? Tables, a document, the words of the command line, a page.

use std::hash::{DefaultHasher, Hash, Hasher};
use std::sync::OnceLock;

use pyo3::prelude::*;
use pyo3::sync::PyOnceLock;
use pyo3::types::{PyDict, PyTuple};

use super::again::{Asked, Reduced, State, maker};
use super::error::told;
use super::{columns, documents, notebook, pages};
use crate::page::{Format, Options};
use crate::report::Question;
use crate::table::Table;
use crate::text;

/// An answer: its columns, its document, its page.
///
/// Answers that say the same are equal. A pickle holds columns and document; a page or a drawing of it is computed again when it is wanted.
#[pyclass(frozen, subclass, module = "crankstar")]
pub(super) struct Answer {
    asked: Asked,
    origin: Origin,
}

enum Origin {
    /// Computed here.
    Made { question: Box<dyn Question>, tables: OnceLock<Vec<Table>> },
    /// Come in a pickle.
    Kept { kept: Kept, again: PyOnceLock<Py<Answer>> },
}

/// What travels of an answer.
struct Kept {
    tables: Py<PyDict>,
    about: Py<PyDict>,
    json: String,
}

/// The document of a question, as the command line prints it.
fn printed(question: &dyn Question) -> PyResult<String> {
    Ok(text::json(&question.json().map_err(told)?) + "\n")
}

impl Answer {
    pub(super) fn new(asked: Asked, question: impl Question + 'static) -> Self {
        Answer { asked, origin: Origin::Made { question: Box::new(question), tables: OnceLock::new() } }
    }

    pub(super) fn asked(&self) -> &Asked {
        &self.asked
    }

    /// The tables of an answer that was computed here; none of another.
    fn made(&self, py: Python<'_>) -> &[Table] {
        match &self.origin {
            Origin::Made { question, tables } => py.detach(|| tables.get_or_init(|| question.tables())),
            Origin::Kept { .. } => &[],
        }
    }

    /// What an answer that is there says; one of a pickle is asked again.
    fn question<R: Send>(&self, py: Python<'_>, of: impl FnOnce(&dyn Question) -> R + Send) -> PyResult<R> {
        match &self.origin {
            Origin::Made { question, .. } => Ok(py.detach(|| of(question.as_ref()))),
            Origin::Kept { again, .. } => {
                let ask = || Ok::<_, PyErr>(self.asked.again(py)?.cast_into::<Answer>()?.unbind());
                again.get_or_try_init(py, ask)?.get().question(py, of)
            }
        }
    }
}

#[pymethods]
impl Answer {
    /// The columns of the main table, by the names of the CSV file: a dict of NumPy arrays and lists that pandas.DataFrame and
    /// polars.DataFrame take.
    #[getter]
    fn columns<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyDict>> {
        match &self.origin {
            Origin::Made { .. } => columns::main(py, self.made(py)),
            Origin::Kept { .. } => match self.tables(py)?.values().into_iter().next() {
                Some(main) => Ok(main.cast_into()?),
                None => Ok(PyDict::new(py)),
            },
        }
    }

    /// The columns of all tables by their names, the main one first: `{table: columns}`.
    #[getter]
    fn tables<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyDict>> {
        match &self.origin {
            Origin::Made { .. } => columns::all(py, self.made(py)),
            Origin::Kept { kept, .. } => copied(kept.tables.bind(py)),
        }
    }

    /// What each column is counted in and means: `{table: {column: (unit, meaning)}}`.
    #[getter]
    fn about<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyDict>> {
        match &self.origin {
            Origin::Made { .. } => columns::about(py, self.made(py)),
            Origin::Kept { kept, .. } => copied(kept.about.bind(py)),
        }
    }

    /// What the command line prints with `--json`, as a str; where it has certificates, `verify` takes it.
    #[getter]
    fn json(&self, py: Python<'_>) -> PyResult<String> {
        match &self.origin {
            Origin::Made { question, .. } => py.detach(|| printed(question.as_ref())),
            Origin::Kept { kept, .. } => Ok(kept.json.clone()),
        }
    }

    /// The same as dicts and lists.
    fn document<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyAny>> {
        documents::as_python(py, &self.json(py)?)
    }

    /// The page of this answer as one text: "markdown", "html", "latex", "typst" or "text".
    #[pyo3(signature = (format="markdown", *, language="en"))]
    fn report(&self, py: Python<'_>, format: &str, language: &str) -> PyResult<String> {
        let (format, options) = (pages::format(format)?, pages::options(language)?);
        self.question(py, |question| pages::text(&question.page(), format, &options))
    }

    /// One drawing of the page as SVG.
    fn figure(&self, py: Python<'_>, name: &str) -> PyResult<String> {
        self.question(py, |question| pages::figure(&question.page(), name))?
    }

    fn __str__(&self, py: Python<'_>) -> PyResult<String> {
        self.question(py, |question| pages::text(&question.answer(), Format::PLAIN, &Options::default()))
    }

    fn __repr__(&self, py: Python<'_>) -> PyResult<String> {
        let rows = |(name, columns): (Bound<'_, PyAny>, Bound<'_, PyAny>)| {
            let first = columns.cast::<PyDict>()?.values().into_iter().next();
            Ok(format!("{name} ({})", first.map_or(Ok(0), |column| column.len())?))
        };
        let tables = self.tables(py)?.iter().map(rows).collect::<PyResult<Vec<String>>>()?;
        Ok(format!("<Answer to {}: {}>", self.asked.name, tables.join(", ")))
    }

    fn _repr_html_(&self, py: Python<'_>) -> PyResult<String> {
        self.question(py, |question| notebook::html(&question.answer()))
    }

    fn __eq__(&self, py: Python<'_>, other: &Bound<'_, PyAny>) -> PyResult<bool> {
        match other.cast::<Answer>() {
            Ok(other) => Ok(self.asked.name == other.get().asked.name && self.json(py)? == other.get().json(py)?),
            Err(_) => Ok(false),
        }
    }

    fn __hash__(&self, py: Python<'_>) -> PyResult<u64> {
        let mut hasher = DefaultHasher::new();
        self.json(py)?.hash(&mut hasher);
        Ok(hasher.finish())
    }

    fn __copy__(itself: Py<Self>) -> Py<Self> {
        itself
    }

    fn __deepcopy__(itself: Py<Self>, _memo: &Bound<'_, PyAny>) -> Py<Self> {
        itself
    }

    fn __reduce__<'py>(&self, py: Python<'py>) -> PyResult<Reduced<'py>> {
        let state = (self.asked.state(), self.tables(py)?, self.about(py)?, self.json(py)?);
        Ok((maker(py, "_answer")?, state.into_pyobject(py)?))
    }
}

/// A dict that its reader may change.
fn copied<'py>(dict: &Bound<'py, PyDict>) -> PyResult<Bound<'py, PyDict>> {
    Ok(dict.py().import("copy")?.call_method1("deepcopy", (dict,))?.cast_into()?)
}

/// Makes the answer of a pickle.
#[pyfunction]
pub(super) fn _answer(asked: State, tables: Py<PyDict>, about: Py<PyDict>, json: String) -> Answer {
    let kept = Kept { tables, about, json };
    Answer { asked: Asked::restored(asked), origin: Origin::Kept { kept, again: PyOnceLock::new() } }
}

/// The pickle of what is asked again when it is read.
pub(super) fn asked_again<'py>(py: Python<'py>, asked: &Asked) -> PyResult<Reduced<'py>> {
    Ok((maker(py, "_asked")?, PyTuple::new(py, [asked.state()])?))
}
