//! What does `loads` show on a terminal? The largest values, a row per order, and the peaks.

use super::super::engine_page::Weighing;
use super::super::residual;
use super::super::table::with_shared_rows;
use super::amounts::{self, Unit, UnitOf, about_the_axis, axial_cell};
use super::largest::{Numbers, chosen_lines, largest_lines, shown_line};
use super::roll::roll_lines;
use crate::engine::{DOES_NOT_EXIST, Engine, WHY_NOT};
use crate::loads::{Loads, Needed};
use crate::page::{Block, Document, Table, Text, phrase};
use crate::proof::{Axial, Planar, Quantity};
use crate::report::rising;
use crate::report::texts::loads as text;

/// The short answer: the largest force, moment and torque of each order, zero to peak, and of all orders. Scripts read its numbers, so that it counts
/// as the document does: in newtons, however many. Where it is weighed, neighbouring orders that are small share a row.
pub fn loads_answer(
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
    let swing = |order: u32, quantity: Planar, unit: Unit| -> Text {
        match loads.orders.iter().find(|loads| loads.order == order) {
            Some(order) if order.exists(engine) => amounts::largest(order.swing(quantity), unit),
            None if engine.pistons_have_order(Quantity::FORCE, order) => NOT_JUDGED.into(),
            Some(_) | None => DOES_NOT_EXIST.into(),
        }
    };
    let turning = |order: u32, quantity: Axial| -> Text {
        let mut all = about_the_axis(loads, quantity).into_iter().flat_map(|torque| &torque.orders);
        let of = all.find(|torque| torque.order == order);
        of.map_or_else(|| NOT_JUDGED.into(), |of| axial_cell(engine, quantity, of, torque))
    };
    let [has_torque, has_roll] = [loads.torque.is_some(), loads.roll.is_some()];
    Table::of(orders(loads))
        .column("Order", |order| *order)
        .column(phrase!("Force in {}", force.label()), |order| swing(*order, Planar::Force, force))
        .column(phrase!("Moment in {}", moment.label()), |order| swing(*order, Planar::Moment, moment))
        .column_if(has_torque, phrase!("Torque in {}", torque.label()), |order| turning(*order, Axial::Torque))
        .column_if(has_roll, phrase!("Roll in {}", torque.label()), |order| turning(*order, Axial::Roll))
        .done()
}

/// All orders that have a row, rising.
fn orders(loads: &Loads) -> Vec<u32> {
    let turning = loads.torque.iter().chain(&loads.roll).flat_map(|torque| &torque.orders).map(|order| order.order);
    rising(loads.orders.iter().map(|order| order.order).chain(turning))
}

/// Of each row, whether something is left of its order and all of that is below the threshold of its quantity.
fn are_small(engine: &Engine, loads: &Loads, weighing: &Weighing) -> Vec<bool> {
    let sizes = |quantity: Quantity| -> Vec<(u32, f64)> {
        match quantity {
            Quantity::Planar(of) => loads.orders.iter().map(|order| (order.order, order.swing(of).largest())).collect(),
            Quantity::Axial(of) => {
                let orders = about_the_axis(loads, of).into_iter().flat_map(|torque| &torque.orders);
                orders.map(|order| (order.order, order.vector.value.norm())).collect()
            }
        }
    };
    let limits = Quantity::ALL.map(|quantity| {
        let sizes = sizes(quantity);
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
    let mut lines = vec![text::signs()];
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
