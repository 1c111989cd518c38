//! `atlas`: what does every engine of the catalogue leave, and which stars in line are the best?

use std::path::PathBuf;

use crankstar::engine::Cycle;
use crankstar::file;
use crankstar::page::File;
use crankstar::report;
use crankstar::search::{self, Options};

use super::failure::Failure;
use super::{folder, layouts, progress, write};

/// Arguments of `atlas`.
#[derive(clap::Args)]
pub struct Atlas {
    /// Write the poster alone: the catalogue on one sheet of A3, poster.svg and poster.tex
    #[arg(long)]
    poster: bool,
    /// Folder for README.md with its pictures, atlas.tex, atlas.html and atlas.csv, or for the poster
    #[arg(long, value_name = "DIR")]
    output: PathBuf,
}

impl Atlas {
    /// Writes the folder.
    pub fn run(&self) -> Result<(), Failure> {
        let files = if self.poster { report::poster(&file::catalogue()?) } else { atlas()? };
        folder::write(&self.output, &files)?;
        let pictures = |file: &&File| !file.name.starts_with("stars-");
        let names: Vec<String> =
            files.iter().filter(pictures).map(|file| layouts::shown(&self.output.join(&file.name))).collect();
        write::to_stdout(&format!("Written: {}\n", names.join(", ")))
    }
}

/// Searches the stars and makes the pages.
fn atlas() -> Result<Vec<File>, Failure> {
    let engines = file::catalogue()?;
    let options = Options::default();
    let mut stars = Vec::new();
    let bar = progress::bar("stars");
    bar.set_length(2 * report::ATLAS_CYLINDERS.count() as u64);
    for cycle in [Cycle::TwoStroke, Cycle::FourStroke] {
        for cylinders in report::ATLAS_CYLINDERS {
            stars.push(search::best_in_line(cylinders, cycle, &options).map_err(Failure::new)?);
            bar.inc(1);
        }
    }
    bar.finish_and_clear();
    report::atlas(&engines, &stars).map_err(Failure::new)
}
