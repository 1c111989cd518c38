//! What is asked of several engines, or of none: a comparison, values, the catalogue, a search, a document to be checked?

use std::collections::BTreeMap;
use std::path::PathBuf;

use pyo3::prelude::*;
use pyo3::types::{PyBytes, PyDict, PyString};
use serde_json::json;

use super::again::Asked;
use super::answer::Answer;
use super::asked::{in_turns, written};
use super::engine::Engine;
use super::error::told;
use super::interrupt::interruptible;
use super::questions::{self, Checked};
use super::{asked, error, keys};
use crate::file;
use crate::report::{CompareStudy, Compared, FlywheelStudy, MomentsStudy, RotorStudy, Valued, ValuesStudy};
use crate::search::{Limit, Problem, Sizes};

/// The names of the engines that are known, as `Engine.named` takes them.
#[pyfunction]
pub(super) fn catalogue() -> PyResult<Vec<&'static str>> {
    let engines = file::catalogue().map_err(|error| error::layout(&error))?;
    Ok(engines.iter().map(|(entry, _)| entry.name).collect())
}

/// Checks a document that `classify`, `remedy`, `loads` or `firing` gave: every certificate in it, and that it says nothing else.
///
/// document: a str or bytes of JSON, or the dict of `document()`. Tells what was checked.
///
/// Raises ProofError with the place of what does not hold.
#[pyfunction]
pub(super) fn verify(py: Python<'_>, document: &Bound<'_, PyAny>) -> PyResult<Checked> {
    let json: Vec<u8> = if let Ok(text) = document.cast::<PyString>() {
        text.to_str()?.as_bytes().to_vec()
    } else if let Ok(bytes) = document.cast::<PyBytes>() {
        bytes.as_bytes().to_vec()
    } else {
        let text = py.import("json")?.call_method1("dumps", (document,))?;
        text.extract::<String>()?.into_bytes()
    };
    py.detach(|| questions::verify(&json))
}

/// The program: answers a command line, whose first word is the name of the program, and returns the exit status.
#[cfg(feature = "cli")]
#[pyfunction]
pub(super) fn _program(py: Python<'_>, arguments: Vec<std::ffi::OsString>) -> u8 {
    py.detach(|| {
        let status = crate::cli::run(arguments.into_iter());
        // Python ends without what Rust does at the end of `main`.
        let _ = std::io::Write::flush(&mut std::io::stdout());
        status
    })
}

/// The crank stars that balance best: the exact front of all of them, up to their symmetries.
///
/// cylinders: their number. cycle: "two-stroke" or "four-stroke". orders: those whose moments are compared, 1 and 2 where omitted.
/// bank_angle: a V of this many degrees, on shared pins unless pin_split parts them, with this many directions of its pins; an engine in line where omitted.
/// grid: throws at any multiples of 1/grid turn. neighbours: count neighbours that fire in succession.
/// pin_split: the pin of bank 2 is this many degrees ahead. bank_offset: bank 1 is this many spacings towards the free end of bank 2.
/// minor_orders: compare firing orders too, by these orders of a mode of torsional vibration, `mode_shape` or one that falls evenly.
/// torsion: list the firing orders of each star in that mode.
/// limits: the stars whose moments are no larger, {2: 1.5} in m r ω² c a, or {2: "30 kN m"}; sizes: an engine in line that gives newton-metres.
/// resume: a file that keeps finished pieces. threads: one per core where omitted. An interrupt from the keyboard stops it.
#[pyfunction]
#[pyo3(signature = (cylinders, cycle, *, orders=None, bank_angle=None, directions=None, grid=None, neighbours=false, pin_split=None,
                    bank_offset=None, minor_orders=None, torsion=false, mode_shape=None, limits=None, sizes=None, resume=None,
                    threads=None))]
