//! `list`: which engines are known by name, and what does each leave first?

use crankstar::page::Options;
use crankstar::{file, report};

use super::failure::Failure;
use super::language::LanguageArgs;
use super::pages::shown;
use super::write::{self, print_json};

/// Arguments of `list`.
#[derive(clap::Args)]
pub struct List {
    /// Print the list as JSON
    #[arg(long)]
    json: bool,
    #[command(flatten)]
    language: LanguageArgs,
}

impl List {
    /// Prints the catalogue, a row per engine.
    pub fn run(&self) -> Result<(), Failure> {
        let engines = file::catalogue()?;
        match self.json {
            true => print_json(&report::catalogue_document(&engines)),
            false => write::to_stdout(&shown(
                &report::catalogue_answer(&engines),
                &Options { language: self.language.language(), ..Options::default() },
            )),
        }
    }
}
