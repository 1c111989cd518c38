//! What stands on the page of an engine on its mounts, and on the terminal?

use super::{MountsStudy, Place, plots, tables, words};
use crate::page::{Block, Document};
use crate::report::texts::mounts as text;

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
    text::Page {
        engine: study.engine.title().into(),
        answer: Block::Answer(words::answer(study)).into(),
        notes: words::notes(study).into(),
        pictures: Block::Pictures(plots::pictures(study)).into(),
        modes: tables::modes(study).into(),
        symmetry: words::mirrors(study).into_iter().collect(),
        critical_speeds: tables::critical(study).into(),
        speed: words::rpm(study.speed),
        orders: tables::orders(study).into(),
        motions: tables::motions(study).into(),
        rms: tables::rms(study).into(),
        forces: tables::forces(study).into(),
        place: (study.watched() == Place::Point).into(),
        range: tables::range(study).into(),
        torque_roll_axis: std::iter::once(text::free_body()).chain(words::axis(study)).collect(),
        mounts: tables::mounts(study).into(),
    }
    .document()
}