#[expect(clippy::too_many_arguments, reason = "they are the keywords of Python")]
pub(super) fn search(
    py: Python<'_>,
    cylinders: u32,
    cycle: &str,
    orders: Option<&Bound<'_, PyAny>>,
    bank_angle: Option<&Bound<'_, PyAny>>,
    directions: Option<u32>,
    grid: Option<u32>,
    neighbours: bool,
    pin_split: Option<&Bound<'_, PyAny>>,
    bank_offset: Option<&Bound<'_, PyAny>>,
    minor_orders: Option<&Bound<'_, PyAny>>,
    torsion: bool,
    mode_shape: Option<&Bound<'_, PyAny>>,
    limits: Option<&Bound<'_, PyDict>>,
    sizes: Option<PyRef<'_, Engine>>,
    resume: Option<PathBuf>,
    threads: Option<u16>,
) -> PyResult<Answer> {
    let bank_angle = bank_angle.map(|angle| asked::bank_angle(&keys::number(angle)?)).transpose()?;
    let pin_split = pin_split.map(|angle| asked::angle("pin_split", &keys::number(angle)?)).transpose()?;
    let bank_offset = bank_offset.map(|length| asked::exact("bank_offset", &keys::number(length)?)).transpose()?;
    let minor_orders = asked::rising(asked::cycle_orders(minor_orders)?);
    let shape = asked::deflections(mode_shape)?;
    if shape.is_some() && !torsion && minor_orders.is_empty() {
        return Err(error::told(
            "mode_shape weighs the firing stars of firing orders; give torsion=True or minor_orders",
        ));
    }
    let limits = asked::limits(limits)?;
    let (cycle_name, cycle) = (cycle, asked::cycle(cycle)?);
    let orders = asked::rising(asked::orders(orders)?.unwrap_or_else(|| vec![1, 2]));
    let mode_shape = shape.clone();
    let [bank_angle_text, pin_split_text] = [&bank_angle, &pin_split].map(|angle| angle.as_ref().map(in_turns));
    let asked = Problem {
        bank_angle,
        directions,
        grid,
        neighbours,
        pin_split,
        bank_offset,
        ..Problem::inline(cylinders, cycle, &orders)
    };
    let problem = Problem { minor_orders, mode_shape, ..asked };
    let keywords = json!({
        "cylinders": cylinders,
        "cycle": cycle_name,
        "orders": orders,
        "bank_angle": bank_angle_text,
        "directions": directions,
        "grid": grid,
        "neighbours": neighbours,
        "pin_split": pin_split_text,
        "bank_offset": problem.bank_offset.as_ref().map(ToString::to_string),
        "minor_orders": written(&problem.minor_orders),
        "torsion": torsion,
        "mode_shape": shape.as_deref().map(written),
        "limits": limits.iter().map(Limit::parts).collect::<BTreeMap<_, _>>(),
    });
    let torsion = torsion.then_some(shape);
    let source = sizes.as_ref().map(|engine| engine.source.clone());
    let sizes = sizes.map(|engine| Sizes::new(&engine.engine)).transpose().map_err(told)?;
    let wanted = questions::StarRequest { torsion, limits, sizes };
    let question = interruptible(py, move |stop| questions::search(&problem, wanted, resume, threads, stop))?;
    Ok(Answer::new(Asked::function("search", source.into_iter().collect(), &keywords), question))
}

/// Engines side by side: what each leaves by order, remedy, firing, main bearings. They are called by their titles.
///
/// orders: those of the layouts and the usual ones where omitted. values: names of values of any question, shown beside them, as `values` takes them.
#[pyfunction]
#[pyo3(signature = (engines, orders=None, *, values=None))]
pub(super) fn compare(
    py: Python<'_>,
    engines: Vec<PyRef<'_, Engine>>,
    orders: Option<&Bound<'_, PyAny>>,
    values: Option<Vec<String>>,
) -> PyResult<Answer> {
    if engines.len() < 2 {
        return Err(error::told("engines: two or more are compared"));
    }
    let usual = || engines.iter().flat_map(|engine| engine.orders(None)).collect();
    let orders = asked::rising(asked::orders(orders)?.unwrap_or_else(usual));
    let sources = engines.iter().map(|engine| engine.source.clone()).collect();
    let engines: Vec<crate::engine::Engine> = engines.iter().map(|engine| engine.engine.clone()).collect();
    let names = values.unwrap_or_default();
    let values = asked::value_names("values", &names)?;
    let asked = Asked::function("compare", sources, &json!({ "orders": orders, "values": names }));
    let study = py.detach(|| {
        let compared = engines.iter().map(|engine| Compared::new(engine.title().clone(), engine, &orders));
        let compared = compared.collect::<Result<_, _>>().map_err(told)?;
        let values = ValuesStudy::beside(engines.iter().map(|engine| (engine.title().clone(), engine)), &values);
        Ok::<_, PyErr>(CompareStudy { engines: compared, values })
    })?;
    Ok(Answer::new(asked, study))
}

