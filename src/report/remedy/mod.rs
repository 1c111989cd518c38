//! How is a remedy shown? What cancels what, a table of weights, what counterweights alone do, the JSON document.

mod alone;
mod data;
mod document;
mod page;
mod question;
mod ranked;
mod weights;
mod words;

pub use document::{remedy_document, remedy_engine};
pub use page::{remedy_answer, remedy_page, remedy_section};
pub use words::remedy_cures;
