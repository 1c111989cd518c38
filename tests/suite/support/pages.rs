//! The pages of an engine, as most tests want them.

use crankstar::engine::{Engine, Family};
use crankstar::family;
use crankstar::page::{self, Document, File, Format, Math, Options, Table};
use crankstar::proof::Quantity;
use crankstar::report::{self, Contents};
use crankstar::verdict::Judgement;

/// Markdown for pandoc, in which a formula is easy to look for.
pub const DOLLARS: Format = Format::Markdown(Math::Dollars);

/// The verdicts at the orders of the layout, as the program judges it.
pub fn judgement(engine: &Engine) -> Judgement {
    Judgement::new(engine, engine.orders(), &Quantity::PLANAR).expect("orders")
}

/// The report of an engine.
pub fn document(engine: &Engine) -> Document {
    document_of(engine, None)
}

/// The report of a layout, with what is known of its family where it has one.
pub fn document_of(engine: &Engine, family: Option<&Family>) -> Document {
    let open = family.map(|open| (open, family::classify(open, engine.orders()).expect("orders")));
    let judged = judgement(engine);
    report::engine_page(Contents {
        engine,
        judged: &judged,
        family: open.as_ref().map(|(open, verdicts)| (*open, verdicts.as_slice())),
        needed: None,
        in_motion: false,
        accuracy: None,
        weighing: report::Weighing::usual(),
    })
}

/// The files of a page in a format.
pub fn files(document: &Document, format: Format) -> Vec<File> {
    page::write(document, format, &Options::default())
}

/// The main file of a page in a format.
pub fn text(document: &Document, format: Format) -> String {
    files(document, format).remove(0).text
}

/// The tables of a page as plain text.
pub fn tables(document: &Document) -> Vec<Vec<Vec<String>>> {
    let cells = |row: &Vec<page::Text>| row.iter().map(|cell| page::text_in(cell, Format::PLAIN)).collect();
    let rows = |table: &Table| table.rows.iter().map(cells).collect();
    let table = |block: &page::Block| match block {
        page::Block::Table(table) => Some(rows(table)),
        _ => None,
    };
    document.blocks.iter().filter_map(table).collect()
}
