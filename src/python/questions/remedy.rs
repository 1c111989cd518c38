//! `remedy`: which counterweights and balancer shafts cancel what is left?

use num_rational::BigRational;
use pyo3::prelude::*;
use serde_json::{Value, json};

use crate::engine::Engine;
use crate::exact::Turn;
use crate::file::{FileResolver, parse_radius};
use crate::loads;
use crate::python::again::Reduced;
use crate::python::answer::{Answer, asked_again};
use crate::python::asked::{in_turns, rising, written};
use crate::python::error::told;
use crate::python::reading::Source;
use crate::remedy::{self, Request, SmallOrders};
use crate::report::{self, Weighing};

/// What is wanted of a remedy, as it was written.
pub(in crate::python) struct Wanted {
    pub orders: Option<Vec<u32>>,
    pub planes: Option<[String; 2]>,
    pub factors: Vec<BigRational>,
    pub skews: Vec<Turn>,
    pub radius: Option<String>,
}

impl Wanted {
    /// The same as the keywords of Python.
    pub fn keywords(&self) -> Value {
        let skews: Vec<String> = self.skews.iter().map(in_turns).collect();
        let some = |texts: Vec<String>| (!texts.is_empty()).then_some(texts);
        json!({
            "orders": self.orders,
            "planes": self.planes,
            "balance_factor": some(written(&self.factors)),
            "skew": some(skews),
            "radius": self.radius,
        })
    }
}

/// Counterweights and balancer shafts that balance an engine, proved on the corrected engine: an answer, its main table the weights.
#[pyclass(frozen, extends = Answer, module = "crankstar")]
pub(in crate::python) struct Remedy {
    /// Whether every sum of the corrected engine is proved to be zero, but for those that are too little for a weight.
    #[pyo3(get)]
    holds: bool,
    layout: Result<String, String>,
}

#[pymethods]
impl Remedy {
    /// The layout file of the corrected engine: `Engine.parse` reads it. Exact, but for weights against what links on a master rod leave:
    /// these are rounded, and a comment in it says so.
    ///
    /// Raises CrankstarError where no file can say it.
    #[getter]
    fn layout(&self) -> PyResult<&str> {
        self.layout.as_deref().map_err(told)
    }

    /// The weights are found again where a pickle is read.
    fn __reduce__<'py>(itself: PyRef<'py, Self>) -> PyResult<Reduced<'py>> {
        asked_again(itself.py(), itself.as_super().asked())
    }
}

/// Finds the weights, and writes the corrected engine.
pub(in crate::python) fn remedy(
    engine: &Engine,
    source: &Source,
    wanted: &Wanted,
) -> PyResult<(remedy::Remedy, Remedy)> {
    let plane = |text: &String| {
        remedy::plane_of(engine, text).map_err(|right| told(format!("planes: cannot read `{text}`: {right}")))
    };
    let planes = wanted.planes.as_ref().map(|[first, second]| Ok::<_, PyErr>([plane(first)?, plane(second)?]));
    let Wanted { orders, factors, skews, .. } = wanted;
    let radius = wanted
        .radius
        .as_deref()
        .map(|text| parse_radius(text).map_err(|right| told(format!("radius: cannot read `{text}`: {right}"))));
    let radius = radius.transpose()?;
    let (orders, small) = match orders {
        Some(orders) => (rising(orders.clone()), SmallOrders::default()),
        None => report::worth_curing(engine, loads::usual_orders(engine), Weighing::usual()),
    };
    let (factors, skews) = (factors.clone(), skews.clone());
    let request = Request { orders, small, planes: planes.transpose()?, factors, skews, radius, ..Request::default() };
    let cured = remedy::remedy(engine, &request).map_err(told)?;
    let read = |path: &str| source.beside(path);
    let layout = remedy::corrected_file(&cured, &source.name, FileResolver::new(&read))
        .map(|file| file.text)
        .map_err(|error| error.to_string());
    let holds = cured.holds();
    Ok((cured, Remedy { holds, layout }))
}
