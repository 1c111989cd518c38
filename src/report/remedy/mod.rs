//! How is a remedy shown? A table of weights, lines of plain text, the section of a report, the JSON document.

mod document;
mod rows;
mod section;
mod words;

pub use document::{remedy_document, remedy_engine};
pub use rows::{remedy_lines, remedy_rows};
pub use section::{remedy_figure, remedy_files, remedy_section};
