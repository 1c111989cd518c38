//! What is one vector star, as an object of Python?

use pyo3::prelude::*;
use pyo3::types::PyList;
use serde::{Deserialize, Serialize};

use super::documents;
use crate::numbers;
use crate::proof::Certificate;
use crate::report;
use crate::verdict;

/// One vector star `S = Σ weight · e^{2πi·angle}`, a term for each source of force.
#[pyclass(frozen, module = "crankstar")]
#[derive(Clone, PartialEq, Serialize, Deserialize)]
pub(super) struct Star {
    /// "direct", which turns with the crank, or "reverse"; None for a torque, which has one vector.
    #[pyo3(get)]
    sense: Option<String>,
    /// Whether S is proved to be zero; else it is proved not to be.
    #[pyo3(get)]
    vanishes: bool,
    /// |S| in closed form, such as `4√2`; None where none is known.
    #[pyo3(get)]
    exact: Option<String>,
    /// |S| in decimals, exactly 0.0 where it vanishes.
    #[pyo3(get)]
    #[serde(with = "super::bits::one")]
    value: f64,
    /// Direction of S in degrees, above −180 and up to 180; None where it vanishes.
    #[pyo3(get)]
    #[serde(with = "super::bits")]
    angle_deg: Option<f64>,
    terms: Vec<[String; 2]>,
    certificate: Certificate,
}

impl Star {
    pub(super) fn new(verdict: &verdict::Verdict) -> Self {
        let length = report::star_length(verdict);
        let terms = verdict.sum.terms().iter();
        Star {
            sense: verdict.sense.map(|sense| sense.name().to_owned()),
            vanishes: verdict.vanishes(),
            exact: length.exact.map(|form| form.to_string()),
            value: length.decimal,
            angle_deg: (!verdict.vanishes()).then(|| numbers::degrees(numbers::evaluate(&verdict.sum))),
            terms: terms.map(|term| [term.angle.turns().to_string(), term.weight.to_string()]).collect(),
            certificate: verdict.certificate.clone(),
        }
    }
}

#[pymethods]
impl Star {
    /// Pairs of angle in turns and weight, exact as fractions.Fraction.
    #[getter]
    fn terms<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyList>> {
        let fraction = py.import("fractions")?.getattr("Fraction")?;
        let exact = |[angle, weight]: &[String; 2]| Ok((fraction.call1((angle,))?, fraction.call1((weight,))?));
        PyList::new(py, self.terms.iter().map(exact).collect::<PyResult<Vec<_>>>()?)
    }

    /// The evidence, as in the document of the verdicts: polygons that add up to the terms, a residue that is not zero, or a splitting.
    #[getter]
    fn certificate<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyAny>> {
        documents::as_python(py, &documents::json(&self.certificate)?)
    }

    fn __repr__(&self) -> String {
        let sense = self.sense.as_ref().map_or_else(String::new, |sense| format!("{sense}, "));
        match &self.exact {
            Some(exact) => format!("<Star: {sense}|S| = {exact}>"),
            None => format!("<Star: {sense}|S| ≈ {}>", self.value),
        }
    }
}
