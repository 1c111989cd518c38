//! What stands on the page of a shaft that twists, and on the terminal?

use super::{TorsionStudy, plots, tables, words};
use crate::page::{Block, Document, Text, phrase};

/// The short answer: frequencies and critical speeds.
pub fn torsion_answer(study: &TorsionStudy<'_>) -> Document {
    let mut answer_page = Document::new("torsion", study.engine.title());
    answer_page.push(tables::modes(study));
    answer_page.push(tables::critical(study));
    answer_page.blocks.extend(words::answer(study).into_iter().map(Block::Paragraph));
    answer_page
}

/// The page, with modes and a Campbell diagram.
pub fn torsion_page(study: &TorsionStudy<'_>) -> Document {
    let mut page = Document::new("torsion", phrase!("{}: torsional vibration", study.engine.title()));
    let section = |page: &mut Document, words: &'static str| page.push(Block::Heading(1, words.into()));
    page.push(Block::Answer(words::answer(study)));
    page.push(Block::Pictures(plots::campbell(study).into_iter().chain([plots::modes(study)]).collect()));
    section(&mut page, "Natural frequencies");
    page.push(tables::modes(study));
    section(&mut page, "Critical speeds");
    page.push(Block::Paragraph(
        "Where each order meets the first modes, and its star as a part of the longest that the mode can have:".into(),
    ));
    page.push(tables::critical(study));
    section(&mut page, "The shaft");
    page.push(tables::discs(study));
    section(&mut page, "How it is found");
    page.push(Block::Paragraph(words::FOUND.into()));
    section(&mut page, "Assumptions");
    page.push(Block::List(words::ASSUMED.map(Text::from).into()));
    page
}
