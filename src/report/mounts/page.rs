//! What stands on the page of an engine on its mounts, and on the terminal?

use super::{MountsStudy, Place, plots, tables, words};
use crate::page::{Block, Document, Text, phrase};

/// The short answer: what shakes, then orders, motions and modes.
pub(super) fn answer(study: &MountsStudy) -> Document {
    let mut answer = Document::new("mounts", study.engine.title());
    answer.blocks.extend(words::answer(study).into_iter().map(Block::Paragraph));
    answer.blocks.extend(words::notes(study).into_iter().map(Block::Note));
    answer.push(tables::orders_that_move(study));
    answer.push(tables::motions(study));
    answer.push(tables::modes(study));
    answer
}

/// The page.
pub(super) fn page(study: &MountsStudy) -> Document {
    let mut page = Document::new("mounts", phrase!("{}: on its mounts", study.engine.title()));
    let section = |page: &mut Document, words: &'static str| page.push(Block::Heading(1, words.into()));
    page.push(Block::Answer(words::answer(study)));
    page.blocks.extend(words::notes(study).into_iter().map(Block::Note));
    page.push(Block::Pictures(plots::pictures(study)));
    section(&mut page, "Natural frequencies");
    page.push(Block::Paragraph("Frequencies, and the parts of the kinetic energy of each mode; a part may be below 0 where motions are coupled by the products of inertia:".into()));
    page.push(tables::modes(study));
    page.blocks.extend(words::mirrors(study).into_iter().map(Block::Paragraph));
    page.push(Block::Paragraph("Speeds at which an order that moves the engine meets a mode:".into()));
    page.push(tables::critical(study));
    section(&mut page, "What shakes");
    page.push(Block::Paragraph(phrase!(
        "Forces and moments about the centre of gravity at {}:",
        words::rpm(study.speed)
    )));
    page.push(tables::orders(study));
    page.push(Block::Paragraph(words::STILL.into()));
    section(&mut page, "Motion");
    page.push(Block::Paragraph(phrase!(
        "Motion of the centre of gravity at {}, order by order:",
        words::rpm(study.speed)
    )));
    page.push(tables::motions(study));
    page.push(Block::Paragraph("All orders shown together, rms:".into()));
    page.push(tables::rms(study));
    section(&mut page, "Mount forces");
    page.push(Block::Paragraph(phrase!("Force transmitted by each mount at {}:", words::rpm(study.speed))));
    page.push(tables::forces(study));
    section(&mut page, "Over the speed");
    page.push(Block::Paragraph(phrase!(
        "The largest velocity of {the point of the file|the centre of gravity} and the largest mount force along one axis in the range, and where they are:",
        study.watched() == Place::Point
    )));
    page.push(tables::range(study));
    section(&mut page, "The torque-roll axis");
    page.push(Block::Paragraph(words::AXIS.into()));
    page.blocks.extend(words::axis(study).map(Block::Paragraph));
    section(&mut page, "The mounts");
    page.push(tables::mounts(study));
    section(&mut page, "Method");
    page.push(Block::Paragraph(words::FOUND.into()));
    section(&mut page, "Assumptions");
    page.push(Block::List(words::ASSUMED.map(Text::from).into()));
    page
}
