//! `bearings`: what do the main bearings feel?

use crankstar::file::Layout;
use crankstar::journal::cycle_loads;
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
        // What nobody asks for costs nothing.
        let complete = engine.effects().gas.then(|| cycle_loads(&engine));
        if self.json {
            let document = report::bearings_document(&engine, &continuous, &determinate);
            return print_json(&match &complete {
                Some(Ok(loads)) => document.with_gas(report::CycleLoadsDocument::new(&engine, loads)),
                Some(Err(_)) | None => document,
            });
        }
        let answer = || report::bearings_answer(&engine, &continuous, &determinate);
        let page = || report::bearings_page(&engine, &continuous, &determinate);
        match &complete {
            None => self.pages.show(&answer(), page),
            Some(Err(lack)) => {
                self.pages.show(&report::without_gas(answer(), lack), || report::without_gas(page(), lack))
            }
            Some(Ok(loads)) => self.pages.show(&report::complete_bearings_answer(&engine, loads), || {
                report::complete_bearings_page(&engine, loads, &continuous)
            }),
        }
    }
}
