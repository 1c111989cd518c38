//! How is what accuracy costs shown? Each load by all methods: tables, plots, a section of a report, pages, a JSON document.

mod bearings;
mod case;
mod document;
mod engine_torque;
mod gas_bearings;
mod methods;
mod page;
mod plots;
mod tables;
mod words;

pub use case::AccuracyCase;
pub use document::{AccuracyDocument, accuracy_document};
pub use page::{accuracy_answer, accuracy_page, accuracy_section};
