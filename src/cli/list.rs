//! `list`: which engines are known by name, and what does each leave first?

use crankstar::file;
use crankstar::page::Units;
use crankstar::report;

use super::failure::Failure;
use super::pages::shown;
use super::spoken::Spoken;
use super::write;

/// Arguments of `list`.
#[derive(clap::Args)]
pub struct List {
    #[command(flatten)]
    spoken: Spoken,
}

impl List {
    /// Prints the catalogue, a row per engine.
    pub fn run(&self) -> Result<(), Failure> {
        write::to_stdout(&shown(&report::catalogue_answer(&file::catalogue()?), self.spoken.language(), Units::Si))
    }
}
