//! `rotor`: which masses balance a shaft?

use std::path::PathBuf;

use crankstar::file::{self, parse_rotor};
use crankstar::report::RotorStudy;

use super::answer::Answer;
use super::failure::Failure;
use super::layouts;

/// Arguments of `rotor`.
#[derive(clap::Args)]
pub struct Rotor {
    /// The path of a file of masses on a shaft; what it omits is found
    file: PathBuf,
    /// Print the masses as JSON
    #[arg(long, conflicts_with_all = ["output", "format"])]
    json: bool,
    #[command(flatten)]
    answer: Answer,
}

impl Rotor {
    /// Prints the answer, and writes the page into the folder.
    pub fn run(&self) -> Result<(), Failure> {
        self.answer.give("rotor", self.json, || {
            let text = layouts::read_text(&self.file)?;
            let name = layouts::shown(&self.file);
            let rotor = parse_rotor(&name, &text)?;
            layouts::warn(file::warnings_of_values(&name, &text));
            RotorStudy::new(rotor).map_err(Failure::new)
        })
    }
}
