//! `torque`: which torque does the engine give, and which flywheel does it need?

use std::path::PathBuf;

use crankstar::report::TorqueStudy;

use super::answer::Answer;
use super::failure::Failure;
use super::layouts;

/// Arguments of `torque`.
#[derive(clap::Args)]
pub struct Torque {
    /// The path of a layout file with [gas]
    layout: PathBuf,
    /// The name of a cylinder that does not fire
    #[arg(long, value_name = "CYLINDER")]
    misfire: Option<String>,
    /// Print the torque as JSON
    #[arg(long, conflicts_with_all = ["output", "format"])]
    json: bool,
    #[command(flatten)]
    answer: Answer,
}

impl Torque {
    /// Prints the answer, and writes the page into the folder.
    pub fn run(&self) -> Result<(), Failure> {
        self.answer.give("torque", self.json, || {
            let engine = layouts::firing(&self.layout, "the torque needs", self.misfire.as_deref())?;
            TorqueStudy::new(&engine).map_err(Failure::new)
        })
    }
}
