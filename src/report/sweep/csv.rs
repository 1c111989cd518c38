//! What does the table of a sweep hold as a file? The points, a row each.

use super::data;
use crate::page::File;
use crate::sweep::Sweep;
use crate::table::csv;

/// The points as `sweep.csv`.
pub fn sweep_csv(sweep: &Sweep) -> File {
    File { name: "sweep.csv".into(), text: csv(&data::points(sweep)) }
}
