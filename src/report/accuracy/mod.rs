//! How is what accuracy costs shown? Each load by all methods: tables, plots, a section of a report, pages.

mod case;
mod data;
mod further;
pub(super) mod methods;
mod page;
mod plots;
mod study;
mod tables;
mod words;

pub use case::AccuracyCase;
pub use further::{Further, FurtherLoad};
pub use page::{accuracy_answer, accuracy_page, accuracy_section};
pub use study::AccuracyStudy;

use super::question::Question;
use crate::page::Document;
use crate::table::Table;
use crate::text::Untrusted;

impl Question for AccuracyStudy {
    fn command(&self) -> &'static str {
        "accuracy"
    }

    fn title(&self) -> Option<&Untrusted> {
        Some(self.engine.title())
    }

    fn table(&self, name: &str) -> Option<Table> {
        data::table(self, name)
    }

    fn answer(&self) -> Document {
        accuracy_answer(&self.engine, &self.cases)
    }

    fn page(&self) -> Document {
        accuracy_page(&self.engine, &self.cases)
    }
}
