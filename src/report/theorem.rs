//! What does a report say of every order?

pub(super) use super::theorem_words::{no_theorem, statements, why};
use super::{recurrence_words, stars, table};
use crate::engine::Engine;
use crate::page::{Block, Fold};
use crate::proof::Planar;
use crate::report::texts::theorem as text;
use crate::verdict::{EveryOrderTheorem, NextLeft, NoTheorem, OrderVerdict};

/// Longer tables of one period are omitted.
const MOST_ROWS: usize = 24;

/// The statements on every order, why one period proves them, and the period.
pub(super) fn every_order(
    engine: &Engine,
    judged: &[OrderVerdict],
    theorem: &Result<EveryOrderTheorem, NoTheorem>,
) -> Vec<Block> {
    let mut blocks = Vec::new();
    match theorem {
        Err(reason) => blocks.push(Block::Paragraph(no_theorem(reason))),
        Ok(every @ EveryOrderTheorem::Recurrences(all)) => {
            blocks.push(Block::List(recurrence_words::statements(engine, all)));
            blocks.extend(next(judged, every));
            blocks.extend(recurrence_words::why(all).into_iter().map(Block::Paragraph));
        }
        Ok(every @ EveryOrderTheorem::Period(theorem)) => {
            blocks.push(Block::List(statements(engine, theorem)));
            blocks.extend(next(judged, every));
            blocks.push(Block::Paragraph(why(engine, theorem)));
            blocks.extend(stars::cited(engine).into_iter().map(Block::Paragraph));
            if theorem.force.direct.len() <= MOST_ROWS {
                let summary = "One period of orders".into();
                blocks.push(Block::Folded(Fold { summary, blocks: vec![table::period(theorem).into()] }));
            }
        }
    }
    blocks
}

/// The first order that is left beside those of the report; nothing where that is not known.
fn next(judged: &[OrderVerdict], theorem: &EveryOrderTheorem) -> Option<Block> {
    let told: Vec<u32> = judged.iter().map(|order| order.order).collect();
    match theorem.next_left(&Planar::BOTH, &told) {
        NextLeft::None => Some(Block::Paragraph(text::no_other_order())),
        NextLeft::Order(next) => Some(Block::Paragraph(text::next_order(next))),
        NextLeft::NotKnown => None,
    }
}
