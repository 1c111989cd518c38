//! What is a firing study to whoever asks it? Its table, its document, its pages.

use super::super::question::Question;
use super::data;
use super::{FiringStudy, firing_answer, firing_document, firing_page};
use crate::page::Document;
use crate::table::Table;
use crate::text::Untrusted;

impl Question for FiringStudy {
    fn command(&self) -> &'static str {
        "firing"
    }

    fn title(&self) -> Option<&Untrusted> {
        Some(self.engine.title())
    }

    fn table(&self, name: &str) -> Option<Table> {
        (name == "orders").then(|| data::table(self))
    }

    fn answer(&self) -> Document {
        firing_answer(self)
    }

    fn page(&self) -> Document {
        firing_page(self)
    }

    fn is_certified(&self) -> bool {
        true
    }

    fn json(&self) -> serde_json::Result<String> {
        serde_json::to_string_pretty(&firing_document(self, false))
    }
}
