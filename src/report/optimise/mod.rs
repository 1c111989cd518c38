//! How are the best crankshafts shown? Tables, a plot, a page with layout files beside it.

mod amounts;
mod data;
mod layouts;
mod page;
mod plot;
mod study;
mod tables;

pub use layouts::optimise_layouts;
pub use page::{optimise_answer, optimise_page};
pub use study::OptimiseStudy;
