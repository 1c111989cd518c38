//! `verify`: does all that a document says hold?

use pyo3::prelude::*;

use crate::proof::{self, AnyDocument, Counts, Unreadable, read_document};
use crate::python::error;

/// What a check that found nothing wrong was about.
#[pyclass(frozen, get_all, module = "crankstar")]
pub(in crate::python) struct Checked {
    /// Title of the engine that the document names: free text.
    title: String,
    /// How many certificates hold.
    certificates: usize,
    /// Sums that are zero, by polygons.
    polygons: usize,
    /// Sums that are not zero, by a residue.
    residues: usize,
    /// Sums that are not zero, by a splitting.
    splittings: usize,
    /// Lengths and directions in decimals that were checked.
    decimals: usize,
    /// The orders, exact texts: half ones in firing stars.
    orders: Vec<String>,
    /// The quantities.
    quantities: Vec<&'static str>,
    /// Whose masses.
    masses: Vec<&'static str>,
    /// Statements on whole orders that have several sums.
    wholes: usize,
    /// How many of them are not decided.
    open_wholes: usize,
    /// Shapes of what is left.
    shapes: usize,
    /// Statements on every order.
    theorems: usize,
    /// What the document does not prove, though a reader may think of it.
    not_covered: Vec<&'static str>,
}

#[pymethods]
impl Checked {
    fn __repr__(&self) -> String {
        format!("<Checked: all {} certificates hold>", self.certificates)
    }
}

/// Checks a document.
pub(in crate::python) fn verify(json: &[u8]) -> PyResult<Checked> {
    let document = read_document(json).map_err(unreadable)?;
    let checked = document.check().map_err(|fault| error::fault(&fault))?;
    Ok(told(&document, checked))
}

fn unreadable(error: Unreadable) -> PyErr {
    error::proof(format!("no document of `classify`, `remedy`, `loads`, `compare` or `firing` as JSON: {error}"), None)
}

fn told(document: &AnyDocument, checked: proof::Checked) -> Checked {
    let Counts { polygons, residues, splittings, decimals } = checked.counts;
    Checked {
        title: document.titles().join(", "),
        certificates: checked.counts.certificates(),
        polygons,
        residues,
        splittings,
        decimals,
        orders: checked.orders.iter().map(ToString::to_string).collect(),
        quantities: checked.quantities.iter().map(|quantity| quantity.name()).collect(),
        masses: checked.masses.iter().map(|masses| masses.name()).collect(),
        wholes: checked.wholes,
        open_wholes: checked.open_wholes,
        shapes: checked.shapes,
        theorems: checked.theorems,
        not_covered: checked.not_covered,
    }
}
