//! Which crankshafts has the engine, and how are those that turn against the reference judged?

use super::super::roll_asked::roll_asked;
use super::super::typeset;
use crate::engine::{Engine, GearedCrank};
use crate::order;
use crate::page::{Block, Table, Text, phrase};
use crate::proof::Sense;
use crate::report::texts::engine as text;
use crate::verdict::Judgement;

/// The crankshafts, and the pins of the cylinders on them; nothing where there is one.
pub(super) fn crankshafts(engine: &Engine) -> Vec<Block> {
    let cranks = engine.geared_cranks();
    if cranks.is_empty() {
        return Vec::new();
    }
    let own = |index: usize| engine.cylinders().iter().filter(move |cylinder| cylinder.crank == index);
    let axis = |crank: &GearedCrank| {
        let terms = crank.axis.iter().map(|term| {
            phrase!("{} at {}", typeset::short(&term.weight), typeset::degrees(&typeset::signed_degrees(&term.angle)))
        });
        match (&crank.left_out, crank.axis.is_empty()) {
            (Some(_), _) => "not given".into(),
            (None, true) => "in the middle".into(),
            (None, false) => Text::joined(terms, " + "),
        }
    };
    let table = Table::of(cranks.iter().enumerate())
        .column("Crankshaft", |(_, crank)| crank.name.clone())
        .column("It turns", |(_, crank)| turns(crank))
        .column("Its axis, in crank radii", |(_, crank)| axis(crank))
        .column("Cylinders", |(index, _)| {
            typeset::names(&own(*index).map(|cylinder| cylinder.name.as_str()).collect::<Vec<_>>())
        })
        .column("Pins at θ = 0", |(index, _)| {
            let mut pins: Vec<String> =
                own(*index).map(|cylinder| typeset::angle(&engine.pin_angle(cylinder))).collect();
            pins.dedup();
            pins.join(", ")
        })
        .done();
    let mut blocks = vec![table.into()];
    if cranks.iter().any(|crank| crank.sense == Sense::Reverse) {
        blocks.push(text::mirrored_crank().into());
    }
    blocks.extend(engine.faster_crank().map(|_| Block::Paragraph(text::faster_crank())));
    let is_faster = engine.faster_crank().is_some();
    blocks.push(if is_faster { text::torque_and_roll_faster() } else { text::torque_and_roll() }.into());
    blocks
}

/// What the roll moment of geared crankshafts asks for; none where it is given, and where there is one crankshaft.
pub(super) fn roll_asked_of(engine: &Engine) -> Option<Text> {
    let is_geared = !engine.geared_cranks().is_empty();
    let missing = order::roll_lacks(engine).filter(|_| is_geared)?;
    Some(roll_asked(engine, missing))
}

/// Whether a roll moment rests on the flywheels, for a crankshaft turns against the reference, or faster: else it does not count which of them has one.
pub(super) fn has_flywheels(engine: &Engine, judged: &Judgement) -> bool {
    let is_apart = |crank: &GearedCrank| crank.sense == Sense::Reverse || crank.speed > 1;
    let has_roll = judged.orders.iter().any(|order| order.roll.is_some());
    has_roll && engine.geared_cranks().iter().any(is_apart)
}

fn turns(crank: &GearedCrank) -> Text {
    match (crank.sense, crank.speed) {
        (Sense::Direct, 1) => "with the reference".into(),
        (Sense::Reverse, 1) => "against the reference".into(),
        (sense, speed) => text::times_as_fast(speed, sense),
    }
}
