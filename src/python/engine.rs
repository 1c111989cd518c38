//! What is an engine in Python, and what can be asked of it?

use std::path::PathBuf;

use pyo3::prelude::*;
use pyo3::types::PyDict;

use super::error::{self, told};
use super::reading::Source;
use super::verdicts::Verdicts;
use super::{keys, notebook, pages};
use crate::engine::{self, Family};
use crate::family;
use crate::file;
use crate::loads;
use crate::order::Masses;
use crate::page::{Document, Format};
use crate::report::{self, Contents};
use crate::verdict::{self, Judgement};

/// An engine: its cylinders with exact angles and positions, and what else its layout says.
///
/// Engine("Four", throws=[0, 180, 180, 0])
/// Engine("V-twin", throws=[0, 0], banks=[-45, 45], positions=[0, 0])
/// Engine("V6", vee={"bank_angle": 60, "throws": [0, 240, 120]}, speed="6000 rpm")
///
/// `throws` and `banks` in degrees, `positions` along the crankshaft towards the free end in metres or in multiples of the spacing,
/// `masses` in multiples of one reciprocating mass, `names`: lists with one value for each cylinder. All other keywords are the keys and
/// tables of a layout file, as src/file/README.md lists them. Numbers are taken exactly as Python shows them: int, float, str with a unit
/// ("22.5 deg", "3/2"), fractions.Fraction, decimal.Decimal, and numbers and arrays of NumPy.
///
/// Raises LayoutError with the line and column in `layout`, the text that the keywords make.
#[pyclass(frozen, module = "crankstar")]
pub(super) struct Engine {
    pub(super) engine: engine::Engine,
    family: Option<Family>,
    pub(super) source: Source,
}

impl Engine {
    fn from_source(source: Source) -> PyResult<Self> {
        let (engine, family) = source.read()?;
        Ok(Engine { engine, family, source })
    }

    /// The orders that were asked for, rising, each once; else the usual ones.
    pub(super) fn orders(&self, asked: Option<Vec<u32>>) -> Vec<u32> {
        rising(asked.unwrap_or_else(|| loads::usual_orders(&self.engine)))
    }

    fn judged(&self, orders: &[u32], masses: Option<Masses>, torque: bool) -> PyResult<Judgement> {
        if torque && self.engine.has_links() {
            return Err(told(loads::Missing::ArticulatedRods("the inertia torque")));
        }
        let quantities = verdict::quantities(&self.engine, torque);
        match masses {
            None => Judgement::new(&self.engine, orders, &quantities).map_err(told),
            Some(masses) => Judgement::of(&self.engine, orders, masses, &quantities).map_err(told),
        }
    }

    /// The report as a document of blocks.
    fn page(&self, orders: &[u32], in_motion: bool) -> PyResult<Document> {
        let judged = self.judged(orders, None, false)?;
        let family = self.family.as_ref().filter(|family| family::comparable(family).is_ok());
        let open = family.map(|family| family::classify(family, orders).map(|judged| (family, judged)));
        let open = open.transpose().map_err(told)?;
        let family = open.as_ref().map(|(family, orders)| (*family, orders.as_slice()));
        let (engine, judged) = (&self.engine, &judged);
        Ok(report::engine_page(Contents { engine, judged, family, needed: None, in_motion, accuracy: None }))
    }

    /// The engine with its first star and the short answer.
    fn glance(&self) -> PyResult<Document> {
        let judged = self.judged(&self.orders(None), None, false)?;
        Ok(report::engine_at_a_glance(&self.engine, &judged))
    }
}

/// Rising, each once.
pub(super) fn rising(mut orders: Vec<u32>) -> Vec<u32> {
    orders.sort_unstable();
    orders.dedup();
    orders
}

#[pymethods]
impl Engine {
    #[new]
    #[pyo3(signature = (title=None, *, throws=None, banks=None, positions=None, masses=None, names=None, **keys))]
    #[expect(clippy::too_many_arguments, reason = "they are the keywords of Python")]
    fn new(
        py: Python<'_>,
        title: Option<String>,
        throws: Option<Bound<'_, PyAny>>,
        banks: Option<Bound<'_, PyAny>>,
        positions: Option<Bound<'_, PyAny>>,
        masses: Option<Bound<'_, PyAny>>,
        names: Option<Bound<'_, PyAny>>,
        keys: Option<Bound<'_, PyDict>>,
    ) -> PyResult<Self> {
        let above = PyDict::new(py);
        above.set_item("title", title.unwrap_or_else(|| "Engine".to_owned()))?;
        if let Some(keys) = keys {
            above.update(keys.as_mapping())?;
        }
        let text = keys::layout(&above)? + &keys::cylinders([names, throws, banks, positions, masses])?;
        let source = Source { name: "layout".to_owned(), text, folder: None };
        py.detach(|| Engine::from_source(source))
    }

    /// An engine of the catalogue, such as "V8-crossplane"; upper and lower case are the same.
    #[staticmethod]
    fn named(py: Python<'_>, name: &str) -> PyResult<Self> {
        py.detach(|| Engine::from_source(Source::named(name)?))
    }

