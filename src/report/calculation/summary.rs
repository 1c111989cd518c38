//! What does `loads` show on a terminal? The largest values, a row per order, and the peaks.

use super::super::residual;
use super::amounts::{self, Unit, amount, digits, in_digits};
use super::largest::{Numbers, chosen_lines, largest_lines, shown_line};
use super::roll::roll_lines;
use crate::engine::{DOES_NOT_EXIST, Engine, WHY_NOT};
use crate::loads::{Loads, Needed, OrderLoads, Outcome, Peak, Swing, TorqueOrder};
use crate::page::{Block, Document, Table, Text, phrase};
use crate::proof::Quantity;

/// The short answer: the largest force, moment and torque of each order, zero to peak, and of all orders.
pub fn loads_answer(engine: &Engine, numbers: &Numbers, needed: Option<&Needed>) -> Document {
    let mut page = Document::new("loads", engine.title());
    page.blocks.extend(at_speed(&numbers.loads).map(Block::Paragraph));
    page.push(by_order(engine, &numbers.loads));
    page.blocks.extend(lines(engine, numbers, needed).into_iter().map(Block::Paragraph));
    page
}

/// At which speed newtons are newtons.
pub(super) fn at_speed(loads: &Loads) -> Option<Text> {
    let scale = loads.scale.as_ref()?;
    Some(phrase!("At {} rpm.", super::super::typeset::short(&scale.speed)))
}

/// The largest force, moment and torque of each order, zero to peak.
pub(super) fn by_order(engine: &Engine, loads: &Loads) -> Table {
    let [force, moment, torque] =
        [Quantity::FORCE, Quantity::MOMENT, Quantity::TORQUE].map(|quantity| Unit::of_tables(engine, loads, quantity));
    let mut header: Vec<Text> =
        vec!["Order".into(), phrase!("Force in {}", force.label()), phrase!("Moment in {}", moment.label())];
    header.extend(loads.torque.as_ref().map(|_| phrase!("Torque in {}", torque.label())));
    header.extend(loads.roll.as_ref().map(|_| phrase!("Roll in {}", torque.label())));
    let mut table = Table::new(header);
    let mut all: Vec<u32> = loads.orders.iter().map(|order| order.order).collect();
    let turning = loads.torque.iter().chain(&loads.roll);
    all.extend(turning.flat_map(|torque| torque.orders.iter().map(|order| order.order)));
    all.sort_unstable();
    all.dedup();
    for order in all {
        let judged = loads.orders.iter().find(|loads| loads.order == order);
        let unjudged = match engine.pistons_have_order(Quantity::FORCE, order) {
            true => NOT_JUDGED,
            false => DOES_NOT_EXIST,
        };
        let swing = |part: fn(&OrderLoads) -> &Swing, unit: Unit| match judged {
            Some(order) if order.exists(engine) => amounts::largest(part(order), unit),
            Some(_) => DOES_NOT_EXIST.into(),
            None => unjudged.into(),
        };
        let mut cells = vec![order.into(), swing(|of| &of.force, force), swing(|of| &of.moment, moment)];
        cells.extend(loads.torque.as_ref().map(|all| {
            let of = all.orders.iter().find(|torque| torque.order == order);
            of.map_or_else(|| NOT_JUDGED.into(), |of| torque_cell(engine, of, torque))
        }));
        cells.extend(loads.roll.as_ref().map(|all| {
            let of = all.orders.iter().find(|roll| roll.order == order);
            of.map_or_else(|| NOT_JUDGED.into(), |of| roll_cell(engine, of, torque))
        }));
        table.push(cells);
    }
    table
}

/// What stands where nothing was decided.
const NOT_JUDGED: &str = "not decided";

/// The amplitude of an order of the torque, or that there is none.
pub(super) fn torque_cell(engine: &Engine, order: &TorqueOrder, unit: Unit) -> Text {
    match (engine.pistons_have_order(Quantity::TORQUE, order.order), &order.vector.outcome) {
        (false, _) => DOES_NOT_EXIST.into(),
        (true, Outcome::Zero) => Text::zero(),
        (true, Outcome::NotZero) => amount(order.vector.value.norm(), unit),
        (true, Outcome::Undecided { below }) => amounts::undecided(*below, unit),
    }
}

/// The amplitude of an order of the roll moment, which forces with arms make as well as torques.
pub(super) fn roll_cell(engine: &Engine, order: &TorqueOrder, unit: Unit) -> Text {
    let exists = [Quantity::TORQUE, Quantity::FORCE].iter().any(|part| engine.pistons_have_order(*part, order.order));
    match &order.vector.outcome {
        Outcome::Zero if !exists => DOES_NOT_EXIST.into(),
        Outcome::Zero => Text::zero(),
        Outcome::NotZero => amount(order.vector.value.norm(), unit),
        Outcome::Undecided { below } => amounts::undecided(*below, unit),
    }
}

/// What follows the table: the largest values, what the orders shown omit, the effects.
fn lines(engine: &Engine, numbers: &Numbers, needed: Option<&Needed>) -> Vec<Text> {
    let loads = &numbers.loads;
    let mut lines = vec!["Zero to peak; 0 is exact and proved, ≈ decimal.".into()];
    if loads.orders.iter().any(|order| !order.exists(engine)) {
        lines.push(WHY_NOT.into());
    }
    lines.extend(largest_lines(engine, numbers));
    lines.extend(roll_lines(engine, loads));
    lines.extend(super::books_line(engine, loads));
    lines.extend(shown_line(engine, numbers));
    lines.extend(chosen_lines(engine, numbers, needed));
    let names = loads.groups.iter().map(|group| residual::group_words(group.group).into());
    lines.push(phrase!("Included: {}.", Text::joined(names, ", ")));
    lines
}

/// A peak with its crank angle.
pub(super) fn peak(peak: &Peak, unit: Unit) -> Text {
    match peak.angle {
        _ if peak.value == 0.0 || unit.factor == 0.0 => Text::zero(),
        Some(angle) => {
            phrase!("≈ {} {} at θ ≈ {}°", in_digits(peak.value * unit.factor, unit), unit.label(), digits(angle))
        }
        None => phrase!("≈ {} {} at every crank angle", in_digits(peak.value * unit.factor, unit), unit.label()),
    }
}
