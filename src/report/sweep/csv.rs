//! What does the table of a sweep hold as a file? The points, a row each.

use super::super::data;
use crate::page::File;
use crate::sweep::Sweep;
use crate::table::csv;

/// Digits of the tables of a study, which are to be the same on every machine.
const DIGITS: usize = 10;

/// The points as `sweep.csv`.
pub fn sweep_csv(sweep: &Sweep) -> File {
    File { name: "sweep.csv".into(), text: csv(&data::sweep_points(sweep)) }
}

/// The same of ten digits: a table that is kept.
pub(super) fn kept_csv(sweep: &Sweep) -> String {
    csv(&data::sweep_points(sweep).rounded(DIGITS))
}
