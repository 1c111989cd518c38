//! How are the engines of a family drawn beside each other? A picture of stamps in rows.

use super::super::figure::{Figure, Point};
use super::{CatalogueFamily, KnownEngine, Stamp};
use crate::page::{Block, Picture};
use crate::report::texts::catalogue as text;

/// Stamps beside each other: their words are read on a telephone too.
const COLUMNS: usize = 2;
/// Engines of one picture; on a wide screen two pictures are beside each other.
const MOST_ENGINES: usize = 8;
/// Space between two stamps.
const GAP: f64 = 4.0;

/// The pictures of a family.
pub fn pictures(family: &CatalogueFamily) -> Block {
    let pages = family.engines.len().div_ceil(MOST_ENGINES).max(1);
    let rows_a_page = family.engines.len().div_ceil(pages * COLUMNS);
    let picture = |(index, engines): (usize, &[KnownEngine])| Picture {
        name: match index {
            0 => family.file.to_owned(),
            later => format!("{}-{}", family.file, later + 1),
        },
        caption: text::stamps(),
        figure: rows(engines),
    };
    Block::Pictures(family.engines.chunks(rows_a_page * COLUMNS).enumerate().map(picture).collect())
}

fn rows(engines: &[KnownEngine]) -> Figure {
    let (columns, rows) = (engines.len().min(COLUMNS), engines.len().div_ceil(COLUMNS));
    let (width, height) = (Stamp::WIDTH + GAP, Stamp::HEIGHT + GAP);
    let mut figure = Figure::new(columns as f64 * width, rows as f64 * height);
    for (index, known) in engines.iter().enumerate() {
        let (column, row) = (index % COLUMNS, index / COLUMNS);
        let top = Point::new((column as f64 + 0.5) * width, figure.height - row as f64 * height);
        Stamp::new(known).draw(&mut figure, top);
    }
    figure
}
