//! `atlas`: what does every engine of the catalogue leave, and which stars in line are the best?

use crankstar::engine::Cycle;
use crankstar::file;
use crankstar::page::{File, Format};
use crankstar::report;
use crankstar::search::{self, Best, Options};

use super::failure::Failure;
use super::pages::{PageArgs, formats};
use super::{folder, layouts, progress, write};

/// Arguments of `atlas`.
#[derive(clap::Args)]
#[command(mut_arg("output", |folder| folder.required(true)))]
pub struct Atlas {
    /// Write the poster alone: the catalogue on one sheet of A2, poster.svg and poster.tex
    #[arg(long, conflicts_with_all = ["format", "math", "fragment", "siunitx", "stamp", "symbols"])]
    poster: bool,
    /// What the page is written in [default: README.md, atlas.tex and atlas.html]
    #[arg(long, value_parser = formats())]
    format: Option<Format>,
    /// The folder with a report of each engine, NAME/report.md, to which their names lead
    #[arg(long, value_name = "FOLDER", conflicts_with = "poster")]
    reports: Option<String>,
    #[command(flatten)]
    page: PageArgs,
}

impl Atlas {
    /// Writes the folder.
    pub fn run(&self) -> Result<(), Failure> {
        let files = if self.poster { report::poster(&file::catalogue()?, self.page.language()) } else { self.atlas()? };
        let Some(to) = self.page.folder() else { return Ok(()) };
        folder::write(to, &files)?;
        let pictures = |file: &&File| !file.name.starts_with("stars-");
        let names: Vec<String> =
            files.iter().filter(pictures).map(|file| layouts::shown(&to.join(&file.name))).collect();
        write::to_stdout(&format!("Written: {}\n", names.join(", ")))
    }

    /// The pages, and the numbers for a spreadsheet.
    fn atlas(&self) -> Result<Vec<File>, Failure> {
        let engines = file::catalogue()?;
        let stars = stars()?;
        let atlas = report::Atlas::new(&engines, &stars).map_err(Failure::new)?;
        let atlas = match &self.reports {
            Some(folder) => atlas.leading_to(folder),
            None => atlas,
        };
        let mut files = match self.format {
            Some(format) => self.page.files(&atlas.page(), format)?,
            None => {
                let [readme, named] = atlas.pages();
                let written = [(&readme, Format::GITHUB), (&named, Format::Latex), (&named, Format::Html)];
                let written = written.map(|(page, format)| self.page.files(page, format));
                written.into_iter().collect::<Result<Vec<_>, _>>()?.concat()
            }
        };
        files.push(atlas.csv());
        Ok(files)
    }
}

/// The best stars in line.
fn stars() -> Result<Vec<Best>, Failure> {
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
    Ok(stars)
}
