//! `atlas`: what does every engine of the catalogue leave, and which stars in line are the best?

use std::path::PathBuf;

use crankstar::engine::Cycle;
use crankstar::file;
use crankstar::report;
use crankstar::search::{self, Options};

use super::failure::Failure;
use super::{folder, layouts, progress, write};

/// Arguments of `atlas`.
#[derive(clap::Args)]
pub struct Atlas {
    /// Folder for README.md, atlas.tex and atlas.csv
    #[arg(long, value_name = "DIR")]
    output: PathBuf,
}

impl Atlas {
    /// Searches the stars and writes the folder.
    pub fn run(&self) -> Result<(), Failure> {
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
        let files = report::atlas(&engines, &stars).map_err(Failure::new)?;
        folder::write(&self.output, &files)?;
        let names: Vec<String> = files.iter().map(|file| layouts::shown(&self.output.join(&file.name))).collect();
        write::to_stdout(&format!("Written: {}\n", names.join(", ")))
    }
}
