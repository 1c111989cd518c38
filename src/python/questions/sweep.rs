//! `sweep`: how does the balance change with a value of the layout?

use std::collections::BTreeSet;

use pyo3::prelude::*;

use crate::engine::CycleOrder;
use crate::file::{Beside, Template};
use crate::page::Document;
use crate::python::answer::Answer;
use crate::python::error::{self, told};
use crate::python::reading::Source;
use crate::report::{self, Question};
use crate::report::data;
use crate::sweep::{self, Geometry, Parameter, Sweep};
use crate::table::Table;

/// The values that are swept: flags of the command line and keys of the file, each with its range.
pub(in crate::python) struct Ranges {
    /// `bank-angle`, …
    pub flags: Vec<(&'static str, String)>,
    /// `vee.bank_offset`, …
    pub keys: Vec<(String, String)>,
}

struct Swept(Sweep);

/// Sweeps the layout of an engine.
pub(in crate::python) fn sweep(
    source: &Source,
    ranges: &Ranges,
    orders: &[u32],
    firing: &[CycleOrder],
) -> PyResult<Answer> {
    let read = |path: &str| source.beside(path);
    let template = Template::new(&source.name, &source.text).map_err(|error| error::layout(&error))?;
    let template = template.with_beside(Beside::new(&read));
    let flags = ranges.flags.iter().map(|(flag, range)| Parameter::short_cut(flag, range, &template));
    let keys = ranges.keys.iter().map(|(key, range)| Parameter::parse(&format!("{key}={range}")));
    let parameters = flags.chain(keys).collect::<Result<Vec<_>, _>>().map_err(told)?;
    let mut sweep = sweep::sweep(&template, &parameters, orders, &Geometry::default()).map_err(told)?;
    if !firing.is_empty() {
        let firing: Vec<CycleOrder> = firing.iter().copied().collect::<BTreeSet<_>>().into_iter().collect();
        sweep.firing = Some(sweep::firing_stars(&template, &sweep, &firing).map_err(told)?);
    }
    Ok(Answer::new(Swept(sweep)))
}

impl Question for Swept {
    fn command(&self) -> &'static str {
        "sweep"
    }

    fn title(&self) -> &str {
        self.0.title.written()
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
