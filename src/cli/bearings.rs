//! `bearings`: what do the main bearings feel?

use std::path::PathBuf;

use crankstar::file::Layout;
use crankstar::loads::{Method, bearing_loads};
use crankstar::report;

use super::failure::Failure;
use super::{EngineAndOrders, folder, print_json, terminal, write};

/// Arguments of `bearings`.
#[derive(clap::Args)]
pub struct Bearings {
    #[command(flatten)]
    about: EngineAndOrders,
    /// Print the loads as JSON
    #[arg(long, conflicts_with = "output")]
    json: bool,
    /// Folder for the page with its plots
    #[arg(long, value_name = "DIR")]
    output: Option<PathBuf>,
}

impl Bearings {
    /// Prints the loads, and writes the page into the folder.
    pub fn run(&self) -> Result<(), Failure> {
        let (layout, orders) = self.about.read()?;
        let Layout::Known(engine, _) = layout else {
            return Err(Failure::new("bearing loads need an engine without unknowns; give them values below [values]"));
        };
        let solve = |method| bearing_loads(&engine, &orders, method).map_err(Failure::new);
        let (continuous, determinate) = (solve(Method::Continuous)?, solve(Method::Determinate)?);
        if self.json {
            return print_json(&report::bearings_document(&engine, &continuous, &determinate));
        }
        let mut text = terminal::bearings(&engine, &continuous, &determinate);
        if let Some(folder) = &self.output {
            let files = report::bearings_page(&engine, &continuous, &determinate);
            folder::write(folder, &files)?;
            text += &format!("\n{}", folder::written(folder, &files));
        }
        write::to_stdout(&text)
    }
}