/// External moments and guide-force moments of engines side by side, as a maker's project guide lists them, in kN·m.
#[pyfunction]
pub(super) fn moments(py: Python<'_>, engines: Vec<PyRef<'_, Engine>>) -> PyResult<Answer> {
    let sources = engines.iter().map(|engine| engine.source.clone()).collect();
    let named: Vec<_> = engines.iter().map(|one| (one.engine.title().clone(), one.engine.clone())).collect();
    let study = py.detach(|| MomentsStudy::new(&named)).map_err(told)?;
    Ok(Answer::new(Asked::function("moments", sources, &json!({})), study))
}

/// The masses that balance a shaft, exactly, or the reason why none do.
///
/// text: a file of [[mass]] tables, as `crankstar rotor` reads it; what it omits is found.
#[pyfunction]
pub(super) fn rotor(py: Python<'_>, text: String) -> PyResult<Answer> {
    let asked = Asked::function("rotor", Vec::new(), &json!({ "text": text }));
    let shaft = file::parse_rotor("shaft.toml", &text).map_err(|error| error::layout(&error))?;
    Ok(Answer::new(asked, py.detach(|| RotorStudy::new(shaft)).map_err(told)?))
}

/// The fluctuation of energy of a turning-moment diagram, and its flywheel.
///
/// text: a file with the diagram, as `crankstar flywheel` reads it.
#[pyfunction]
pub(super) fn flywheel(py: Python<'_>, text: String) -> PyResult<Answer> {
    let asked = Asked::function("flywheel", Vec::new(), &json!({ "text": text }));
    let diagram = file::parse_diagram("diagram.toml", &text).map_err(|error| error::layout(&error))?;
    Ok(Answer::new(asked, py.detach(|| FlywheelStudy::new(diagram)).map_err(told)?))
}

/// Any values of any question, by their names, for each engine: a column each, and one that says why an engine has none.
///
/// names: such as ["bearings.worst.force", "torsion.modes.1.frequency"]: question, table, the keys of a row, column; docs/data.md lists them.
/// files: texts of shafts and turning-moment diagrams, as `rotor` and `flywheel` take them; their rows follow those of the engines.
#[pyfunction]
#[pyo3(signature = (engines, names, *, files=None))]
pub(super) fn values(
    py: Python<'_>,
    engines: Vec<PyRef<'_, Engine>>,
    names: Vec<String>,
    files: Option<Vec<String>>,
) -> PyResult<Answer> {
    let files = files.unwrap_or_default();
    let values = asked::value_names("names", &names)?;
    let sources = engines.iter().map(|engine| engine.source.clone()).collect();
    let engines: Vec<crate::engine::Engine> = engines.iter().map(|engine| engine.engine.clone()).collect();
    let mut keywords = json!({ "names": names, "files": files });
    if engines.is_empty() {
        keywords["engines"] = json!([]);
    }
    let asked = Asked::function("values", sources, &keywords);
    let of_file = |text: &String| match Valued::of_file("file.toml", text).map_err(told)? {
        Some(Valued::File(study)) => Ok(Valued::File(study)),
        Some(Valued::Engine(_)) | None => Err(told("files: neither masses on a shaft nor a turning-moment diagram")),
    };
    let rows = py.detach(|| {
        let of_engines = engines.iter().map(|engine| Ok(Valued::Engine(engine)));
        let all = of_engines.chain(files.iter().map(of_file));
        all.map(|one| one.map(|one| (one.title(), one.values(&values)))).collect::<PyResult<Vec<_>>>()
    })?;
    Ok(Answer::new(asked, ValuesStudy { names: values, rows }))
}
