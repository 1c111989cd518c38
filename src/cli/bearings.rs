//! `bearings`: what do the main bearings feel?

use crankstar::file::Layout;
use crankstar::loads::{Method, bearing_loads};
use crankstar::report;

use super::failure::Failure;
use super::pages::Pages;
use super::{EngineAndOrders, print_json};

/// Arguments of `bearings`.
#[derive(clap::Args)]
pub struct Bearings {
    #[command(flatten)]
    about: EngineAndOrders,
    /// Print the loads as JSON
    #[arg(long, conflicts_with = "output")]
    json: bool,
    #[command(flatten)]
    pages: Pages,
}

impl Bearings {
    /// Prints the loads, and writes the page into the folder.
    pub fn run(&self) -> Result<(), Failure> {
        let (layout, orders) = self.about.read_for_bearings()?;
        let Layout::Known(engine, _) = layout else {
            return Err(Failure::new("bearing loads need an engine without unknowns; give them values below [values]"));
        };
        let solve = |method| bearing_loads(&engine, &orders, method).map_err(Failure::new);
        let (continuous, determinate) = (solve(Method::Continuous)?, solve(Method::Determinate)?);
        if self.json {
            return print_json(&report::bearings_document(&engine, &continuous, &determinate));
        }
        let answer = report::bearings_answer(&engine, &continuous, &determinate);
        self.pages.show(&answer, || report::bearings_page(&engine, &continuous, &determinate))
    }
}
