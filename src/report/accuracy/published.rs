//! What stands on a page of errors alone, of several engines at several rod ratios? The same on every machine.

use super::page::of_bearings;
use super::{AccuracyCase, bearings, case, plots, tables, words};
use crate::accuracy::Study;
use crate::engine::Engine;
use crate::page::{Block, Document, Text, phrase};

/// The page.
pub fn accuracy_errors_page(engines: &[(Engine, Vec<AccuracyCase>)]) -> Document {
    let mut page = Document::new("README", "What accuracy costs");
    let answer = engines.iter().flat_map(|(engine, cases)| {
        words::orders_needed(engine, cases)
            .into_iter()
            .chain(bearings::orders_needed(engine, &of_bearings(cases).collect::<Vec<_>>()))
    });
    page.push(Block::Answer(answer.collect()));
    for (number, (engine, cases)) in engines.iter().enumerate() {
        page.push(Block::Heading(1, engine.title().into()));
        for place in 0..case::loads_of(cases) {
            let studies: Vec<(Text, &Study)> = cases.iter().map(|case| (case.label(), &case.studies[place])).collect();
            if studies.iter().all(|(_, study)| !study.rows.is_empty()) {
                page.blocks.extend(plots::orders(number + 1, engine, &studies).map(Block::from));
            }
        }
        page.blocks.extend(tables::errors(cases));
        page.blocks.extend(bearings::errors(&of_bearings(cases).collect::<Vec<_>>()));
    }
    page.push(Block::Heading(1, "How the methods work".into()));
    page.push(Block::List(words::METHODS.into_iter().chain([words::NO_TIMES]).map(Text::from).collect()));
    let command = Text::code("crankstar accuracy LAYOUT --rod-ratio 0.1,0.3");
    page.push(Block::Paragraph(phrase!("{} compares the methods for another engine, with their times.", command)));
    page
}
