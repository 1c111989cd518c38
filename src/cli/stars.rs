//! `stars`: what can the crank star of a number of cylinders lose, and what never?

use std::path::PathBuf;

use crankstar::file::{self, Layout};
use crankstar::report::{
    StarAtlas, StarredEngine, StarsStudy, star_atlas_answer, star_atlas_page, stars_answer, stars_layouts, stars_page,
};
use crankstar::search::Options;

use super::failure::Failure;
use super::pages::Pages;
use super::{layouts, progress};

/// Arguments of `stars`.
#[derive(clap::Args)]
pub struct Stars {
    /// Instead the stars of up to twelve equal vectors of which no part sums to zero, and the engines of the catalogue in which they occur
    #[arg(long)]
    atlas: bool,
    /// Layout files of further engines to look at
    #[arg(requires = "atlas")]
    layouts: Vec<PathBuf>,
    #[command(flatten)]
    pages: Pages,
}

impl Stars {
    /// Writes the page with its layout files into the folder, and the tables to the terminal.
    pub fn run(&self) -> Result<(), Failure> {
        if self.atlas {
            return self.of_vectors();
        }
        progress::doing("searching the stars of up to 12 cylinders");
        let study = StarsStudy::new(&Options::default()).map_err(Failure::new)?;
        self.pages.show(&stars_answer(&study), || stars_page(&study), || stars_layouts(&study))
    }

    /// The atlas of minimal stars.
    fn of_vectors(&self) -> Result<(), Failure> {
        let catalogue = file::catalogue()?.into_iter();
        let mut engines: Vec<StarredEngine> =
            catalogue.map(|(entry, engine)| StarredEngine { name: entry.name.to_owned(), engine }).collect();
        for layout in &self.layouts {
            let name = layouts::shown(layout);
            match layouts::read(layout)? {
                Layout::Known(engine, _) => engines.push(StarredEngine { name, engine: *engine }),
                Layout::Open(family) => {
                    return Err(Failure::new(format!(
                        "`{name}` has unknowns: {}; its stars need their values below [values]",
                        family.unknowns().into_iter().collect::<Vec<_>>().join(", ")
                    )));
                }
            }
        }
        let atlas = StarAtlas::new(&engines);
        self.pages.show(&star_atlas_answer(&atlas), || star_atlas_page(&atlas), Vec::new)
    }
}
