//! `torque`: which torque does the engine give, and which flywheel does it need?

use std::path::PathBuf;

use crankstar::file::Layout;
use crankstar::report;
use crankstar::torque::torque;

use super::failure::Failure;
use super::pages::Pages;
use super::{layouts, print_json};

/// Arguments of `torque`.
#[derive(clap::Args)]
pub struct Torque {
    /// The path of a layout file with [gas]
    layout: PathBuf,
    /// Print the torque as JSON
    #[arg(long, conflicts_with = "output")]
    json: bool,
    #[command(flatten)]
    pages: Pages,
}

impl Torque {
    /// Prints the answer, and writes the page into the folder.
    pub fn run(&self) -> Result<(), Failure> {
        let Layout::Known(engine, _) = layouts::read(&self.layout)? else {
            return Err(Failure::new("the torque needs an engine without unknowns; give them values below [values]"));
        };
        let torque = torque(&engine).map_err(Failure::new)?;
        if self.json {
            return print_json(&report::torque_document(&engine, &torque));
        }
        let answer = report::torque_answer(&engine, &torque);
        self.pages.show(&answer, || report::torque_page(&engine, &torque))
    }
}
