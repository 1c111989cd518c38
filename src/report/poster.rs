//! How does the whole catalogue look on one sheet? A stamp per engine on A2, to be read from two metres.

use super::catalogue::{CatalogueFamily, Stamp, catalogue_families};
use super::figure::{Anchor, Figure, Ink, Point, Stroke};
use crate::engine::Engine;
use crate::file::Entry;
use crate::page::{self, Document, File, Format, Language, Options, Picture, Text, phrase};
use crate::page::{svg, tikz};
use crate::report::texts::poster as text;

/// A2 upright, in millimetres.
const SHEET: (f64, f64) = (420.0, 594.0);
const MARGIN: f64 = 12.0;
/// Size of the letters of the title, of the name of a family, of what explains.
const TITLE: f64 = 18.0;
const FAMILY: f64 = 9.0;
const WORDS: f64 = 5.0;
/// Height of a line of what explains.
const LINE: f64 = 7.0;
/// Height of the head with the title, and of the foot with what is to be read.
const HEAD: f64 = 38.0;
const FOOT: f64 = 16.0;
/// Height of the name of a family.
const HEADING: f64 = 13.0;
/// The most columns that are tried.
const MOST_COLUMNS: usize = 16;

/// The poster: a drawing for a browser, and a file for pdflatex.
pub fn poster(engines: &[(Entry, Engine)], language: Language) -> Vec<File> {
    let title = title(engines.len());
    let drawn = Picture::new("poster", title.clone(), poster_sheet(engines));
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

/// The sheet itself.
pub fn poster_sheet(engines: &[(Entry, Engine)]) -> Figure {
    let families = catalogue_families(engines);
    let (width, height) = SHEET;
    let mut figure = Figure::new(width, height).lettered(WORDS);
    let top = height - MARGIN - TITLE / 2.0;
    figure.title(Point::new(width / 2.0, top), title(engines.len()).plain(), TITLE, Anchor::Middle);
    for (index, line) in text::above().iter().enumerate() {
        let y = height - MARGIN - TITLE - LINE * (index as f64 + 0.8);
        figure.text(Point::new(width / 2.0, y), line.plain(), Anchor::Middle);
    }
    let columns = columns(&families);
    let cell = (width - 2.0 * MARGIN) / columns as f64;
    let row = row_height(&families, columns);
    let mut y = height - MARGIN - HEAD;
    for family in &families {
        figure.title(Point::new(MARGIN, y - 0.55 * HEADING), family.heading, FAMILY, Anchor::Start);
        let rule = Stroke::solid(Ink::Grey, 0.4);
        figure.line(Point::new(MARGIN, y - HEADING + 1.0), Point::new(width - MARGIN, y - HEADING + 1.0), rule);
        y -= HEADING;
        for engines in family.engines.chunks(columns) {
            for (column, known) in engines.iter().enumerate() {
                let x = MARGIN + (column as f64 + 0.5) * cell;
                Stamp::new(known).draw(&mut figure, Point::new(x, y));
            }
            y -= row;
        }
    }
    for (index, line) in text::below().iter().rev().enumerate() {
        figure.text(Point::new(MARGIN, MARGIN + LINE * (index as f64 + 0.3)), line.plain(), Anchor::Start);
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

const BEGIN: &str = "\\documentclass{article}
\\usepackage[T1]{fontenc}
\\usepackage[utf8]{inputenc}
\\usepackage{textcomp,lmodern,amsmath,amssymb,tikz}
\\usepackage[a2paper,margin=0mm]{geometry}
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
