//! `flywheel`: which flywheel does a turning-moment diagram need?

use std::path::PathBuf;

use crankstar::file::{self, parse_diagram};
use crankstar::report::FlywheelStudy;

use super::answer::Answer;
use super::failure::Failure;
use super::layouts;

/// Arguments of `flywheel`.
#[derive(clap::Args)]
pub struct Flywheel {
    /// The path of a file with a turning-moment diagram
    file: PathBuf,
    /// Print the values as JSON
    #[arg(long, conflicts_with_all = ["output", "format"])]
    json: bool,
    #[command(flatten)]
    answer: Answer,
}

impl Flywheel {
    /// Prints the answer, and writes the page into the folder.
    pub fn run(&self) -> Result<(), Failure> {
        self.answer.give("flywheel", self.json, || {
            let text = layouts::read_text(&self.file)?;
            let name = layouts::shown(&self.file);
            let diagram = parse_diagram(&name, &text)?;
            layouts::warn(file::warnings_of_values(&name, &text));
            FlywheelStudy::new(diagram).map_err(Failure::new)
        })
    }
}
