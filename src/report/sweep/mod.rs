//! How is a sweep shown? A table with a row a point, a document, and a page with curves or maps.

mod csv;
mod document;
mod page;
mod plots;
mod study;
mod words;

pub use csv::sweep_csv;
pub use document::{SweepDocument, sweep_document};
pub use page::sweep_page;
pub use study::study_page;
