//! What is right, and why? The tables filled in, with the proof of each sum.

use super::super::engine_page::proofs;
use super::sheet::given;
use crate::classroom::Pupil;
use crate::engine::NotAnOrder;
use crate::page::{Block, Document};
use crate::proof::Quantity;
use crate::report::texts::solutions as text;
use crate::verdict::Judgement;

/// The solutions of a student's sheet.
///
/// # Errors
/// If there is no such order.
pub fn exercise_solutions(pupil: &Pupil, orders: &[u32]) -> Result<Document, NotAnOrder> {
    let judged = Judgement::new(&pupil.engine, orders, &Quantity::PLANAR)?;
    let page = text::Page {
        student: (&pupil.name).into(),
        given: given(pupil).into(),
        proofs: proofs(&pupil.engine, &judged).into(),
        layout: Block::Verbatim("toml", pupil.engine.file().clone()).into(),
    };
    Ok(page.document())
}
