//! How does the whole catalogue look on one sheet? A stamp per engine on A3, for a wall.

use super::catalogue::{CatalogueFamily, Stamp, catalogue_families};
use super::figure::{Anchor, Figure, Ink, Point, Stroke};
use crate::engine::Engine;
use crate::file::Entry;
use crate::page::{self, Document, File, Format, Language, Options, Picture, Text, phrase};
use crate::page::{svg, tikz};

/// A3 upright, in millimetres.
const SHEET: (f64, f64) = (297.0, 420.0);
const MARGIN: f64 = 14.0;
/// Height of the head with the title, and of the foot with what is to be read.
const HEAD: f64 = 28.0;
const FOOT: f64 = 18.0;
/// Height of the name of a family.
const HEADING: f64 = 8.0;
/// The most columns that are tried.
const MOST_COLUMNS: usize = 16;

/// The poster: a drawing for a browser, and a file for pdflatex.
pub fn poster(engines: &[(Entry, Engine)], language: Language) -> Vec<File> {
    let title = title(engines.len());
    let drawn = Picture { name: "poster".to_owned(), caption: title.clone(), figure: poster_sheet(engines) };
    let figure = language.picture(&drawn).figure;
    let file = |name: &str, text: String| File { name: name.to_owned(), text };
    vec![
        file("poster.svg", svg(&figure, &language.label(&title.plain()))),
        file("poster.tex", in_latex(&figure, language)),
    ]
}

fn title(engines: usize) -> Text {
    phrase!("How {} engines balance", engines)
}

const SUBTITLE: [&str; 2] = [
    "Each engine from its free end, cranks inside and cylinders outside; beside it the vector star of the lowest order",
    "that it leaves, of the force or else of the moment; below it the lowest order left of each. Exact, and proved for every order.",
];

const FOOTER: [&str; 4] = [
    "Black arrows: the vectors of the cylinders at that order, in the sense of the crank, or against it where the former sum to zero; of a moment they are as long as their arms.",
    "Red arrow: their sum, which is what is left. Each star has a scale of its own. Moments are taken about the middle of the engine. Orders are multiples of crank speed: 1, 2, 4, 6, …",
    "Rotating: what is left turns with the crank; of order 1, counterweights on the crankshaft remove it. Planar: it swings along a line, and a pair of shafts removes it.",
    "Elliptical: neither; of order 1, counterweights remove the part that turns with the crank, and a shaft against the crank removes the rest.",
];

/// The sheet itself.
pub fn poster_sheet(engines: &[(Entry, Engine)]) -> Figure {
    let families = catalogue_families(engines);
    let (width, height) = SHEET;
    let mut figure = Figure::new(width, height);
    figure.title(Point::new(width / 2.0, height - MARGIN - 7.0), title(engines.len()).plain(), 13.0, Anchor::Middle);
    for (index, line) in SUBTITLE.iter().enumerate() {
        figure.text(Point::new(width / 2.0, height - MARGIN - 17.0 - 4.4 * index as f64), *line, Anchor::Middle);
    }
    let columns = columns(&families);
    let cell = (width - 2.0 * MARGIN) / columns as f64;
    let row = row_height(&families, columns);
    let mut y = height - MARGIN - HEAD;
    for family in &families {
        figure.title(Point::new(MARGIN, y - 3.6), family.heading, 5.0, Anchor::Start);
        let rule = Stroke::solid(Ink::Grey, 0.3);
        figure.line(Point::new(MARGIN, y - 6.6), Point::new(width - MARGIN, y - 6.6), rule);
        y -= HEADING;
        for engines in family.engines.chunks(columns) {
            for (column, known) in engines.iter().enumerate() {
                let x = MARGIN + (column as f64 + 0.5) * cell;
                Stamp::new(known).draw(&mut figure, Point::new(x, y));
            }
            y -= row;
        }
    }
    for (index, line) in FOOTER.iter().rev().enumerate() {
        figure.text(Point::new(MARGIN, MARGIN + 2.0 + 4.4 * index as f64), *line, Anchor::Start);
    }
    figure
}

/// The columns with which the cells are widest, of those with which all rows fit; else those with the fewest rows.
fn columns(families: &[CatalogueFamily]) -> usize {
    let fits = |&columns: &usize| row_height(families, columns) >= Stamp::HEIGHT;
    (1..=MOST_COLUMNS).find(fits).unwrap_or(MOST_COLUMNS)
}

/// The height that each row has where all rows share the sheet.
fn row_height(families: &[CatalogueFamily], columns: usize) -> f64 {
    let rows: usize = families.iter().map(|family| family.engines.len().div_ceil(columns)).sum();
    let room = SHEET.1 - 2.0 * MARGIN - HEAD - FOOT - HEADING * families.len() as f64;
    room / rows.max(1) as f64
}

const BEGIN: &str = "\\documentclass[a3paper]{article}
\\usepackage[T1]{fontenc}
\\usepackage[utf8]{inputenc}
\\usepackage{textcomp,lmodern,amsmath,amssymb,tikz}
\\usepackage[margin=0mm]{geometry}
\\usetikzlibrary{arrows.meta}
\\pagestyle{empty}
\\setlength{\\parindent}{0pt}
\\setlength{\\topskip}{0pt}
";

/// A file of its own for pdflatex, with the colours of every other page.
fn in_latex(figure: &Figure, language: Language) -> String {
    let fragment = Options { fragment: true, language, ..Options::default() };
    let colours = page::write(&Document::new("poster", ""), Format::Latex, &fragment);
    let colours: String = colours.into_iter().map(|file| file.text).collect();
    let drawing = tikz(figure);
    format!("{BEGIN}{colours}\\begin{{document}}\n{drawing}\\end{{document}}\n")
}
