//! What is an engine in Python, and what can be asked of it?

use std::collections::BTreeMap;
use std::hash::{DefaultHasher, Hash, Hasher};
use std::path::PathBuf;

use pyo3::prelude::*;
use pyo3::types::PyDict;
use serde_json::{Value, json};

use super::again::{Asked, Reduced, maker};
use super::answer::Answer;
use super::asked::written;
use super::error::told;
use super::interrupt::interruptible;
use super::questions::{self, Remedy, Wanted};
use super::reading::Source;
use super::verdicts::{self, Verdicts};
use super::{asked, keys, notebook, pages};
use crate::accuracy::Timing;
use crate::engine::{self, Family};
#[cfg(feature = "optimise")]
use crate::file::FileResolver;
use crate::firing::Weights;
#[cfg(feature = "optimise")]
use crate::optimise::Request;
use crate::page::Format;
#[cfg(feature = "optimise")]
use crate::report::OptimiseStudy;
use crate::report::{
    self, AccuracyStudy, AngleStudy, AnglesAsked, BearingsStudy, FiringStudy, LoadsStudy, MountsAsked, MountsStudy,
    TorqueStudy, TorsionStudy,
};
use crate::{loads, verdict};

/// An engine: its cylinders with exact angles and positions, and what else its layout says.
///
/// Engine("Four", throws=[0, 180, 180, 0])
/// Engine("V-twin", throws=[0, 0], banks=[-45, 45], positions=[0, 0])
/// Engine("V6", vee={"bank_angle": 60, "throws": [0, 240, 120]}, speed="6000 rpm")
///
/// `throws` and `banks` in degrees, `positions` along the crankshaft towards the free end in metres or in multiples of the spacing,
/// `masses` in multiples of one reciprocating mass, `names`: lists with one value for each cylinder. All other keywords are the keys and
/// tables of a layout file, as src/kernel/file/README.md lists them. Numbers are taken exactly as Python shows them: int, float, str with a unit
/// ("22.5 deg", "3/2"), fractions.Fraction, decimal.Decimal, and numbers and arrays of NumPy.
///
/// Raises LayoutError with the line and column in `layout`, the text that the keywords make.
///
/// Engines are equal whose layouts are, with the files that they name; a pickle holds these, and is read where they are not.
#[pyclass(frozen, module = "crankstar")]
pub(super) struct Engine {
    pub(super) engine: engine::Engine,
    pub(super) family: Option<Family>,
    pub(super) source: Source,
}

impl Engine {
    pub(super) fn from_source(mut source: Source) -> PyResult<Self> {
        let (engine, family) = source.read()?;
        Ok(Engine { engine, family, source })
    }

    /// The engine, in which a cylinder may misfire.
    fn fired(&self, misfire: Option<&str>) -> PyResult<engine::Engine> {
        match misfire {
            None => Ok(self.engine.clone()),
            Some(name) => self.engine.misfiring(name).map_err(told),
        }
    }

    fn asked(&self, name: &str, keywords: &Value) -> Asked {
        Asked::of(&self.source, name, keywords)
    }

