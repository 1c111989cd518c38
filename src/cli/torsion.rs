//! `torsion`: at which speeds does the crankshaft twist?

use std::path::PathBuf;

use crankstar::engine::CycleOrder;
use crankstar::report::TorsionStudy;

use super::answer::Answer;
use super::failure::Failure;
use super::layouts;

/// Arguments of `torsion`.
#[derive(clap::Args)]
pub struct Torsion {
    /// A name of the catalogue, or the path of a layout file with a table [torsion]
    layout: PathBuf,
    /// The orders whose critical speeds are shown, such as 1/2,1,3/2 [default: up to 12]
    #[arg(long, value_delimiter = ',')]
    orders: Vec<CycleOrder>,
    /// Print modes and critical speeds as JSON
    #[arg(long, conflicts_with_all = ["output", "format"])]
    json: bool,
    #[command(flatten)]
    answer: Answer,
}

impl Torsion {
    /// Prints the critical speeds, and writes the page into the folder.
    pub fn run(&self) -> Result<(), Failure> {
        self.answer.give("torsion", self.json, || {
            let engine = layouts::known(&self.layout, "a torsional model needs")?;
            TorsionStudy::new(&engine, &self.orders).map_err(Failure::new)
        })
    }
}
