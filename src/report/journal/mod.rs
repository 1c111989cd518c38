//! What do rods, crankpins and main bearings feel of gas and masses together, as a person reads it? A page, tables, diagrams.

mod page;
mod plots;
mod tables;
mod words;

pub use page::{complete_bearings_answer, complete_bearings_page, without_gas};
