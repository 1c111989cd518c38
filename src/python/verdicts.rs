//! What is the answer to `classify` in Python? A sequence of verdicts, and its document with the certificates.

use std::hash::{DefaultHasher, Hash, Hasher};

use pyo3::exceptions::{PyIndexError, PyKeyError};
use pyo3::prelude::*;
use pyo3::types::{PyDict, PyIterator, PyList};

use super::again::{Asked, Reduced};
use super::answer::asked_again;
use super::verdict::{self, Verdict};
use super::{columns, documents, notebook, pages};
use crate::engine::Engine;
use crate::page::{Document, Format, Options};
use crate::proof;
use crate::report::{self, data};
use crate::table::Table;
use crate::verdict::Judgement;

/// The verdicts on an engine, order by order: a sequence.
#[pyclass(frozen, sequence, module = "crankstar")]
pub(super) struct Verdicts {
    asked: Asked,
    pub(super) verdicts: Vec<Verdict>,
    pistons: Option<Vec<Verdict>>,
    tables: Vec<Table>,
    json: String,
    answer: Document,
}

impl Verdicts {
    pub(super) fn new(asked: Asked, engine: &Engine, judged: &Judgement, document: &proof::Document) -> PyResult<Self> {
        let all = |orders: &[crate::verdict::OrderVerdict]| orders.iter().flat_map(verdict::of_order).collect();
        Ok(Verdicts {
            asked,
            verdicts: all(&judged.orders),
            pistons: judged.pistons.as_deref().map(all),
            tables: data::classify(engine, judged, document),
            json: documents::json(document)?,
            answer: report::engine_answer(engine, judged),
        })
    }
}

#[pymethods]
impl Verdicts {
    fn __len__(&self) -> usize {
        self.verdicts.len()
    }

    fn __getitem__(&self, index: isize) -> PyResult<Verdict> {
        let count = self.verdicts.len() as isize;
        let place = if index < 0 { index + count } else { index };
        let verdict = usize::try_from(place).ok().and_then(|place| self.verdicts.get(place));
        verdict.cloned().ok_or_else(|| PyIndexError::new_err(format!("verdict {index} of {count}")))
    }

    fn __iter__<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyIterator>> {
        PyList::new(
            py,
            self.verdicts.iter().cloned().map(|verdict| Py::new(py, verdict)).collect::<PyResult<Vec<_>>>()?,
        )?
        .try_iter()
    }

    /// The verdict on one quantity, "force", "moment", "torque" or "roll", of one order.
    ///
    /// Raises KeyError where it was not judged.
    fn of(&self, quantity: &str, order: u32) -> PyResult<Verdict> {
        let found = self.verdicts.iter().find(|verdict| verdict.quantity == quantity && verdict.order == order);
        let told = || PyKeyError::new_err(format!("no verdict on the {quantity} of order {order}"));
        found.cloned().ok_or_else(told)
    }

    /// The verdicts on the pistons alone, where the engine as it is built has masses that turn; else None.
    #[getter]
    fn pistons(&self) -> Option<Vec<Verdict>> {
        self.pistons.clone()
    }

    /// A row an order: a dict of NumPy arrays and lists, by the names of the CSV file, that pandas.DataFrame and polars.DataFrame take.
    #[getter]
    fn columns<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyDict>> {
        columns::main(py, &self.tables)
    }

    /// The columns of all tables by their names: `orders`, `sums`, and `torque` and `roll` where they were decided.
    #[getter]
    fn tables<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyDict>> {
        columns::all(py, &self.tables)
    }

    /// What each column is counted in and means: `{table: {column: (unit, meaning)}}`.
    #[getter]
    fn about<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyDict>> {
        columns::about(py, &self.tables)
    }

    /// What `crankstar classify --json` prints, as a str: `verify` takes it.
    #[getter]
    fn json(&self) -> &str {
        &self.json
    }

    /// The same as dicts and lists, with every certificate.
    fn document<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyAny>> {
        documents::as_python(py, &self.json)
    }

    fn __eq__(&self, other: &Bound<'_, PyAny>) -> bool {
        other.cast::<Verdicts>().is_ok_and(|other| other.get().json == self.json)
    }

    fn __hash__(&self) -> u64 {
        let mut hasher = DefaultHasher::new();
        self.json.hash(&mut hasher);
        hasher.finish()
    }

    fn __copy__(itself: Py<Self>) -> Py<Self> {
        itself
    }

    fn __deepcopy__(itself: Py<Self>, _memo: &Bound<'_, PyAny>) -> Py<Self> {
        itself
    }

    /// The question is asked again where a pickle is read.
    fn __reduce__<'py>(&self, py: Python<'py>) -> PyResult<Reduced<'py>> {
        asked_again(py, &self.asked)
    }

    fn __str__(&self) -> String {
        pages::text(&self.answer, Format::PLAIN, &Options::default())
    }

    fn __repr__(&self) -> String {
        format!("<Verdicts: {} of {}>", self.verdicts.len(), self.answer.title.plain())
    }

    fn _repr_html_(&self, py: Python<'_>) -> String {
        py.detach(|| notebook::html(&self.answer))
    }

    fn _repr_latex_(&self) -> String {
        latex(&self.verdicts)
    }
}

/// The verdicts as one formula in TeX, with what MathJax knows: a row an order, a column a quantity.
pub(super) fn latex(verdicts: &[Verdict]) -> String {
    let mut quantities: Vec<&str> = Vec::new();
    let mut orders: Vec<u32> = Vec::new();
    for verdict in verdicts {
        if !quantities.contains(&verdict.quantity.as_str()) {
            quantities.push(verdict.quantity.as_str());
        }
        if !orders.contains(&verdict.order) {
            orders.push(verdict.order);
        }
    }
    let cell = |order: u32, quantity: &str| {
        let of = verdicts.iter().find(|verdict| verdict.order == order && verdict.quantity == quantity);
        of.map(|verdict| verdict.tex.as_str()).unwrap_or_default()
    };
    let heading: Vec<String> = quantities.iter().map(|quantity| format!("\\text{{{quantity}}}")).collect();
    let row = |&order: &u32| {
        let cells: Vec<&str> = quantities.iter().map(|quantity| cell(order, quantity)).collect();
        format!("{order} & {}", cells.join(" & "))
    };
    let rows: Vec<String> = orders.iter().map(row).collect();
    format!(
        "$$\\begin{{array}}{{r{}}}\n\\text{{order}} & {} \\\\\n\\hline\n{}\n\\end{{array}}$$",
        "l".repeat(quantities.len()),
        heading.join(" & "),
        rows.join(" \\\\\n")
    )
}
