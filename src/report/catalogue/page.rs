//! What does a terminal show of the catalogue? A row per engine.

use super::super::engine_cells;
use super::{KnownEngine, catalogue_families};
use crate::engine::{Engine, Firing};
use crate::file::Entry;
use crate::page::{Block, Document, Table, Text};
use crate::report::texts::catalogue as text;

/// The list: a row per engine, as narrow as a terminal.
pub fn catalogue_answer(engines: &[(Entry, Engine)]) -> Document {
    let known = catalogue_families(engines).into_iter().flat_map(|family| family.engines);
    let table = Table::of(known.map(|known| (orders(&known), known)))
        .column("Name", |(_, known)| Text::label(known.name))
        .column("Engine", |(_, known)| known.engine.title())
        .column("Firing", |(_, known)| firing(known.engine.firing()))
        .column("Force", |([force, _], _)| force.clone())
        .column("Moment", |([_, moment], _)| moment.clone());
    let mut page = Document::new("catalogue", "The catalogue");
    page.push(table.done());
    page.push(Block::Note(text::lowest_orders()));
    page
}

/// How it fires, in a word.
fn firing(firing: Option<&Firing>) -> Text {
    match firing {
        Some(firing) if firing.is_even() => engine_cells::firing(Some(firing)),
        Some(_) => "uneven".into(),
        None => "not given".into(),
    }
}

/// The numbers of the lowest orders left.
fn orders(known: &KnownEngine) -> [Text; 2] {
    match known.first() {
        Some(first) => first.map(|first| first.map_or_else(|| "none".into(), |first| first.order.into())),
        None => ["not stated".into(), "not stated".into()],
    }
}
