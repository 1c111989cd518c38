//! `stars`: what can the crank star of a number of cylinders lose, and what never?

use crankstar::report::{StarsStudy, stars_answer, stars_layouts, stars_page};
use crankstar::search::Options;

use super::failure::Failure;
use super::pages::Pages;
use super::{progress, write};

/// Arguments of `stars`.
#[derive(clap::Args)]
pub struct Stars {
    #[command(flatten)]
    pages: Pages,
}

impl Stars {
    /// Writes the page with its layout files into the folder, and the tables to the terminal.
    pub fn run(&self) -> Result<(), Failure> {
        progress::doing("searching the stars of up to 12 cylinders");
        let study = StarsStudy::new(&Options::default()).map_err(Failure::new)?;
        let written = self.pages.write(|| stars_page(&study), || stars_layouts(&study))?;
        write::to_stdout(&(self.pages.shown(&stars_answer(&study))? + &written))
    }
}
