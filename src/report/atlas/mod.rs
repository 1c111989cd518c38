//! What does the atlas show? Every engine of the catalogue and the best stars in line, at orders 1 to 8.

mod csv;
mod entry;
mod page;
mod tables;

use crate::engine::{BuildError, Engine};
use crate::file::Entry;
use crate::page::{Document, File};
use crate::search::Best;
use entry::EngineRow;

/// Numbers of cylinders whose best stars are in the atlas.
pub const ATLAS_CYLINDERS: std::ops::RangeInclusive<u32> = 2..=12;

/// The atlas: every engine of it, judged.
pub struct Atlas<'a> {
    engines: &'a [(Entry, Engine)],
    rows: Vec<EngineRow>,
}

impl<'a> Atlas<'a> {
    /// The engines of the catalogue, and the best stars.
    ///
    /// # Errors
    /// Those of a layout file, for a star that is no engine; none is known to arise.
    pub fn new(engines: &'a [(Entry, Engine)], stars: &[Best]) -> Result<Self, BuildError> {
        let known = engines.iter().map(|(known, layout)| Ok(EngineRow::known(known.name, layout)));
        let found = stars.iter().flat_map(|best| best.stars.iter().map(move |star| EngineRow::found(best, star)));
        Ok(Atlas { engines, rows: known.chain(found).collect::<Result<_, _>>()? })
    }

    /// With names of the catalogue that lead to `FOLDER/NAME/report.md`.
    pub fn leading_to(mut self, folder: &str) -> Self {
        for row in self.rows.iter_mut().filter(|row| row.origin == entry::Origin::Catalogue) {
            row.report = Some(format!("{folder}/{}/report.md", row.name));
        }
        self
    }

    /// The page, which says that `atlas.csv` is beside it.
    pub fn page(&self) -> Document {
        page::page(self.engines, &self.rows, page::one_format())
    }

    /// The page where it is written in several formats: as README that leads to the others, and as one of those.
    pub fn pages(&self) -> [Document; 2] {
        let named = page::page(self.engines, &self.rows, page::other_formats());
        [Document { name: "README", ..named.clone() }, named]
    }

    /// `atlas.csv`: a line per engine and order.
    pub fn csv(&self) -> File {
        File { name: "atlas.csv".to_owned(), text: csv::csv(&self.rows) }
    }
}
