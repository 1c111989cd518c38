//! `sweep`: how does the balance change with a value of the layout?

use std::collections::BTreeSet;
use std::sync::atomic::AtomicBool;

use pyo3::prelude::*;
use serde_json::{Map, Value, json};

use crate::engine::CycleOrder;
use crate::file::{Beside, Template};
use crate::page::Document;
use crate::python::asked::written;
use crate::python::error::{self, told};
use crate::python::reading::Source;
use crate::report::data;
use crate::report::{self, Question};
use crate::sweep::{self, Geometry, Parameter, Sweep};
use crate::table::Table;
use crate::text::Untrusted;

/// The values that are swept: keywords and keys of the file, each with its range.
pub(in crate::python) struct Ranges {
    /// `bank_angle`, …
    pub flags: Vec<(&'static str, String)>,
    /// `vee.bank_offset`, …
    pub keys: Vec<(String, String)>,
}

impl Ranges {
    /// All that a sweep is asked, as the keywords of Python.
    pub fn keywords(&self, orders: Option<&[u32]>, firing: &[CycleOrder]) -> Value {
        let ranges: Map<String, Value> = self.keys.iter().map(|(key, range)| (key.clone(), json!(range))).collect();
        let mut keywords = Map::from_iter(self.flags.iter().map(|(name, range)| ((*name).to_owned(), json!(range))));
        keywords.insert("ranges".to_owned(), Value::Object(ranges));
        keywords.insert("orders".to_owned(), json!(orders));
        keywords.insert("firing_orders".to_owned(), json!(written(firing)));
        Value::Object(keywords)
    }
}

struct Swept(Sweep);

/// Sweeps the layout of an engine.
pub(in crate::python) fn sweep(
    source: &Source,
    ranges: &Ranges,
    orders: &[u32],
    firing: &[CycleOrder],
    stop: &AtomicBool,
) -> PyResult<impl Question + use<>> {
    let read = |path: &str| source.beside(path);
    let template = Template::new(&source.name, &source.text).map_err(|error| error::layout(&error))?;
    let template = template.with_beside(Beside::new(&read));
    let flags =
        ranges.flags.iter().map(|(flag, range)| Parameter::short_cut(&flag.replace('_', "-"), range, &template));
    let keys = ranges.keys.iter().map(|(key, range)| Parameter::parse(&format!("{key}={range}")));
    let parameters = flags.chain(keys).collect::<Result<Vec<_>, _>>().map_err(told)?;
    let mut sweep = sweep::sweep_until(&template, &parameters, orders, &Geometry::default(), stop).map_err(told)?;
    if !firing.is_empty() {
        let firing: Vec<CycleOrder> = firing.iter().copied().collect::<BTreeSet<_>>().into_iter().collect();
        sweep.firing = Some(sweep::firing_stars(&template, &sweep, &firing).map_err(told)?);
    }
    Ok(Swept(sweep))
}

impl Question for Swept {
    fn command(&self) -> &'static str {
        "sweep"
    }

    fn title(&self) -> Option<&Untrusted> {
        Some(&self.0.title)
    }

    fn table(&self, name: &str) -> Option<Table> {
        self.tables().into_iter().find(|table| table.name() == name)
    }

    fn tables(&self) -> Vec<Table> {
        data::sweep(&self.0)
    }

    fn json(&self) -> serde_json::Result<String> {
        serde_json::to_string_pretty(&report::sweep_document(&self.0))
    }

    fn answer(&self) -> Document {
        report::sweep_answer(&self.0)
    }

    fn page(&self) -> Document {
        report::sweep_page(&self.0)
    }
}
