//! How does the frame roll? The largest roll moment of the orders listed, what it is, and its orders.

use super::super::roll_asked::roll_asked;
use super::amounts::{self, Unit, UnitOf};
use super::tables;
use crate::engine::Engine;
use crate::loads::{Loads, Outcome};
use crate::page::{Block, Text};
use crate::proof::{Axial, Quantity};
use crate::report::texts::loads as text;

/// What is said of the roll moment: its largest value, and what it is, or what it lacks; nothing where the frame feels no more than the torque
/// turned round.
pub(super) fn roll_lines(engine: &Engine, loads: &Loads, unit_of: UnitOf) -> Vec<Text> {
    let Some(roll) = &loads.roll else {
        return loads.roll_lacks.map(|missing| roll_asked(engine, missing)).into_iter().collect();
    };
    let unit = unit_of(engine, loads, Quantity::ROLL);
    let words = if engine.geared_cranks().is_empty() { text::roll_of_one() } else { text::roll_of_several() };
    let all_vanish = roll.orders.iter().all(|order| order.vector.outcome == Outcome::Zero);
    let peak = if all_vanish { Text::zero() } else { amounts::peak(&roll.waveform.real_peak(), unit) };
    vec![text::roll(peak), words]
}

/// The orders of the inertia torque and of the roll moment, for a page, as far as they are known.
pub(super) fn turning(engine: &Engine, loads: &Loads) -> Vec<Block> {
    let torque = loads.torque.iter().flat_map(|torque| {
        let table = tables::about_the_axis(engine, loads, Axial::Torque, torque);
        [Block::Heading(2, "Orders of the inertia torque".into()), table.into()]
    });
    torque.chain(roll_section(engine, loads)).collect()
}

/// The orders of the roll moment.
fn roll_section(engine: &Engine, loads: &Loads) -> Vec<Block> {
    let lines = roll_lines(engine, loads, Unit::as_read);
    if lines.is_empty() {
        return Vec::new();
    }
    let said = Block::Paragraph(Text::joined(lines, " "));
    let table = loads.roll.as_ref().map(|roll| tables::about_the_axis(engine, loads, Axial::Roll, roll).into());
    [Block::Heading(2, "Orders of the roll moment".into()), said].into_iter().chain(table).collect()
}