    /// An engine of the text of a layout file, TOML. `name` is what messages call it.
    #[staticmethod]
    #[pyo3(signature = (text, name="layout"))]
    fn parse(py: Python<'_>, text: String, name: &str) -> PyResult<Self> {
        let name = name.to_owned();
        py.detach(|| Engine::from_source(Source { name, text, folder: None }))
    }

    /// An engine of a layout file; files that it names stand beside it.
    ///
    /// Raises OSError where it cannot be read, LayoutError where it says no engine.
    #[staticmethod]
    fn read(py: Python<'_>, path: PathBuf) -> PyResult<Self> {
        py.detach(|| Engine::from_source(Source::on_disk(&path)?))
    }

    /// What the engine is called.
    #[getter]
    fn title(&self) -> &str {
        self.engine.title().written()
    }

    /// The layout file, as it was read or as the keywords make it.
    #[getter]
    fn layout(&self) -> &str {
        &self.source.text
    }

    /// The orders that are judged where none are asked for.
    #[getter]
    fn usual_orders(&self) -> Vec<u32> {
        self.orders(None)
    }

    /// The number of pistons.
    fn __len__(&self) -> usize {
        self.engine.cylinders().len()
    }

    fn __repr__(&self) -> String {
        let count = self.engine.cylinders().len();
        let plural = if count == 1 { "" } else { "s" };
        format!("<Engine: {}, {count} cylinder{plural}>", crate::text::harmless(self.title()))
    }

    /// The verdicts, order by order: does force or moment vanish, and what is left?
    ///
    /// orders: 1 to 1000; those of the layout and the usual ones where left out.
    /// masses: "reciprocating", "rotating", "counterweights" or "all"; all that the layout has where left out.
    /// torque: judge the inertia torque too.
    /// all_orders: prove what vanishes at every order, in the document.
    #[pyo3(signature = (orders=None, *, masses=None, torque=false, all_orders=false))]
    fn classify(
        &self,
        py: Python<'_>,
        orders: Option<Vec<u32>>,
        masses: Option<&str>,
        torque: bool,
        all_orders: bool,
    ) -> PyResult<Verdicts> {
        let masses = masses.map(masses_of).transpose()?;
        py.detach(|| {
            let judged = self.judged(&self.orders(orders), masses, torque)?;
            let theorem = all_orders.then(|| verdict::theorem(&self.engine, judged.masses));
            let theorem = theorem.transpose().map_err(told)?;
            let quantities = verdict::quantities(&self.engine, torque);
            let document = report::document(&self.engine, judged.masses, &judged.orders, &quantities, theorem.as_ref());
            let answer = report::engine_answer(&self.engine, &judged);
            Verdicts::new(&judged, &document, answer)
        })
    }

    /// The report as one text.
    ///
    /// format: "markdown", "html", "latex", "typst" or "text". HTML and LaTeX hold their pictures; of Markdown and Typst the pictures are
    /// files beside it, which `report_files` gives too.
    /// language: "en" or "de".
    #[pyo3(signature = (format="markdown", *, orders=None, language="en"))]
    fn report(
        &self,
        py: Python<'_>,
        format: &str,
        orders: Option<Vec<u32>>,
        language: &str,
    ) -> PyResult<String> {
        let mut files = self.report_files(py, format, orders, language)?;
        Ok(files.remove(0).1)
    }

    /// The report as pairs of file name and text: the page first, then its pictures.
    #[pyo3(signature = (format="markdown", *, orders=None, language="en"))]
    fn report_files(
        &self,
        py: Python<'_>,
        format: &str,
        orders: Option<Vec<u32>>,
        language: &str,
    ) -> PyResult<Vec<(String, String)>> {
        let (format, options) = (pages::format(format)?, pages::options(language)?);
        py.detach(|| {
            let page = self.page(&self.orders(orders), format == Format::Html)?;
            Ok(pages::files(&page, format, &options))
        })
    }

    /// One drawing of the report as SVG, such as "end-view", "side-view" or "star:2".
    fn figure(&self, py: Python<'_>, name: &str) -> PyResult<String> {
        py.detach(|| {
            let mut orders = self.orders(None);
            let named = name.strip_prefix("star:").and_then(|star| star.split(':').next());
            orders.extend(named.and_then(|order| order.parse::<u32>().ok()));
            pages::figure(&self.page(&rising(orders), false)?, name)
        })
    }

    fn _repr_html_(&self, py: Python<'_>) -> PyResult<String> {
        py.detach(|| Ok(notebook::html(&self.glance()?)))
    }

    fn _repr_latex_(&self, py: Python<'_>) -> PyResult<String> {
        Ok(notebook::latex(&self.classify(py, None, None, false, false)?.verdicts))
    }
}

fn masses_of(name: &str) -> PyResult<Masses> {
    match name {
        "reciprocating" => Ok(Masses::Reciprocating),
        "rotating" => Ok(Masses::Rotating),
        "counterweights" => Ok(Masses::Counterweights),
        "all" => Ok(Masses::All),
        other => Err(told(format!("masses `{other}`; reciprocating, rotating, counterweights or all are judged"))),
    }
}

/// The names of the engines that are known, as `Engine.named` takes them.
#[pyfunction]
pub(super) fn catalogue() -> PyResult<Vec<&'static str>> {
    let engines = file::catalogue().map_err(|error| error::layout(&error))?;
    Ok(engines.iter().map(|(entry, _)| entry.name).collect())
}
