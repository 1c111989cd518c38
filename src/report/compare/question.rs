//! What is a comparison as an answer? The engines, judged at the same orders.

use super::super::question::Question;
use super::data;
use super::{CompareDocument, Compared, compare_answer, compare_document, compare_page};
use crate::page::Document;
use crate::table::Table;
use crate::text::Untrusted;

/// Engines side by side.
pub struct CompareStudy {
    /// The engines.
    pub engines: Vec<Compared>,
}

impl CompareStudy {
    fn document(&self) -> CompareDocument {
        compare_document(&self.engines)
    }
}

impl Question for CompareStudy {
    fn command(&self) -> &'static str {
        "compare"
    }

    fn title(&self) -> Option<&Untrusted> {
        None
    }

    fn table(&self, name: &str) -> Option<Table> {
        self.tables().into_iter().find(|table| table.name() == name)
    }

    fn tables(&self) -> Vec<Table> {
        data::tables(&self.engines)
    }

    fn answer(&self) -> Document {
        compare_answer(&self.engines)
    }

    fn page(&self) -> Document {
        compare_page(&self.engines)
    }

    fn json(&self) -> serde_json::Result<String> {
        serde_json::to_string_pretty(&self.document())
    }

    fn is_certified(&self) -> bool {
        true
    }

    fn json_without_evidence(&self) -> Option<serde_json::Result<String>> {
        Some(serde_json::to_string_pretty(&self.document().without_evidence()))
    }
}
