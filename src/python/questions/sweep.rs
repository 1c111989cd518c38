//! `sweep`: how does the balance change with a value of the layout?

use std::sync::atomic::AtomicBool;

use pyo3::prelude::*;
use pyo3::types::PyDict;
use serde_json::{Map, Value, json};

use super::super::keys;
use crate::engine::CycleOrder;
use crate::file::{FileResolver, Template};
use crate::python::asked::written;
use crate::python::error::{self, told};
use crate::python::reading::Source;
use crate::report::{ValueName, observer};
use crate::sweep::{Geometry, Parameter, Stream, Sweep};

/// The values that are swept: keywords and keys of the file, each with its range.
pub(in crate::python) struct Ranges {
    /// `bank_angle`, …
    pub flags: Vec<(&'static str, String)>,
    /// `vee.bank_offset`, …
    pub keys: Vec<(String, String)>,
}

impl Ranges {
    /// All that a sweep is asked, as the keywords of Python.
    pub fn keywords(&self, orders: Option<&[u32]>, firing: &[CycleOrder], values: &[ValueName]) -> Value {
        let ranges: Map<String, Value> = self.keys.iter().map(|(key, range)| (key.clone(), json!(range))).collect();
        let mut keywords = Map::from_iter(self.flags.iter().map(|(name, range)| ((*name).to_owned(), json!(range))));
        keywords.insert("ranges".to_owned(), Value::Object(ranges));
        keywords.insert("orders".to_owned(), json!(orders));
        keywords.insert("firing_orders".to_owned(), json!(written(firing)));
        keywords.insert("values".to_owned(), json!(written(values)));
        Value::Object(keywords)
    }
}

/// Sweeps the layout of an engine.
pub(in crate::python) fn sweep(
    source: &Source,
    ranges: &Ranges,
    orders: &[u32],
    firing: &[CycleOrder],
    values: &[ValueName],
    stop: &AtomicBool,
) -> PyResult<Sweep> {
    let read = |path: &str| source.beside(path);
    let template = Template::new(&source.name, &source.text).map_err(|error| error::layout(&error))?;
    let template = template.with_beside(FileResolver::new(&read));
    let flags =
        ranges.flags.iter().map(|(flag, range)| Parameter::short_cut(&flag.replace('_', "-"), range, &template));
    let keys = ranges.keys.iter().map(|(key, range)| Parameter::parse(&format!("{key}={range}")));
    let parameters = flags.chain(keys).collect::<Result<Vec<_>, _>>().map_err(told)?;
    let stream = Stream::new(&template, &parameters, orders, firing, &Geometry::default());
    let stream = stream.and_then(|stream| stream.observing(observer(values)));
    stream.and_then(|stream| stream.whole(stop)).map_err(told)
}

/// The ranges of a sweep: those of the keywords that are given, and those of keys of the layout.
pub(in crate::python) fn ranges(
    flags: [(&'static str, Option<&Bound<'_, PyAny>>); 6],
    keys: Option<&Bound<'_, PyDict>>,
) -> PyResult<Ranges> {
    let flags = flags.into_iter().filter_map(|(flag, range)| Some((flag, range?)));
    let flags = flags.map(|(flag, range)| Ok((flag, keys::range(flag, range)?)));
    let keys = keys.into_iter().flat_map(|keys| keys.iter()).map(|(key, range)| {
        let key: String = key.extract()?;
        Ok((key.clone(), keys::range(&key, &range)?))
    });
    Ok(Ranges { flags: flags.collect::<PyResult<_>>()?, keys: keys.collect::<PyResult<_>>()? })
}
