//! What is on the pages of the atlas? The answer, the stars of the catalogue, what each engine leaves first and at each order.

use super::super::catalogue::{catalogue_families, catalogue_pictures, catalogue_summary};
use super::entry::{EngineRow, Origin};
use super::tables;
use crate::engine::{Cycle, Engine};
use crate::file::Entry;
use crate::page::{Block, Blocks, Document, Table, Text};
use crate::proof::Planar;
use crate::report::texts::{atlas as text, engine_cells};

/// The page in no format yet.
pub(super) fn page(engines: &[(Entry, Engine)], all: &[EngineRow], files: Text) -> Document {
    let families = catalogue_families(engines);
    let of = |origin: Origin| all.iter().filter(|row| row.origin == origin).collect::<Vec<_>>();
    let mut lines = vec![text::engines(engines.len(), all.len() - engines.len())];
    lines.extend(catalogue_summary(&families));
    let stars =
        families.iter().flat_map(|family| [Block::Heading(2, family.heading.into()), catalogue_pictures(family)]);
    let known = of(Origin::Catalogue);
    let found = |cycle: Cycle| {
        let found = of(Origin::Found(cycle));
        with_orders(tables::found(&found), &found)
    };
    let page = text::Page {
        answer: Block::Answer(lines).into(),
        stars: stars.collect(),
        catalogue: with_orders(tables::known(&known), &known),
        two_stroke: found(Cycle::TwoStroke),
        four_stroke: found(Cycle::FourStroke),
        longer_forms: Block::List(tables::longer_forms(all)).into(),
        remedies: [engine_cells::remedies()].into(),
        files: files.into(),
    };
    Document { has_contents: true, ..page.document() }
}

/// A file beside the page.
fn file(name: &'static str) -> Text {
    Text::link(Text::label(name), name)
}

/// The orders that centric cranks have.
const CENTRIC: [u32; 5] = [1, 2, 4, 6, 8];

/// Those that only cranks with a pin offset have.
const OFFSET: [u32; 3] = [3, 5, 7];

/// What is said of the file beside a page that is written in one format.
pub(super) fn one_format() -> Text {
    text::one_format(file("atlas.csv"), Text::code("crankstar atlas --output DIR --format FORMAT"))
}

/// What is said of the files beside a page that is written in three formats.
pub(super) fn other_formats() -> Text {
    let [tex, html, csv] = ["atlas.tex", "atlas.html", "atlas.csv"].map(file);
    text::other_formats(tex, html, csv, Text::code("crankstar atlas --output DIR"))
}

/// A table, and the forces and the moments of each order; folded those of the orders that only a pin offset has.
fn with_orders(table: Table, rows: &[&EngineRow]) -> Blocks {
    let offset = vec![
        "Forces:".into(),
        tables::by_order(rows, Planar::Force, &OFFSET).into(),
        "Moments:".into(),
        tables::by_order(rows, Planar::Moment, &OFFSET).into(),
    ];
    vec![
        table.into(),
        Block::Heading(2, "Forces, order by order".into()),
        tables::by_order(rows, Planar::Force, &CENTRIC).into(),
        Block::Heading(2, "Moments, order by order".into()),
        tables::by_order(rows, Planar::Moment, &CENTRIC).into(),
        Block::folded(text::offset_orders(), offset),
    ]
    .into()
}
