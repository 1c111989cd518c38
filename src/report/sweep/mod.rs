//! How is a sweep shown? A table with one row per point, and a page with curves or maps.

mod amounts;
pub(super) mod data;
mod findings;
mod firing;
mod observed;
mod page;
mod plots;
mod question;
mod sentences;
mod tables;
mod zero_data;

pub use data::sweep_csv;
pub use page::{sweep_answer, sweep_page};
