//! What is on the page of a remedy, on the terminal, and in a report?

use super::super::convention::differs;
use super::{alone, ranked, weights, words};
use crate::page::{Block, Document, Text};
use crate::remedy::Remedy;
use crate::report::texts::remedy as text;

/// The short answer: the weights, what they cancel, and what is good to know besides.
pub fn remedy_answer(remedy: &Remedy) -> Document {
    let mut answer = Document::new("remedy", remedy.subject.engine().title());
    weights::table(remedy).into_iter().for_each(|table| answer.push(table));
    let lines = words::remedy_cures(remedy).into_iter().chain(words::notes(remedy)).chain(ranked::over_speeds(remedy));
    let drawn = differs(remedy.subject.engine().convention());
    answer.blocks.extend(lines.chain(drawn).map(Block::Paragraph));
    answer
}

/// How the weights are found, and what angles and letters mean.
fn method(remedy: &Remedy) -> Vec<Text> {
    let convention = remedy.subject.engine().convention();
    let units = text::units(convention.turns_anticlockwise_from());
    text::method().into_iter().chain([units]).chain(differs(convention)).collect()
}

/// The page.
pub fn remedy_page(remedy: &Remedy) -> Document {
    text::Page {
        engine: remedy.subject.engine().title().into(),
        answer: Block::Answer(words::remedy_cures(remedy)).into(),
        results: results(remedy, 1).into(),
        compared: ranked::blocks(remedy).into(),
        method: method(remedy).into(),
    }
    .document()
}

/// The section of a report.
pub fn remedy_section(remedy: &Remedy) -> Vec<Block> {
    let mut blocks = vec![Block::Heading(1, "Remedies".into()), Block::List(words::remedy_cures(remedy))];
    blocks.extend(results(remedy, 2));
    blocks.push(Block::Heading(2, "Method".into()));
    blocks.push(Block::List(method(remedy)));
    blocks
}

/// The weights, what is good to know besides, and what counterweights alone do, below headings of this level.
fn results(remedy: &Remedy, level: u8) -> Vec<Block> {
    let mut blocks = Vec::new();
    let notes = words::notes(remedy);
    let table = weights::table(remedy);
    if table.is_some() || !notes.is_empty() {
        blocks.push(Block::Heading(level, if table.is_some() { "The weights" } else { "Notes" }.into()));
    }
    blocks.extend(table.map(Block::Table));
    blocks.extend((!notes.is_empty()).then_some(Block::List(notes)));
    let alone = alone::blocks(remedy);
    if !alone.is_empty() {
        blocks.push(Block::Heading(level, "Counterweights alone".into()));
        blocks.extend(alone);
    }
    blocks
}
