//! How are the best crankshafts shown? Tables, a plot, a page, a JSON document.

mod amounts;
mod document;
mod page;
mod tables;

pub use document::{OptimiseDocument, optimise_document};
pub use page::{optimise_files, optimise_lines, optimise_summary};
pub use tables::{optimise_compared, optimise_rows};
