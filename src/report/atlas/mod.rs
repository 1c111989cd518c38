//! What does the atlas show? Every engine of the catalogue and the best stars in line, at orders 1 to 8.

mod csv;
mod entry;
mod page;
mod tables;

use crate::engine::{BuildError, Engine};
use crate::file::Entry;
use crate::page::{Document, File, Format, Options, write};
use crate::search::Best;
use entry::EngineRow;

/// Numbers of cylinders whose best stars stand in the atlas.
pub const ATLAS_CYLINDERS: std::ops::RangeInclusive<u32> = 2..=12;
/// The orders of the atlas.
const ORDERS: [u32; 8] = [1, 2, 3, 4, 5, 6, 7, 8];
/// Those of them that centric cranks have.
const CENTRIC: [u32; 5] = [1, 2, 4, 6, 8];
/// Those that only cranks with a pin offset have.
const OFFSET: [u32; 3] = [3, 5, 7];
/// The orders that the remedies are for.
const REMEDIED: [u32; 2] = [1, 2];

/// The atlas: `README.md` with its pictures, `atlas.tex`, `atlas.html` and `atlas.csv`.
///
/// # Errors
/// Those of a layout file, for a star that is no engine; none is known to arise.
pub fn atlas(engines: &[(Entry, Engine)], stars: &[Best]) -> Result<Vec<File>, BuildError> {
    let mut all: Vec<EngineRow> = engines.iter().map(|(known, layout)| EngineRow::known(known.name, layout)).collect();
    for best in stars {
        for star in &best.stars {
            all.push(EngineRow::found(best, star)?);
        }
    }
    let readme = page::page(engines, &all);
    let named = Document { name: "atlas", ..readme.clone() };
    let written = [(&readme, Format::GITHUB), (&named, Format::Latex), (&named, Format::Html)];
    let mut files: Vec<File> =
        written.into_iter().flat_map(|(page, format)| write(page, format, &Options::default())).collect();
    files.push(File { name: "atlas.csv".to_owned(), text: csv::csv(&all) });
    Ok(files)
}
