//! How is a sweep shown? A table with a row a point, a document, and a page with curves or maps.

mod amounts;
mod assumptions;
mod csv;
mod document;
mod findings;
mod firing;
mod page;
mod plots;
mod question;
mod sentences;
mod tables;
mod words;

pub use csv::sweep_csv;
pub use document::{SweepDocument, sweep_document};
pub use page::{sweep_answer, sweep_page};
