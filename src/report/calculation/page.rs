//! What is on the page of the loads? The largest values first, how they run through a revolution, then order by order.

use super::super::convention::{differs, seen};
use super::super::engine_page::reference_plane;
use super::amounts::{self, Unit, amount, digits, waveform};
use super::largest::{Numbers, largest_lines};
use super::{chosen, drawn, effects, ellipses, roll, summary, vectors, words};
use crate::accuracy::Largest;
use crate::engine::{Engine, WHY_NOT};
use crate::loads::{Loads, Needed};
use crate::numbers;
use crate::page::{Block, Document, Number, Text};
use crate::proof::{Planar, Quantity};
use crate::report::texts::loads as text;

/// The page: the largest force, moment and torque, their plots, their orders.
pub fn loads_page(engine: &Engine, numbers: &Numbers, needed: Option<&Needed>) -> Document {
    let loads = &numbers.loads;
    let page = text::Page {
        engine: engine.title().into(),
        answer: Block::Answer(answer(engine, numbers)).into(),
        drawn: drawn(engine, loads).into(),
        orders: by_order(engine, loads).into(),
        chosen: chosen(engine, numbers, needed).into(),
        ellipses: ellipses(engine, loads).into(),
        vectors: vectors(engine, loads).into(),
        turning: roll::turning(engine, loads).into(),
        effects: effects(engine, loads, words::Sections::None).into(),
        assumptions: words::assumptions(engine, loads).into(),
        limits: words::limits(engine, loads).into(),
        conventions: conventions(engine, loads).into(),
    };
    let document = page.document();
    match loads.torque {
        Some(_) => document,
        None => Document { title: text::without_torque(engine.title()), ..document },
    }
}

/// What is in the box.
fn answer(engine: &Engine, numbers: &Numbers) -> Vec<Text> {
    let Numbers { loads, largest, .. } = numbers;
    let mut lines = largest_lines(engine, numbers, Unit::as_read);
    let swings = [(Planar::Force, &largest.force), (Planar::Moment, &largest.moment)];
    lines.extend(swings.into_iter().filter_map(|(quantity, largest)| comes_to(engine, loads, quantity, largest)));
    let torque = loads.torque.as_ref().zip(largest.torque.as_ref()).filter(|(_, largest)| **largest != Largest::Zero);
    let listed = |peak| amounts::peak(&peak, Unit::as_read(engine, loads, Quantity::TORQUE));
    lines.extend(torque.map(|(torque, _)| text::torque_of_listed_orders(listed(torque.waveform.real_peak()))));
    lines.push(scale(engine, loads));
    lines
}

/// What the values are counted in, and at which speed.
fn scale(engine: &Engine, loads: &Loads) -> Text {
    let [force, moment] = Planar::BOTH.map(|quantity| Unit::as_read(engine, loads, quantity));
    match &loads.scale {
        Some(scale) => text::zero_to_peak(Number::exact(&scale.speed), amount(1.0, force), force.label()),
        None => text::without_scale(force.label(), moment.label()),
    }
}

/// A vector that is less well known than this part of its length has no direction to name.
const WELL_KNOWN: f64 = 1e-9;

/// The peak of the orders that are listed, with its direction; none where nothing is left, or what is left is not decided.
fn comes_to(engine: &Engine, loads: &Loads, quantity: Planar, largest: &Largest) -> Option<Text> {
    let unit = Unit::as_read(engine, loads, quantity);
    let peak = waveform(loads, quantity).peak();
    let doubt: f64 = loads.orders.iter().map(|order| order.swing(quantity).doubt()).sum();
    if *largest == Largest::Zero || doubt > WELL_KNOWN * peak.value {
        return None;
    }
    let listed = amounts::peak(&peak, unit);
    Some(match peak.angle.filter(|_| peak.value > 0.0 && unit.factor != 0.0) {
        Some(_) => text::points_to(quantity, listed, digits(direction(numbers::degrees(peak.vector)))),
        None => text::of_listed_orders(quantity, listed),
    })
}

/// In thousandths of a degree, half a turn by its one name.
fn direction(degrees: f64) -> f64 {
    let rounded = (degrees * 1e3).round() / 1e3 + 0.0;
    if rounded == -180.0 { 180.0 } else { rounded }
}

/// The largest value of each order, and why an order has none.
fn by_order(engine: &Engine, loads: &Loads) -> Vec<Block> {
    let mut blocks = vec![summary::by_order(engine, loads, Unit::as_read).into()];
    if loads.orders.iter().any(|order| !order.exists(engine)) {
        blocks.push(Block::Note(WHY_NOT.into()));
    }
    blocks
}

fn conventions(engine: &Engine, loads: &Loads) -> Vec<Text> {
    let mut lines = vec![seen(engine.convention())];
    lines.extend(differs(engine.convention()));
    lines.extend([reference_plane(engine), text::moments()]);
    lines.extend(loads.torque.as_ref().map(|_| text::on_crankshaft()));
    lines
}
