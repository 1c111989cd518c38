//! What does `loads` show on a terminal? The largest values, a row per order, and the peaks.

use super::super::engine_page::Weighing;
use super::super::residual;
use super::super::table::with_shared_rows;
use super::amounts::{self, Unit, UnitOf, roll_cell, torque_cell};
use super::largest::{Numbers, chosen_lines, largest_lines, shown_line};
use super::roll::roll_lines;
use crate::engine::{DOES_NOT_EXIST, Engine, WHY_NOT};
use crate::loads::{Loads, Needed, OrderLoads, Swing, Torque};
use crate::page::{Block, Document, Table, Text, phrase};
use crate::proof::Quantity;

/// The short answer: the largest force, moment and torque of each order, zero to peak, and of all orders. Scripts read its numbers, so that it counts
/// as the document does: in newtons, however many.
pub fn loads_answer(engine: &Engine, numbers: &Numbers, needed: Option<&Needed>) -> Document {
    loads_answer_weighed(engine, numbers, needed, None)
}

/// The same; neighbouring orders that are small share a row.
pub(in crate::report) fn loads_answer_weighed(
    engine: &Engine,
    numbers: &Numbers,
    needed: Option<&Needed>,
    weighing: Option<&Weighing>,
) -> Document {
    let mut page = Document::new("loads", engine.title());
    page.blocks.extend(at_speed(&numbers.loads).map(Block::Paragraph));
    let table = by_order(engine, &numbers.loads, Unit::of);
    page.push(match weighing {
        Some(weighing) => with_shared_rows(table, &are_small(engine, &numbers.loads, weighing)),
        None => table,
    });
    page.blocks.extend(lines(engine, numbers, needed).into_iter().map(Block::Paragraph));
    page
}

/// At which speed newtons are newtons.
pub(super) fn at_speed(loads: &Loads) -> Option<Text> {
    let scale = loads.scale.as_ref()?;
    Some(phrase!("At {} rpm.", super::super::typeset::short(&scale.speed)))
}

/// The largest force, moment and torque of each order, zero to peak.
pub(super) fn by_order(engine: &Engine, loads: &Loads, unit_of: UnitOf) -> Table {
    let [force, moment, torque] =
        [Quantity::FORCE, Quantity::MOMENT, Quantity::TORQUE].map(|quantity| unit_of(engine, loads, quantity));
    let mut header: Vec<Text> =
        vec!["Order".into(), phrase!("Force in {}", force.label()), phrase!("Moment in {}", moment.label())];
    header.extend(loads.torque.as_ref().map(|_| phrase!("Torque in {}", torque.label())));
    header.extend(loads.roll.as_ref().map(|_| phrase!("Roll in {}", torque.label())));
    let mut table = Table::new(header);
    for order in orders(loads) {
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

/// All orders that have a row, rising.
fn orders(loads: &Loads) -> Vec<u32> {
    let turning = loads.torque.iter().chain(&loads.roll).flat_map(|torque| &torque.orders).map(|order| order.order);
    let mut all: Vec<u32> = loads.orders.iter().map(|order| order.order).chain(turning).collect();
    all.sort_unstable();
    all.dedup();
    all
}

/// Of each row, whether something is left of its order and all of that is below the threshold of its quantity.
fn are_small(engine: &Engine, loads: &Loads, weighing: &Weighing) -> Vec<bool> {
    let planar = |part: fn(&OrderLoads) -> &Swing| -> Vec<(u32, f64)> {
        loads.orders.iter().map(|order| (order.order, part(order).largest())).collect()
    };
    let axial = |torque: &Option<Torque>| -> Vec<(u32, f64)> {
        let orders = torque.iter().flat_map(|torque| &torque.orders);
        orders.map(|order| (order.order, order.vector.value.norm())).collect()
    };
    let all = [
        (Quantity::FORCE, planar(|of| &of.force)),
        (Quantity::MOMENT, planar(|of| &of.moment)),
        (Quantity::TORQUE, axial(&loads.torque)),
        (Quantity::ROLL, axial(&loads.roll)),
    ];
    let limits = all.map(|(quantity, sizes)| {
        let most = sizes.iter().map(|(_, size)| *size).fold(0.0, f64::max);
        (weighing.limit(engine, quantity, most), sizes)
    });
    let is_small = |order: u32| {
        let of_order = |size: &&(u32, f64)| size.0 == order && size.1 > 0.0;
        limits.iter().any(|(_, sizes)| sizes.iter().any(|size| of_order(&size)))
            && limits.iter().all(|(limit, sizes)| sizes.iter().filter(of_order).all(|(_, size)| size < limit))
    };
    orders(loads).into_iter().map(|order| !weighing.tells_all(engine) && is_small(order)).collect()
}

/// What stands of an order that is there for another quantity alone.
const NOT_JUDGED: &str = "not computed";

/// What follows the table: the largest values, what the orders shown omit, the effects.
fn lines(engine: &Engine, numbers: &Numbers, needed: Option<&Needed>) -> Vec<Text> {
    let loads = &numbers.loads;
    let mut lines = vec!["Zero to peak; 0 is exact and proved, ≈ decimal.".into()];
    if loads.orders.iter().any(|order| !order.exists(engine)) {
        lines.push(WHY_NOT.into());
    }
    lines.extend(largest_lines(engine, numbers, Unit::of));
    lines.extend(roll_lines(engine, loads, Unit::of));
    lines.extend(super::books_line(engine, loads, Unit::of));
    lines.extend(shown_line(engine, numbers));
    lines.extend(chosen_lines(engine, numbers, needed, Unit::of));
    let names = loads.groups.iter().map(|group| residual::group_words(group.group).into());
    lines.push(phrase!("Included: {}.", Text::joined(names, ", ")));
    lines
}
