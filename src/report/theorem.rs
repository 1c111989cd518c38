//! What does a report say of every order?

pub(super) use super::theorem_words::{no_theorem, statements, why};
use super::{recurrence_words, stars, table};
use crate::engine::Engine;
use crate::page::{Block, Fold};
use crate::verdict::{EveryOrderTheorem, NoTheorem};

/// Longer tables of one period are left out.
const MOST_ROWS: usize = 24;

/// The section on every order: the statements, why one period proves them, and the period.
pub(super) fn section(engine: &Engine, theorem: &Result<EveryOrderTheorem, NoTheorem>) -> Vec<Block> {
    let mut blocks = vec![Block::Heading(1, "Every order".into())];
    match theorem {
        Err(reason) => blocks.push(Block::Paragraph(no_theorem(reason))),
        Ok(EveryOrderTheorem::Recurrences(all)) => {
            blocks.push(Block::List(recurrence_words::statements(engine, all)));
            blocks.extend(recurrence_words::why(all).into_iter().map(Block::Paragraph));
        }
        Ok(EveryOrderTheorem::Period(theorem)) => {
            blocks.push(Block::List(statements(engine, theorem)));
            blocks.push(Block::Paragraph(why(engine, theorem)));
            blocks.extend(stars::cited(engine).map(Block::Paragraph));
            if theorem.force.direct.len() <= MOST_ROWS {
                let summary = "One period of orders".into();
                blocks.push(Block::Folded(Fold { summary, blocks: vec![table::period(theorem).into()] }));
            }
        }
    }
    blocks
}
