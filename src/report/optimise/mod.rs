//! How are the best crankshafts shown? Tables, a plot, a page with layout files beside it.

mod amounts;
mod data;
mod layouts;
mod page;
mod plot;
mod study;
mod tables;

pub use layouts::optimise_layouts;
pub use page::{optimise_answer, optimise_page};
pub use study::OptimiseStudy;

use super::question::Question;
use crate::page::{Document, File};
use crate::table::Table;
use crate::text::Untrusted;

impl Question for OptimiseStudy {
    fn command(&self) -> &'static str {
        "optimise"
    }

    fn title(&self) -> Option<&Untrusted> {
        Some(self.engine.title())
    }

    fn table(&self, name: &str) -> Option<Table> {
        data::table(self, name)
    }

    fn answer(&self) -> Document {
        optimise_answer(&self.engine, &self.front, &self.couple)
    }

    fn page(&self) -> Document {
        optimise_page(&self.engine, &self.front, &self.couple)
    }

    /// The layout files of the points, and what they name.
    fn beside(&self) -> serde_json::Result<Vec<File>> {
        Ok(optimise_layouts(&self.front).into_iter().chain(self.files.iter().cloned()).collect())
    }
}
