//! Which columns hold the answer to each question? Tables of the same values that pages and documents show.
//!
//! A question has one table or several, the main one first. `docs/data.md` lists every column of every table, which a test holds it to.
//! Amplitudes are zero to peak. Where a number is proved to be 0 it is 0, and the column beside it that ends in `vanishes` is true.

mod cells;
mod search;
mod sweep;

pub use cells::exact_number;
pub use search::search;
pub use sweep::{points as sweep_points, sweep};