    /// The orders that were asked for, rising, each once; else the usual ones.
    pub(super) fn orders(&self, asked: Option<Vec<u32>>) -> Vec<u32> {
        asked::rising(asked.unwrap_or_else(|| loads::usual_orders(&self.engine)))
    }
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
        let source = Source { name: "layout".to_owned(), text, folder: None, files: BTreeMap::new() };
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
        py.detach(|| Engine::from_source(Source { name, text, folder: None, files: BTreeMap::new() }))
    }

    /// An engine of a layout file; files that it names are beside it.
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

    /// The orders that are decided where none are asked for.
    #[getter]
    fn usual_orders(&self) -> Vec<u32> {
        self.orders(None)
    }

    /// The number of pistons.
    fn __len__(&self) -> usize {
        self.engine.cylinders().len()
    }

    fn __repr__(&self) -> String {
        let cylinders = crate::text::counted(self.engine.cylinders().len(), "cylinder");
        format!("<Engine: {}, {cylinders}>", crate::text::harmless(self.title()))
    }

    fn __eq__(&self, other: &Bound<'_, PyAny>) -> bool {
        let same = |other: &Source| self.source.text == other.text && self.source.files == other.files;
        other.cast::<Engine>().is_ok_and(|other| same(&other.get().source))
    }

    fn __hash__(&self) -> u64 {
        let mut hasher = DefaultHasher::new();
        self.source.text.hash(&mut hasher);
        hasher.finish()
    }

    fn __copy__(itself: Py<Self>) -> Py<Self> {
        itself
    }

    fn __deepcopy__(itself: Py<Self>, _memo: &Bound<'_, PyAny>) -> Py<Self> {
        itself
    }

    fn __reduce__<'py>(&self, py: Python<'py>) -> PyResult<Reduced<'py>> {
        Ok((maker(py, "_engine")?, self.source.state().into_pyobject(py)?))
    }

    /// The verdicts, order by order: does force or moment vanish, and what is left?
    ///
    /// orders: 1 to 1000; those of the layout and the usual ones where omitted.
    /// masses: "reciprocating", "rotating", "counterweights" or "all"; all that the layout has where omitted.
    /// torque: judge the inertia torque too.
    /// all_orders: prove what vanishes at every order, in the document.
    #[pyo3(signature = (orders=None, *, masses=None, torque=false, all_orders=false))]
    fn classify(
        &self,
        py: Python<'_>,
        orders: Option<&Bound<'_, PyAny>>,
        masses: Option<&str>,
        torque: bool,
        all_orders: bool,
    ) -> PyResult<Verdicts> {
        let (orders, named) = (self.orders(asked::orders(orders)?), masses);
        let masses = named.map(asked::masses).transpose()?;
        let keywords = json!({ "orders": orders, "masses": named, "torque": torque, "all_orders": all_orders });
        let asked = self.asked("classify", &keywords);
        py.detach(|| {
            let judged = self.judged(&orders, masses, torque)?;
            let theorem = all_orders.then(|| verdict::every_order(&self.engine, judged.masses));
            let theorem = theorem.transpose().map_err(told)?;
            let quantities = verdict::quantities(&self.engine, torque);
            let document = report::document(&self.engine, judged.masses, &judged.orders, &quantities, theorem.as_ref());
            Verdicts::new(asked, &self.engine, &judged, &document)
        })
    }

    /// Forces, moments and torques, in newtons where the layout gives masses, a crank radius and a speed; else in multiples.
    ///
    /// Tables: the orders, and the course over the crank angle. Amplitudes are zero to peak.
    #[pyo3(signature = (orders=None))]
    fn loads(&self, py: Python<'_>, orders: Option<&Bound<'_, PyAny>>) -> PyResult<Answer> {
        let orders = self.orders(asked::orders(orders)?);
        let study = py.detach(|| LoadsStudy::new(&self.engine, &orders, None)).map_err(told)?;
        Ok(Answer::new(self.asked("loads", &json!({ "orders": orders })), study))
    }

    /// What the main bearings feel, whose positions the layout gives; with the gas where it has `effects = ["gas"]`.
    #[pyo3(signature = (orders=None))]
    fn bearings(&self, py: Python<'_>, orders: Option<&Bound<'_, PyAny>>) -> PyResult<Answer> {
        let orders = asked::orders(orders)?;
        let usual = || loads::usual_bearing_orders(&self.engine);
        let orders = asked::rising(orders.unwrap_or_else(usual));
        let study = py.detach(|| BearingsStudy::new(&self.engine, &orders)).map_err(told)?;
        Ok(Answer::new(self.asked("bearings", &json!({ "orders": orders })), study))
    }

    /// The counterweights and balancer shafts that make all vectors of these orders vanish, proved on the corrected engine.
    ///
    /// orders: where omitted, 1, 2 and those of at least a hundredth of the largest.
    /// planes: two positions for counterweights and couples; the outermost throws where omitted.
    /// balance_factor, skew: counterweights on each throw with this factor, turned on by this many degrees; one for all, or a list.
    /// radius: such as "3.5 in", at which the table tells the mass of each weight.
    #[pyo3(signature = (orders=None, *, planes=None, balance_factor=None, skew=None, radius=None))]
    fn remedy<'py>(
        &self,
        py: Python<'py>,
        orders: Option<&Bound<'_, PyAny>>,
        planes: Option<&Bound<'_, PyAny>>,
        balance_factor: Option<&Bound<'_, PyAny>>,
        skew: Option<&Bound<'_, PyAny>>,
        radius: Option<String>,
    ) -> PyResult<Bound<'py, Remedy>> {
        let wanted = Wanted {
            orders: asked::orders(orders)?,
            planes: planes.map(asked::planes).transpose()?,
            factors: asked::factors(balance_factor)?,
            skews: asked::skews(skew)?,
            radius,
        };
        let (question, remedy) = py.detach(|| questions::remedy(&self.engine, &self.source, &wanted))?;
        let answer = Answer::new(self.asked("remedy", &wanted.keywords()), question);
        Bound::new(py, PyClassInitializer::from(answer).add_subclass(remedy))
    }

    /// The firing stars: which orders of the gas torque vanish, whatever the pressure is. The document has the certificates.
    ///
    /// orders: such as [0.5, 1, "3/2"]. mode_shape: deflections of the throws in a mode of torsional vibration, one per cylinder.
    #[pyo3(signature = (orders=None, *, mode_shape=None))]
    fn firing(
        &self,
        py: Python<'_>,
        orders: Option<&Bound<'_, PyAny>>,
        mode_shape: Option<&Bound<'_, PyAny>>,
    ) -> PyResult<Answer> {
        let (orders, weights) = (asked::cycle_orders(orders)?, asked::weights(mode_shape)?);
        let shape = match &weights {
            Weights::Rigid => None,
            Weights::ModeShape(shape) => Some(written(shape)),
        };
        let keywords = json!({ "orders": written(&orders), "mode_shape": shape });
        let study = py.detach(|| FiringStudy::new(&self.engine, &orders, weights)).map_err(told)?;
        Ok(Answer::new(self.asked("firing", &keywords), study))
    }

    /// The torque of gas and inertia, power and flywheel; needs `[gas]` in the layout.
    ///
    /// misfire: the name of a cylinder that does not fire.
    #[pyo3(signature = (*, misfire=None))]
    fn torque(&self, py: Python<'_>, misfire: Option<&str>) -> PyResult<Answer> {
        let engine = self.fired(misfire)?;
        let study = py.detach(|| TorqueStudy::new(&engine)).map_err(told)?;
        Ok(Answer::new(self.asked("torque", &json!({ "misfire": misfire })), study))
    }

    /// Motion, forces and torque of every piston at crank angles, and what the main bearings feel.
    ///
    /// at: degrees, such as [30, 125]. every: one row every DEGREES; 10 where both are omitted. gravity: adds the weight, in m/s².
    #[pyo3(signature = (at=None, *, every=None, gravity=None))]
    fn angle(
        &self,
        py: Python<'_>,
        at: Option<Vec<f64>>,
        every: Option<f64>,
        gravity: Option<f64>,
    ) -> PyResult<Answer> {
        let wanted = AnglesAsked { at: at.unwrap_or_default(), every, gravity };
        let keywords = json!({ "at": wanted.at, "every": every, "gravity": gravity });
        let study = py.detach(|| AngleStudy::new(&self.engine, &wanted)).map_err(told)?;
        Ok(Answer::new(self.asked("angle", &keywords), study))
    }

    /// The natural frequencies of the crankshaft and its critical speeds; needs `[torsion]` in the layout.
    ///
    /// orders: such as [0.5, 1, "3/2"]; those up to 12 where omitted. misfire: the name of a cylinder that does not fire.
    #[pyo3(signature = (orders=None, *, misfire=None))]
    fn torsion(&self, py: Python<'_>, orders: Option<&Bound<'_, PyAny>>, misfire: Option<&str>) -> PyResult<Answer> {
        let (orders, engine) = (asked::cycle_orders(orders)?, self.fired(misfire)?);
        let study = py.detach(|| TorsionStudy::new(&engine, &orders)).map_err(told)?;
        let keywords = json!({ "orders": written(&orders), "misfire": misfire });
        Ok(Answer::new(self.asked("torsion", &keywords), study))
    }

    /// The engine on its mounts: modes, what each order moves and what the mounts pass on, the torque-roll axis; needs `[block]` and
    /// `[[mount]]` in the layout.
    ///
    /// orders: such as [0.5, 1, 2]; those up to 6 where omitted. speed: in place of that of the layout, in rpm; start and end: the range of
    /// speeds, from a tenth of its end to the speed where omitted.
    #[pyo3(signature = (orders=None, speed=None, start=None, end=None))]
    fn mounts(
        &self,
        py: Python<'_>,
        orders: Option<&Bound<'_, PyAny>>,
        speed: Option<f64>,
        start: Option<f64>,
        end: Option<f64>,
    ) -> PyResult<Answer> {
        let wanted = MountsAsked { orders: asked::cycle_orders(orders)?, speed, from: start, to: end };
        let keywords = json!({ "orders": written(&wanted.orders), "speed": speed, "start": start, "end": end });
        let study = py.detach(|| MountsStudy::new(&self.engine, &wanted)).map_err(told)?;
        Ok(Answer::new(self.asked("mounts", &keywords), study))
    }

    /// For each mass of the crankshaft the counterweights with the least load of the main bearings, the first-order force that turns with
    /// the crank removed exactly. Tables: the points with their layout files, counterweights, bearings, uniform balance factors.
    ///
    /// couple: "zero", or what may remain of the first-order couple in N·m. points: how many, from the lightest to the least loaded.
    #[cfg(feature = "optimise")]
    #[pyo3(signature = (orders=None, *, couple=None, points=9))]
    fn optimise(
        &self,
        py: Python<'_>,
        orders: Option<&Bound<'_, PyAny>>,
        couple: Option<&Bound<'_, PyAny>>,
        points: usize,
    ) -> PyResult<Answer> {
        let usual = || loads::usual_bearing_orders(&self.engine);
        let orders = asked::rising(asked::orders(orders)?.unwrap_or_else(usual));
        let couple = couple.map(keys::number).transpose()?.unwrap_or_else(|| "zero".to_owned());
        let keywords = json!({ "orders": orders, "couple": couple, "points": points });
        let request = Request { couple: couple.parse().map_err(told)?, points, orders };
        let read = |path: &str| self.source.beside(path);
        let study = py.detach(|| OptimiseStudy::new(&self.engine, request, FileResolver::new(&read))).map_err(told)?;
        Ok(Answer::new(self.asked("optimise", &keywords), study))
    }

    /// What accuracy costs: the largest loads by orders, samples, intervals and fractions, each with error, guarantee and time.
    ///
    /// rod_ratios: λ in place of that of the layout, one or several. timing: measure the times.
    #[pyo3(signature = (rod_ratios=None, *, timing=true))]
    fn accuracy(&self, py: Python<'_>, rod_ratios: Option<&Bound<'_, PyAny>>, timing: bool) -> PyResult<Answer> {
        let ratios = asked::rod_ratios(rod_ratios)?;
        let keywords = json!({ "rod_ratios": written(&ratios), "timing": timing });
        let clock = if timing { Timing::On } else { Timing::Off };
        let study = py.detach(|| AccuracyStudy::new(&self.engine, &ratios, clock, &|_| ())).map_err(told)?;
        Ok(Answer::new(self.asked("accuracy", &keywords), study))
    }

    /// How the balance changes with one value of the layout, or with two; exact zeros where the value is an angle.
    ///
    /// A range is "0..180:10", "80..120:5 mm", or a tuple (from, to, step). `ranges` takes any keys of the layout:
    /// {"vee.bank_offset": "0..20:1 mm"}. firing_orders: judge the firing stars of these orders too.
    /// values: columns with values of any question beside each point, ["bearings.worst.force"], as `values` names them. An interrupt from the keyboard stops it.
    #[pyo3(signature = (ranges=None, *, bank_angle=None, pin_split=None, spacing=None, rod_ratio=None, balance_factor=None, speed=None,
                        orders=None, firing_orders=None, values=None))]
    #[expect(clippy::too_many_arguments, reason = "they are the keywords of Python")]
    fn sweep(
        &self,
        py: Python<'_>,
        ranges: Option<&Bound<'_, PyDict>>,
        bank_angle: Option<&Bound<'_, PyAny>>,
        pin_split: Option<&Bound<'_, PyAny>>,
        spacing: Option<&Bound<'_, PyAny>>,
        rod_ratio: Option<&Bound<'_, PyAny>>,
        balance_factor: Option<&Bound<'_, PyAny>>,
        speed: Option<&Bound<'_, PyAny>>,
        orders: Option<&Bound<'_, PyAny>>,
        firing_orders: Option<&Bound<'_, PyAny>>,
        values: Option<Vec<String>>,
    ) -> PyResult<Answer> {
        let short_cuts = [
            ("bank_angle", bank_angle),
            ("pin_split", pin_split),
            ("spacing", spacing),
            ("rod_ratio", rod_ratio),
            ("balance_factor", balance_factor),
            ("speed", speed),
        ];
        let ranges = questions::ranges(short_cuts, ranges)?;
        let (orders, firing) = (asked::orders(orders)?, asked::cycle_orders(firing_orders)?);
        let values = asked::value_names("values", &values.unwrap_or_default())?;
        let asked = self.asked("sweep", &ranges.keywords(orders.as_deref(), &firing, &values));
        let (source, orders) = (self.source.clone(), orders.unwrap_or_default());
        let question =
            interruptible(py, move |stop| questions::sweep(&source, &ranges, &orders, &firing, &values, stop))?;
        Ok(Answer::new(asked, question))
    }

    /// The report as one text.
    ///
    /// format: "markdown", "html", "latex", "typst" or "text". HTML and LaTeX hold their pictures; of Markdown and Typst the pictures are
    /// files beside it, which `report_files` gives too.
    /// language: "en", or the code of another list of words: "de".
    #[pyo3(signature = (format="markdown", *, orders=None, language="en"))]
    fn report(
        &self,
        py: Python<'_>,
        format: &str,
        orders: Option<&Bound<'_, PyAny>>,
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
        orders: Option<&Bound<'_, PyAny>>,
        language: &str,
    ) -> PyResult<Vec<(String, String)>> {
        let (format, options) = (pages::format(format)?, pages::options(language)?);
        let orders = asked::orders(orders)?;
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
            pages::figure(&self.page(&asked::rising(orders), false)?, name)
        })
    }

    fn _repr_html_(&self, py: Python<'_>) -> PyResult<String> {
        py.detach(|| Ok(notebook::html(&self.glance()?)))
    }

    fn _repr_latex_(&self, py: Python<'_>) -> PyResult<String> {
        Ok(verdicts::latex(&self.classify(py, None, None, false, false)?.verdicts))
    }
}
