//! How is a remedy shown? What cancels what, a table of weights, what counterweights alone do, the JSON document.

mod alone;
mod data;
mod document;
mod page;
mod ranked;
mod weights;
mod words;

pub use document::{remedy_document, remedy_engine};
pub use page::{remedy_answer, remedy_page, remedy_section};
pub use words::remedy_cures;

use super::question::Question;
use crate::page::Document;
use crate::remedy::Remedy;
use crate::table::Table;
use crate::text::Untrusted;

impl Question for Remedy {
    fn command(&self) -> &'static str {
        "remedy"
    }

    fn title(&self) -> Option<&Untrusted> {
        Some(self.subject.engine().title())
    }

    fn table(&self, name: &str) -> Option<Table> {
        match name {
            "weights" => Some(data::table(self)),
            "cures" => Some(data::cures(self)),
            _ => None,
        }
    }

    fn answer(&self) -> Document {
        remedy_answer(self)
    }

    fn page(&self) -> Document {
        remedy_page(self)
    }

    fn json(&self) -> serde_json::Result<String> {
        serde_json::to_string_pretty(&remedy_document(self))
    }

    fn is_certified(&self) -> bool {
        true
    }
}
