//! `bearings`: what do the main bearings feel?

use crankstar::report::BearingsStudy;

use super::answer::Answer;
use super::failure::Failure;
use super::layouts::without_unknowns;
use super::orders::EngineAndOrders;

/// Arguments of `bearings`.
#[derive(clap::Args)]
pub struct Bearings {
    #[command(flatten)]
    about: EngineAndOrders,
    /// Print the loads as JSON
    #[arg(long, conflicts_with_all = ["output", "format"])]
    json: bool,
    #[command(flatten)]
    answer: Answer,
}

impl Bearings {
    /// Prints the loads, and writes the page into the folder.
    pub fn run(&self) -> Result<(), Failure> {
        self.answer.give("bearings", self.json, || {
            let (layout, orders) = self.about.read_for_bearings()?;
            let engine = without_unknowns(layout, "bearing loads need")?;
            BearingsStudy::new(&engine, &orders).map_err(Failure::new)
        })
    }
}
