//! How are the engines of a family drawn beside each other? A picture of stamps in rows.

use super::super::figure::{Figure, Point};
use super::{CatalogueFamily, KnownEngine, Stamp};
use crate::page::{Block, Picture};

/// Stamps beside each other: their words are read on a telephone too.
const COLUMNS: usize = 2;
/// Engines of one picture; on a wide screen two pictures are beside each other.
const MOST_ENGINES: usize = 8;
/// Space between two stamps.
const GAP: f64 = 4.0;

/// What the pictures of a family show.
const CAPTION: &str = "Each engine from its free end, cranks inside and cylinders outside, beside its free force F and moment M of orders 1 and 2: the path \
    that they trace (red), and the largest value, rounded, in m r ω² and m r ω² a (rods 3.5 crank radii long where none are given). 0 is exact and proved.";

/// The pictures of a family.
pub fn pictures(family: &CatalogueFamily) -> Block {
    let pages = family.engines.len().div_ceil(MOST_ENGINES).max(1);
    let rows_a_page = family.engines.len().div_ceil(pages * COLUMNS);
    let picture = |(index, engines): (usize, &[KnownEngine])| Picture {
        name: match index {
            0 => family.file.to_owned(),
            later => format!("{}-{}", family.file, later + 1),
        },
        caption: CAPTION.into(),
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
