//! What stands first where vibrations are asked for: what shakes, or tables?

use crankstar::page::{Block, Document, Format, text_in};
use crankstar::report;

use crate::support::pages;
use crate::support::written::engine;

const MOUNTS: &str = include_str!("../../reports/examples/i4-mounts/layout.toml");
const DAMPER: &str = include_str!("../../reports/examples/i6-damper/layout.toml");

fn answer(question: &str, text: &str) -> Document {
    let study = report::ask(question, &engine(text), &[]).expect("a question");
    study.unwrap_or_else(|why| panic!("{text}: {why}")).answer()
}

/// The paragraphs before the first table.
fn first_words(answer: &Document) -> Vec<String> {
    let words = |block: &Block| match block {
        Block::Paragraph(words) => Some(text_in(words, Format::PLAIN)),
        _ => None,
    };
    answer.blocks.iter().map_while(words).collect()
}

#[test]
fn mounts_say_what_is_passed_on_and_moved_before_the_natural_frequencies() {
    let answer = answer("mounts", MOUNTS);
    let words = first_words(&answer);
    assert!(words.len() <= 5, "{words:?}");
    let beginnings = ["Force transmitted at 3000 rpm", "Largest velocity of the point of the file"];
    for (line, beginning) in words.iter().zip(beginnings) {
        assert!(line.replace(['\u{202f}', '\u{a0}'], " ").starts_with(beginning), "{line}");
    }
    let last = words.last().expect("lines");
    // 60 · 14.62 Hz / 2 = 438.5.
    assert!(last.contains("14.6") && last.contains("438"), "{last}");
    // Orders that do not move the engine are named, and have no rows.
    let orders: Vec<String> = pages::tables(&answer)[0].iter().map(|row| row[0].clone()).collect();
    assert_eq!(orders, ["2", "4", "6"]);
}

#[test]
fn torsion_says_what_shakes_before_its_tables_and_shortens_long_ones() {
    let answer = answer("torsion", DAMPER);
    let words = first_words(&answer);
    assert!(words[0].contains("the first disc swings by"), "{words:?}");
    let position = |part: &str| words.iter().position(|line| line.contains(part)).expect("a line");
    assert!(position("highest peak") < position("Natural frequencies"), "{words:?}");
    let tables = pages::tables(&answer);
    assert!(tables.iter().all(|table| table.len() <= 8), "{tables:?}");
    // Of 24 orders those with the longest stars: multiples of three.
    let orders: Vec<&str> = tables[2].iter().map(|row| row[0].as_str()).collect();
    assert!(["3", "6", "9", "12"].iter().all(|order| orders.contains(order)), "{orders:?}");
    let Some(Block::Note(note)) = answer.blocks.last() else { panic!("no hint where the whole is") };
    assert!(text_in(note, Format::PLAIN).starts_with("8 orders of 24 are shown"), "{note:?}");
}

#[test]
fn a_viscous_damper_has_no_stiffness() {
    let study = report::ask("torsion", &engine(DAMPER), &[]).expect("a question").unwrap_or_else(|why| panic!("{why}"));
    let page = study.page();
    let dampers = pages::tables(&page).into_iter().find(|table| table[0].iter().any(|cell| cell == "as in the layout"));
    let dampers = dampers.expect("dampers");
    assert!(dampers.len() == 3 && dampers.iter().all(|row| row[2] == "none"), "{dampers:?}");
}
