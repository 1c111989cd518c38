//! How are the best crankshafts shown? Tables, a plot, a page with layout files beside it, a JSON document.

mod amounts;
mod document;
mod layouts;
mod page;
mod plot;
mod tables;

pub use document::{OptimiseDocument, optimise_document};
pub use layouts::optimise_layouts;
pub use page::{optimise_answer, optimise_page, optimise_summary};
