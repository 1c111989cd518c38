//! Which columns hold the answer to each question? Tables of the same values that pages and documents show.
//!
//! A question has one table or several, the main one first. `docs/data.md` lists every column of every table, which a test holds it to.
//! Amplitudes are zero to peak. Where a number is proved to be 0 it is 0, and the column beside it that ends in `vanishes` is true.

mod cells;
mod classify;
mod filling;
mod sentences;
mod values;
mod verdicts;

pub use super::compare::data::tables as compare;
pub use super::search::data::tables as search;
pub use super::sweep::data::points as sweep_points;
pub use cells::exact_number;
pub use classify::classify;
pub(super) use filling::{Filling, Name};
pub use sentences::TABLES;
pub(super) use values::{columns as value_columns, fitting};
pub(super) use verdicts::{of_orders, units};

/// The names of the tables of a question, the main one first; none where it has none.
pub fn tables_of(question: &str) -> &'static [&'static str] {
    TABLES.iter().find(|(name, _)| *name == question).map_or(&[], |(_, tables)| tables)
}
