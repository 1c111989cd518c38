//! What is right, and why? The tables filled in, with the proof of each sum.

use super::super::engine_page::proofs;
use super::sheet::given;
use crate::classroom::Pupil;
use crate::engine::NotAnOrder;
use crate::page::{Block, Document, phrase};
use crate::proof::Quantity;
use crate::verdict::Judgement;

/// The solutions of a student's sheet.
///
/// # Errors
/// If there is no such order.
pub fn exercise_solutions(pupil: &Pupil, orders: &[u32]) -> Result<Document, NotAnOrder> {
    let judged = Judgement::new(&pupil.engine, orders, &Quantity::PLANAR)?;
    let mut page = Document::new("solutions", phrase!("Vector-star exercise: {}, solutions", &pupil.name));
    page.blocks.extend(given(pupil));
    page.blocks.extend(proofs(&pupil.engine, &judged));
    page.section("Layout file", Block::Verbatim("toml", pupil.engine.file().clone()));
    Ok(page)
}
