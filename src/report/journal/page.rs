//! What is on the page of the main bearings, and on the terminal, where the layout asks for the gas?

use super::super::bearings::{by_orders, parts_of_a_load};
use super::super::torque::{has_assumed, warning};
use super::{plots, tables, words};
use crate::engine::Engine;
use crate::journal::{CycleBearing, CycleBearings, CycleLoads};
use crate::loads::{BearingLoads, Missing};
use crate::page::{Block, Document, Picture, Table, Text, phrase};
use crate::report::texts::journal as text;

/// The short answer: the largest load of every bearing and rod.
pub fn complete_bearings_answer(engine: &Engine, loads: &CycleLoads) -> Document {
    let mut answer = Document::new("bearings", engine.title());
    if let Some(bearings) = &loads.bearings {
        answer.push(tables::bearings(engine, bearings));
        answer.blocks.extend(words::answer(engine, loads, bearings).into_iter().map(Block::Paragraph));
    }
    answer.blocks.extend(notes(engine, loads));
    answer
}

/// A document on the masses alone that says why the gas, which the layout asks for, is not in it.
pub fn without_gas(mut document: Document, lack: &Missing) -> Document {
    let told = Block::Note(text::without_gas(lack.to_string()));
    document.blocks.insert(1.min(document.blocks.len()), told);
    document
}

/// What a person should look at.
fn notes(engine: &Engine, loads: &CycleLoads) -> Vec<Block> {
    let odd = loads.warnings.iter().map(|(cylinders, odd)| Block::Note(warning(engine, cylinders, odd)));
    let mut notes: Vec<Block> = odd.collect();
    if has_assumed(engine) {
        notes.push(Block::Note(text::assumed(Text::code("crankstar torque --output"))));
    }
    notes
}

/// The page, with the loads of the masses alone by orders at its end.
pub fn complete_bearings_page(engine: &Engine, loads: &CycleLoads, masses: &BearingLoads) -> Document {
    let both = loads.bearings.as_ref();
    let drawn = |table: Table, pictures: Vec<Picture>| vec![table.into(), Block::Pictures(pictures)];
    let pins = tables::pins(engine, loads);
    let shared_pins = || drawn(tables::shared_pins(engine, loads), plots::shared_pins(engine, loads));
    let knuckle_pins = || drawn(tables::knuckles(engine, loads), plots::knuckles(engine, loads));
    let orders = |[continuous, _]: &[CycleBearings; 2]| -> Vec<Block> {
        vec![tables::orders(continuous).into(), words::missed(loads, continuous).into()]
    };
    let page = text::Page {
        engine: engine.title().into(),
        answer: both.map(|both| Block::Answer(words::answer(engine, loads, both))).into(),
        notes: both.map(|_| notes(engine, loads)).unwrap_or_default().into(),
        bearings: both.map(|both| tables::bearings(engine, both)).into(),
        each_bearing: both.map(|both| each_bearing(engine, loads, &both[0])).unwrap_or_default().into(),
        pins: if pins.rows.is_empty() { Vec::new() } else { drawn(pins, plots::pins(engine, loads)) }.into(),
        shared_pins: if loads.shared_pins.is_empty() { Vec::new() } else { shared_pins() }.into(),
        knuckle_pins: if loads.knuckles.is_empty() { Vec::new() } else { knuckle_pins() }.into(),
        rods: (!engine.has_yokes_alone()).then(|| tables::rods(engine, loads)).into(),
        orders: both.map(orders).unwrap_or_default().into(),
        masses: by_orders(engine, masses).into(),
        parts: parts_of_a_load(engine, masses).into(),
        method: if engine.has_yokes_alone() { text::method_of_yokes() } else { text::method() }.into(),
        assumptions: words::assumptions(engine).into(),
    };
    Document { name: "bearings", ..page.document() }
}

/// The drawings of each bearing, under its name.
fn each_bearing(engine: &Engine, loads: &CycleLoads, bearings: &CycleBearings) -> Vec<Block> {
    let drawn = plots::bearings(engine.convention(), loads, bearings);
    let of_one = |(bearing, pictures): (&CycleBearing, [Picture; 2])| {
        [Block::Heading(2, phrase!("Bearing {}", bearing.name.clone())), Block::Pictures(pictures.into())]
    };
    bearings.bearings.iter().zip(drawn).flat_map(of_one).collect()
}
