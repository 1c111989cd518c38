//! What is on the page of a remedy, on the terminal, and in a report?

use super::super::convention::differs;
use super::{alone, ranked, weights, words};
use crate::page::{Block, Document, Text, phrase};
use crate::remedy::Remedy;

const METHOD: [&str; 2] = [
    "A mass at a radius, $U = m_U r_U$, that turns at $n$ times the crank speed and is at the angle $\\gamma$ at θ = 0 adds $2 n^2 U e^{i\\gamma}$ to the direct vector of order $n$ where it turns with the crank, and to the reverse one where it turns against it.",
    "Each weight is an exact sum of the same kind as those of the engine. The sums of the corrected engine, with the weights among their terms, are formed again and decided: that they vanish is proved, not computed.",
];
const UNITS: &str = "m and r are the reciprocating mass per cylinder and the crank radius of the layout, and $c_k$ is the coefficient of order k of the piston motion. Angles grow in the sense in which the crank turns, {seen from the free end|anticlockwise seen from the flywheel}.";

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
    METHOD
        .map(Text::from)
        .into_iter()
        .chain([phrase!(UNITS, convention.turns_anticlockwise_from())])
        .chain(differs(convention))
        .collect()
}

/// The page.
pub fn remedy_page(remedy: &Remedy) -> Document {
    let mut page = Document::new("remedy", phrase!("{}: remedies", remedy.subject.engine().title()));
    page.push(Block::Answer(words::remedy_cures(remedy)));
    page.blocks.extend(results(remedy, 1));
    page.blocks.extend(ranked::blocks(remedy, 1));
    page.push(Block::Heading(1, "Method".into()));
    page.push(Block::List(method(remedy)));
    page
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
        blocks.push(Block::Heading(level, "The weights".into()));
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
