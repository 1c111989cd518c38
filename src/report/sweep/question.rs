//! What is a sweep as an answer? Tables of points and zeros, and a page with the data of its curves beside it.

use super::super::question::Question;
use super::data;
use super::{sweep_answer, sweep_csv, sweep_page};
use crate::page::{Document, File};
use crate::sweep::Sweep;
use crate::table::Table;
use crate::text::{self, Untrusted};

impl Question for Sweep {
    fn command(&self) -> &'static str {
        "sweep"
    }

    fn title(&self) -> Option<&Untrusted> {
        Some(&self.title)
    }

    fn table(&self, name: &str) -> Option<Table> {
        self.tables().into_iter().find(|table| table.name() == name)
    }

    fn tables(&self) -> Vec<Table> {
        data::tables(self)
    }

    fn answer(&self) -> Document {
        sweep_answer(self)
    }

    fn page(&self) -> Document {
        sweep_page(self)
    }

    /// The points, and all tables as JSON.
    fn beside(&self) -> serde_json::Result<Vec<File>> {
        Ok(vec![sweep_csv(self), File { name: "sweep.json".into(), text: text::json(&self.json()?) + "\n" }])
    }
}
