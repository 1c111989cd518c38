//! `list`: which engines are known by name, and what does each leave first?

use crankstar::file;
use crankstar::report;

use super::failure::Failure;
use super::{pages, write};

/// Prints the catalogue, a row per engine.
pub fn run() -> Result<(), Failure> {
    write::to_stdout(&pages::shown(&report::catalogue_answer(&file::catalogue()?)))
}
