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

use super::question::question;
use crate::remedy::Remedy;

question!(Remedy, "remedy", |remedy| Some(remedy.subject.engine().title()), data::table, remedy_answer, remedy_page, {
    fn is_certified(&self) -> bool {
        true
    }

    fn json(&self) -> serde_json::Result<String> {
        serde_json::to_string_pretty(&remedy_document(self))
    }
});
