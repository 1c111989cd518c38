//! Which crankshafts has the engine, and how are those that turn against the reference judged?

use super::super::roll_asked::roll_asked;
use super::super::typeset;
use crate::engine::{Engine, GearedCrank};
use crate::order;
use crate::page::{Block, Table, Text, phrase};
use crate::proof::Sense;
use crate::verdict::Judgement;

/// The crankshafts, and the pins of the cylinders on them; nothing where there is one.
pub(super) fn section(engine: &Engine) -> Vec<Block> {
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
        blocks.push(Block::Paragraph(
            "A piston moves the same on a crank that turns against the reference and on the mirror image of that crank in the cylinder's axis, which turns with the reference: throw 2α − β in place of β. The throws of the table of cylinders are those of these equivalent cranks, so that force, moment and torque are decided as of one crankshaft."
                .into(),
        ));
    }
    if engine.faster_crank().is_some() {
        blocks.push(Block::Paragraph(
            "A crankshaft that turns ν times while the reference turns once takes part only in the orders that ν divides: its own order j is order νj of the engine, with ν² times the force. Its rotating masses have order ν."
                .into(),
        ));
    }
    let words = if engine.faster_crank().is_none() { TORQUE_AND_ROLL } else { AT_SEVERAL_SPEEDS };
    blocks.push(Block::Paragraph(words.into()));
    blocks
}

/// What the roll moment of geared crankshafts asks for; none where it is given, and where there is one crankshaft.
pub(super) fn roll_asked_of(engine: &Engine) -> Option<Text> {
    let is_geared = !engine.geared_cranks().is_empty();
    let missing = order::roll_lacks(engine).filter(|_| is_geared)?;
    Some(roll_asked(engine, missing))
}

/// What a roll moment rests on where a crankshaft turns against the reference, or faster: else it does not count which of them has a flywheel.
pub(super) fn flywheels(engine: &Engine, judged: &Judgement) -> Option<&'static str> {
    let is_apart = |crank: &GearedCrank| crank.sense == Sense::Reverse || crank.speed > 1;
    let has_roll = judged.orders.iter().any(|order| order.roll.is_some());
    (has_roll && engine.geared_cranks().iter().any(is_apart)).then_some(FLYWHEELS)
}

const FLYWHEELS: &str = "The roll moment assumes that each crankshaft has its own flywheel and constant speed, so that the gears transmit no alternating torque.";

const TORQUE_AND_ROLL: &str = "The torque is that of all crankshafts together at the reference one, to which they are geared one to one. The roll moment is the moment on the frame about the origin of the layout, from which the axes of its crankshafts are counted: each piston's force times the arm of its axis, and the torque on its crank reversed. Assumed: each crankshaft has its own flywheel and constant speed, so that the gears transmit no alternating torque; with one flywheel at the reference crankshaft the frame takes the reversed torque instead of the sum of those on the cranks.";
const AT_SEVERAL_SPEEDS: &str = "The torque is that of all crankshafts together at the reference one, where that on a faster one counts as often as it turns. The roll moment is the moment on the frame about the origin of the layout, from which the axes of its crankshafts are counted: each piston's force times the arm of its axis, and the torque on its crank reversed. Assumed: each crankshaft has its own flywheel and constant speed, so that the gears transmit no alternating torque.";

fn turns(crank: &GearedCrank) -> Text {
    match (crank.sense, crank.speed) {
        (Sense::Direct, 1) => "with the reference".into(),
        (Sense::Reverse, 1) => "against the reference".into(),
        (sense, speed) => phrase!("{} times as fast, {with|against} the reference", speed, sense),
    }
}
