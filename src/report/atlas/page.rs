//! What is on the pages of the atlas? The answer, the stars of the catalogue, what each engine leaves first and at each order.

use super::super::catalogue::{catalogue_families, catalogue_pictures, catalogue_summary};
use super::super::engine_cells;
use super::entry::{EngineRow, Origin};
use super::tables;
use crate::engine::{Cycle, Engine};
use crate::file::Entry;
use crate::page::{Block, Document, Text, phrase};
use crate::proof::Planar;

/// The page in no format yet.
pub(super) fn page(engines: &[(Entry, Engine)], all: &[EngineRow], beside: Beside) -> Document {
    let mut page = Document::new("atlas", "Atlas of engine balance");
    page.has_contents = true;
    let families = catalogue_families(engines);
    let of = |origin: Origin| all.iter().filter(|row| row.origin == origin).collect::<Vec<_>>();
    let mut lines = vec![phrase!(
        "The {} engines of the catalogue and the {} best in-line stars of 2 to 12 cylinders: their exact residuals at orders 1 to 8, and the lowest residual order.",
        engines.len(),
        all.len() - engines.len()
    )];
    lines.extend(catalogue_summary(&families));
    page.push(Block::Answer(lines));
    page.push(Block::Heading(1, "The stars of the catalogue".into()));
    for family in &families {
        page.push(Block::Heading(2, family.heading.into()));
        page.push(catalogue_pictures(family));
    }
    page.push(Block::Heading(1, "The catalogue".into()));
    let known = of(Origin::Catalogue);
    page.push(tables::known(&known));
    by_order(&mut page, &known);
    for (cycle, heading, words) in [
        (Cycle::TwoStroke, "The best stars in line, two-stroke", TWO_STROKE),
        (Cycle::FourStroke, "The best stars in line, four-stroke", FOUR_STROKE),
    ] {
        let found = of(Origin::Found(cycle));
        page.section(heading, words);
        page.push(tables::found(&found));
        by_order(&mut page, &found);
    }
    page.section("Longer closed forms", LONGER);
    page.push(Block::List(tables::longer_forms(all)));
    page.section("How to read it", Block::List(NOTES.map(Text::from).into()));
    page.push(Block::Paragraph(beside()));
    page
}

/// A file beside the page.
fn file(name: &'static str) -> Text {
    Text::link(Text::label(name), name)
}

/// What is said of the files beside the page.
pub(super) type Beside = fn() -> Text;

/// Those of them that centric cranks have.
const CENTRIC: [u32; 5] = [1, 2, 4, 6, 8];

/// Those that only cranks with a pin offset have.
const OFFSET: [u32; 3] = [3, 5, 7];

/// The page is written in one format.
pub(super) const ALONE: Beside = || {
    let csv = file("atlas.csv");
    phrase!(
        "Its numbers for a spreadsheet: {}. {} writes both.",
        csv,
        Text::code("crankstar atlas --output DIR --format FORMAT")
    )
};

/// The page is written in three formats.
pub(super) const WITH_OTHERS: Beside = || {
    phrase!(
        "The same page for print: {}; for a browser: {}; its numbers for a spreadsheet: {}. {} writes them all.",
        file("atlas.tex"),
        file("atlas.html"),
        file("atlas.csv"),
        Text::code("crankstar atlas --output DIR")
    )
};

/// The forces and the moments of each order; folded those of the orders that only a pin offset has.
fn by_order(page: &mut Document, rows: &[&EngineRow]) {
    page.push(Block::Heading(2, "Forces, order by order".into()));
    page.push(tables::by_order(rows, Planar::Force, &CENTRIC));
    page.push(Block::Heading(2, "Moments, order by order".into()));
    page.push(tables::by_order(rows, Planar::Moment, &CENTRIC));
    page.push(Block::folded(
        "Orders 3, 5 and 7, which only engines with a pin offset have",
        vec![
            Block::Paragraph("Forces:".into()),
            tables::by_order(rows, Planar::Force, &OFFSET).into(),
            Block::Paragraph("Moments:".into()),
            tables::by_order(rows, Planar::Moment, &OFFSET).into(),
        ],
    ));
}

const NOTES: [&str; 6] = [
    "**0** is exact and proved; the other numbers are the largest value through a revolution, $\\tfrac{1}{2}(\\lvert P^{+} \\rvert + \\lvert P^{-} \\rvert)$, \
     exact, but for the decimals after ≈: forces in $m r \\omega^2 c_k$, moments in that times the spacing (the unit of the positions), about the middle of the engine.",
    "Orders 3, 5 and 7 exist only where the cylinder axes miss the crankshaft (pin offset): with centric cranks their $c_k$ is 0. **Lowest order** is the lowest order that remains of all that exist with centric cranks: 1 and the even ones.",
    "Rotating: a vector of constant length that turns with the crank; counter-rotating: against it; planar: it swings along a line; elliptical: neither.",
    engine_cells::REMEDIES,
    "Remedies are those of orders 1 and 2, for the reciprocating masses.",
    "Closed forms of more than 24 characters are in the list above (orders 1 and 2) and in atlas.csv (all).",
];

const LONGER: &str =
    "Of orders 1 and 2; the four-stroke stars of an odd number of cylinders are those of the two-stroke engines.";

const TWO_STROKE: &str = "All crank stars of 2 to 12 cylinders that fire evenly, one spacing apart, decided exactly: only those are listed for which no other is at least as good in the moments of orders 1 and 2 and better in one. An engine is named by its number of cylinders and its firing order. Equally good stars (with cylinder 1 at 0°) have the same moments of orders 1 and 2. All cylinder axes are parallel, so that every force and moment is planar.";

const FOUR_STROKE: &str = "The same for four-stroke engines. With an odd number of cylinders the stars are those of the two-stroke engine, in another firing order.";
