//! How do the engines of a family stand beside each other? A picture of stamps in rows.

use super::super::figure::{Figure, Point};
use super::{Family, Known, Stamp};
use crate::page::{Block, Picture, Text};

/// Stamps beside each other: their words are read on a telephone too.
const COLUMNS: usize = 3;
/// Rows of a picture: so many stand on a printed page.
const MOST_ROWS: usize = 5;
/// Width of a stamp in millimetres.
const WIDTH: f64 = 35.0;
/// Space between two rows.
const GAP: f64 = 3.0;

/// What the pictures of a family show.
const CAPTION: &str = "The star of the lowest order that each engine leaves, of the force or else of the moment: black arrows are the vectors of \
    the cylinders, polygons sum to zero, the red arrow is what is left. Below it the lowest order left of the force and of the moment.";

/// The pictures of a family, each as many rows as a page takes.
pub(in crate::report) fn pictures(family: &Family) -> Block {
    let pages: Vec<&[Known]> = family.engines.chunks(COLUMNS * MOST_ROWS).collect();
    let picture = |(index, engines): (usize, &&[Known])| Picture {
        name: match index {
            0 => family.file.to_owned(),
            later => format!("{}-{}", family.file, later + 1),
        },
        caption: if index + 1 == pages.len() { CAPTION.into() } else { Text::default() },
        figure: rows(engines),
    };
    Block::Pictures(pages.iter().enumerate().map(picture).collect())
}

fn rows(engines: &[Known]) -> Figure {
    let (columns, rows) = (engines.len().min(COLUMNS), engines.len().div_ceil(COLUMNS));
    let mut figure = Figure::new(columns as f64 * WIDTH, rows as f64 * (Stamp::HEIGHT + GAP));
    for (index, known) in engines.iter().enumerate() {
        let (column, row) = (index % COLUMNS, index / COLUMNS);
        let top = Point::new((column as f64 + 0.5) * WIDTH, figure.height - row as f64 * (Stamp::HEIGHT + GAP));
        Stamp::new(known).draw(&mut figure, top);
    }
    figure
}
