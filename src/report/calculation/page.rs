//! What is on the page of the loads? The largest values first, how they run through a revolution, then order by order.

use super::super::convention::{differs, seen};
use super::super::engine_page::reference_plane;
use super::amounts::{self, Unit, amount, digits, waveform};
use super::largest::{Numbers, largest_lines};
use super::{SHARES, chosen, drawn, heading, roll, summary, tables, words};
use crate::accuracy::Largest;
use crate::engine::{Engine, WHY_NOT};
use crate::loads::{Loads, Needed};
use crate::numbers;
use crate::page::{Block, Document, Number, Text, phrase};
use crate::proof::{Planar, Quantity};

/// The page: the largest force, moment and torque, their plots, their orders.
pub fn loads_page(engine: &Engine, numbers: &Numbers, needed: Option<&Needed>) -> Document {
    let loads = &numbers.loads;
    let title = match loads.torque {
        Some(_) => phrase!("{}: forces, moments and torque", engine.title()),
        None => phrase!("{}: forces and moments", engine.title()),
    };
    let mut page = Document::new("loads", title);
    page.push(Block::Answer(answer(engine, numbers)));
    page.blocks.extend(drawn(engine, loads));
    page.blocks.extend(order_by_order(engine, numbers, needed));
    page.blocks.extend([heading(1, "Effects included"), tables::effects(engine, loads).into()]);
    page.push(Block::Note(SHARES.into()));
    page.blocks.extend([heading(1, "Assumptions"), Block::List(words::assumptions(engine, loads))]);
    page.blocks.extend([heading(1, "Limits of validity"), Block::List(words::limits(engine, loads))]);
    page.blocks.extend([heading(1, "Conventions"), Block::List(conventions(engine, loads))]);
    page
}

/// What is in the box.
fn answer(engine: &Engine, numbers: &Numbers) -> Vec<Text> {
    let Numbers { loads, largest, .. } = numbers;
    let mut lines = largest_lines(engine, numbers, Unit::as_read);
    let swings = [(Planar::Force, &largest.force), (Planar::Moment, &largest.moment)];
    lines.extend(swings.into_iter().filter_map(|(quantity, largest)| comes_to(engine, loads, quantity, largest)));
    let torque = loads.torque.as_ref().zip(largest.torque.as_ref()).filter(|(_, largest)| **largest != Largest::Zero);
    let listed = |peak| amounts::peak(&peak, Unit::as_read(engine, loads, Quantity::TORQUE));
    lines.extend(torque.map(|(torque, _)| phrase!(TORQUE, listed(torque.waveform.real_peak()))));
    lines.push(scale(engine, loads));
    lines
}

/// What the values are counted in, and at which speed.
fn scale(engine: &Engine, loads: &Loads) -> Text {
    let [force, moment] = Planar::BOTH.map(|quantity| Unit::as_read(engine, loads, quantity));
    match &loads.scale {
        Some(scale) => phrase!(
            "The values are zero to peak, at {} rpm, where m r ω² is {} {}.",
            Number::exact(&scale.speed),
            amount(1.0, force),
            force.label()
        ),
        None => phrase!(
            "The values are zero to peak, forces in {}, moments in {}: the layout does not give mass, crank radius and speed together.",
            force.label(),
            moment.label()
        ),
    }
}

const TORQUE: &str = "The inertia torque of the listed orders is {}.";

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
        Some(_) => phrase!(
            "The {force|moment} of the listed orders is {} and points to ≈ {}° there.",
            quantity,
            listed,
            digits(direction(numbers::degrees(peak.vector)))
        ),
        None => phrase!("The {force|moment} of the listed orders is {}.", quantity, listed),
    })
}

/// In thousandths of a degree, half a turn by its one name.
fn direction(degrees: f64) -> f64 {
    let rounded = (degrees * 1e3).round() / 1e3 + 0.0;
    if rounded == -180.0 { 180.0 } else { rounded }
}

/// The tables of the orders.
fn order_by_order(engine: &Engine, numbers: &Numbers, needed: Option<&Needed>) -> Vec<Block> {
    let loads = &numbers.loads;
    let mut blocks = vec![heading(1, "Order by order"), Block::Paragraph("The largest value of each order:".into())];
    blocks.push(summary::by_order(engine, loads, Unit::as_read).into());
    if loads.orders.iter().any(|order| !order.exists(engine)) {
        blocks.push(Block::Note(WHY_NOT.into()));
    }
    blocks.extend(chosen(engine, numbers, needed));
    blocks.extend([heading(2, "The ellipse of each order"), tables::ellipses(engine, loads).into()]);
    blocks.push(Block::Note(tables::units(engine, loads)));
    blocks.push(heading(2, "The two vectors of each order, whose lengths add up to the largest value"));
    blocks.push(tables::vectors(engine, loads).into());
    blocks.extend(roll::turning(engine, loads));
    blocks
}

const MOMENTS: &str =
    "A moment points where a single force with the same moment points that acts between that plane and the free end.";
const ON_CRANKSHAFT: &str =
    "The inertia torque is that on the crankshaft; on the frame it acts with the opposite sign.";

fn conventions(engine: &Engine, loads: &Loads) -> Vec<Text> {
    let mut lines = vec![seen(engine.convention())];
    lines.extend(differs(engine.convention()));
    lines.extend([reference_plane(engine), MOMENTS.into()]);
    lines.extend(loads.torque.as_ref().map(|_| ON_CRANKSHAFT.into()));
    lines
}
