//! `remedy`: which counterweights and balancer shafts take away what is left?

use num_rational::BigRational;
use num_traits::ToPrimitive;
use pyo3::prelude::*;
use serde_json::{Value, json};

use crate::engine::{Engine, LengthUnit};
use crate::exact::Turn;
use crate::file::{Beside, parse_length};
use crate::page::Document;
use crate::python::again::Reduced;
use crate::python::answer::{Answer, asked_again};
use crate::python::asked::{in_turns, written};
use crate::python::error::told;
use crate::python::reading::Source;
use crate::remedy::{self, Weight, Wish};
use crate::report::{self, Question};
use crate::table::{Column, Table, Unit, Values};
use crate::text::Untrusted;

/// What is wanted of a remedy, as it was written.
pub(in crate::python) struct Wanted {
    pub orders: Vec<u32>,
    pub planes: Option<[String; 2]>,
    pub factors: Vec<BigRational>,
    pub skews: Vec<Turn>,
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

struct Cured(remedy::Remedy);

/// Finds the weights, and writes the corrected engine.
pub(in crate::python) fn remedy(
    engine: &Engine,
    source: &Source,
    wanted: &Wanted,
) -> PyResult<(impl Question + use<>, Remedy)> {
    let planes =
        wanted.planes.as_ref().map(|[first, second]| Ok::<_, PyErr>([plane(engine, first)?, plane(engine, second)?]));
    let Wanted { orders, factors, skews, .. } = wanted;
    let wish =
        Wish { orders: orders.clone(), planes: planes.transpose()?, factors: factors.clone(), skews: skews.clone() };
    let cured = remedy::remedy(engine, &wish).map_err(told)?;
    let read = |path: &str| source.beside(path);
    let layout = remedy::corrected_file(&cured, &source.name, Beside::new(&read))
        .map(|file| file.text)
        .map_err(|error| error.to_string());
    let holds = cured.holds();
    Ok((Cured(cured), Remedy { holds, layout }))
}

/// A position in the unit of the engine.
fn plane(engine: &Engine, text: &str) -> PyResult<BigRational> {
    let refused = |right: &str| told(format!("planes: cannot read `{text}`: {right}"));
    let (value, unit) = parse_length(text).map_err(|right| refused(&right))?;
    if unit == LengthUnit::Metre && !engine.positions_given() {
        return Err(refused("the cylinders stand one spacing apart, and positions count in spacings"));
    }
    Ok(value)
}

impl Question for Cured {
    fn command(&self) -> &'static str {
        "remedy"
    }

    fn title(&self) -> Option<&Untrusted> {
        Some(self.0.subject.engine().title())
    }

    fn table(&self, name: &str) -> Option<Table> {
        self.tables().into_iter().find(|table| table.name() == name)
    }

    fn tables(&self) -> Vec<Table> {
        vec![weights(&self.0)]
    }

    fn json(&self) -> serde_json::Result<String> {
        serde_json::to_string_pretty(&report::remedy_document(&self.0))
    }

    fn answer(&self) -> Document {
        report::remedy_answer(&self.0)
    }

    fn page(&self) -> Document {
        report::remedy_page(&self.0)
    }
}

/// A row a weight.
fn weights(remedy: &remedy::Remedy) -> Table {
    let weights: Vec<Weight> = remedy.weights().iter().filter_map(|weight| remedy.as_built(weight)).collect();
    let position = match remedy.subject.engine().length_unit() {
        LengthUnit::Metre => Unit::METRE,
        LengthUnit::Spacing => Unit::SPACING,
    };
    let decimals = |value: &dyn Fn(&Weight) -> Option<f64>| Values::Decimal(weights.iter().map(value).collect());
    let polar = |place: usize| decimals(&move |weight| weight.decimals(&remedy.subject).map(|polar| polar[place]));
    let exact = weights.iter().map(|weight| weight.modulus().map(|form| form.to_string()));
    let columns = [
        Column::new(
            "order",
            Unit::NONE,
            "how many times it turns in a revolution of the crankshaft",
            Values::Whole(weights.iter().map(|weight| Some(weight.order.into())).collect()),
        ),
        Column::new(
            "sense",
            Unit::NONE,
            "direct: with the crank; reverse: against it",
            Values::Words(weights.iter().map(|weight| Some(weight.sense.name().to_owned())).collect()),
        ),
        Column::new(
            "position_{unit}",
            position,
            "where it stands along the crankshaft",
            decimals(&|weight| weight.position.to_f64()),
        ),
        Column::new(
            "mass_radius_exact",
            Unit::NONE,
            "its mass times radius in closed form, in m r, or in m r |c_k| where it stands before a coefficient",
            Values::Exact(exact.collect()),
        ),
        Column::new("mass_radius_{unit}", Unit::MASS_RADIUS, "its mass times radius; empty without rods", polar(0)),
        Column::new("angle_{unit}", Unit::DEGREE, "its direction where the crank angle is 0", polar(1)),
        Column::new(
            "mass_radius_{unit}",
            Unit::KILOGRAM_METRE,
            "its mass times radius, where the layout gives masses and a crank radius",
            decimals(&|weight| weight.mass_radius(&remedy.subject)),
        ),
    ];
    columns.into_iter().fold(Table::new("weights", "a weight of the remedy", weights.len()), Table::with)
}
