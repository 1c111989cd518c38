//! What do the main bearings feel, as a person reads it? Tables, plots, a page, a JSON document.

mod amounts;
pub(super) mod document;
mod page;
mod plots;
mod tables;

pub use document::{BearingsDocument, bearings_document};
pub(super) use page::{ASSUMPTIONS, answer, by_orders, left_out, parts_of_a_load, peaks_in_words, worst};
pub use page::{bearings_answer, bearings_page};
pub(super) use plots::drawings;
pub(super) use tables::{before, orders, peaks};
