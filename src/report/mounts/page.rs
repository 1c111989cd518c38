//! What stands on the page of an engine on its mounts, and on the terminal?

use super::{MountsStudy, Place, plots, tables, words};
use crate::page::{Block, Document, Text, phrase};

const SHARES: &str = "Frequencies, and the parts of the kinetic energy of each mode; a part may be below 0 where motions are coupled by the products of inertia:";

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
    page.push(Block::Answer(words::answer(study)));
    page.blocks.extend(words::notes(study).into_iter().map(Block::Note));
    page.push(Block::Pictures(plots::pictures(study)));
    page.section("Natural frequencies", SHARES);
    page.push(tables::modes(study));
    page.blocks.extend(words::mirrors(study).into_iter().map(Block::Paragraph));
    page.push("Speeds at which an order that moves the engine meets a mode:");
    page.push(tables::critical(study));
    page.section(
        "What shakes",
        phrase!("Forces and moments about the centre of gravity at {}:", words::rpm(study.speed)),
    );
    page.push(tables::orders(study));
    page.push(words::STILL);
    page.section("Motion", phrase!("Motion of the centre of gravity at {}, order by order:", words::rpm(study.speed)));
    page.push(tables::motions(study));
    page.push("All orders shown together, rms:");
    page.push(tables::rms(study));
    page.section("Mount forces", phrase!("Force transmitted by each mount at {}:", words::rpm(study.speed)));
    page.push(tables::forces(study));
    page.section("Over the speed", phrase!(
        "The largest velocity of {the point of the file|the centre of gravity} and the largest mount force along one axis in the range, and where they are:",
        study.watched() == Place::Point
    ));
    page.push(tables::range(study));
    page.section("The torque-roll axis", words::AXIS);
    page.blocks.extend(words::axis(study).map(Block::Paragraph));
    page.section("The mounts", tables::mounts(study));
    page.section("Method", words::FOUND);
    page.section("Assumptions", Block::List(words::ASSUMED.map(Text::from).into()));
    page
}
