//! `flywheel`: which flywheel does a turning-moment diagram need?

use std::path::PathBuf;

use crankstar::file::parse_diagram;
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
            FlywheelStudy::new(parse_diagram(&layouts::shown(&self.file), &text)?).map_err(Failure::new)
        })
    }
}
