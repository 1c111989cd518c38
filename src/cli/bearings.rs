//! `bearings`: what do the main bearings feel?

use crankstar::file::Layout;
use crankstar::journal::cycle_loads;
use crankstar::loads::{Method, bearing_loads};
use crankstar::report::{self, data};

use super::answer::Answer;
use super::failure::Failure;
use super::{EngineAndOrders, json};

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
        let wanted = self.answer.wanted("bearings")?;
        let (layout, orders) = self.about.read_for_bearings()?;
        let Layout::Known(engine, _) = layout else {
            return Err(Failure::new("bearing loads need an engine without unknowns; give them values below [values]"));
        };
        let solve = |method| bearing_loads(&engine, &orders, method).map_err(Failure::new);
        let (continuous, determinate) = (solve(Method::Continuous)?, solve(Method::Determinate)?);
        // What nobody asks for costs nothing.
        let complete = engine.effects().gas.then(|| cycle_loads(&engine));
        let with_gas = complete.as_ref().and_then(|complete| complete.as_ref().ok());
        let document = || {
            let document = report::bearings_document(&engine, &continuous, &determinate);
            match with_gas {
                Some(loads) => document.with_gas(report::CycleLoadsDocument::new(&engine, loads)),
                None => document,
            }
        };
        if let Some(wanted) = wanted {
            return wanted.give(data::bearings(&engine, [&continuous, &determinate], &document(), with_gas));
        }
        if self.json || self.answer.is_json() {
            return self.answer.show_json("bearings", json(&document())?);
        }
        let answer = || report::bearings_answer(&engine, &continuous, &determinate);
        let page = || report::bearings_page(&engine, &continuous, &determinate);
        match &complete {
            None => self.answer.show(&answer(), page),
            Some(Err(lack)) => {
                self.answer.show(&report::without_gas(answer(), lack), || report::without_gas(page(), lack))
            }
            Some(Ok(loads)) => self.answer.show(&report::complete_bearings_answer(&engine, loads), || {
                report::complete_bearings_page(&engine, loads, &continuous)
            }),
        }
    }
}
