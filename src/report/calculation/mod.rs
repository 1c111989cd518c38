//! How are the numbers of an engine shown, so that a reader can work them out again? A calculation report.

mod amounts;
mod expression;
mod summary;

pub use summary::{Rows, loads_lines, loads_rows};
