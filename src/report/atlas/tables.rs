//! How are the numbers of an engine written in the tables of the atlas?

use super::super::residual::shape_name;
use super::super::typeset::Amount;
use super::entry::{EngineRow, Order, Origin, REMEDIED, Remaining, Ties};
use crate::engine::Cycle;
use crate::numbers::Form;
use crate::page::{Columns, Number, Table, Text, phrase};
use crate::proof::{Planar, Shape};
use crate::report::texts::atlas as text;

/// Longer closed forms are not in the tables.
const LONGEST_IN_TABLE: usize = 24;

/// What each engine of the catalogue is, leaves first, and needs.
pub(super) fn known(engines: &[&EngineRow]) -> Table {
    let table = Table::of(engines.iter().copied())
        .column("Name", |engine| name(engine))
        .column("Engine", |engine| &engine.title)
        .column("Firing", |engine| engine.firing.clone());
    with_needs(table)
}

/// What an engine leaves first, and needs.
fn with_needs(table: Columns<&EngineRow>) -> Table {
    table
        .column("Force from order", |engine| engine.first_left[0].clone())
        .column("Moment from order", |engine| engine.first_left[1].clone())
        .column("Remedy", |engine| engine.remedy.clone())
        .done()
}

/// The same of the stars that were found, with how many are as good.
pub(super) fn found(engines: &[&EngineRow]) -> Table {
    let table = Table::of(engines.iter().copied())
        .column("Star", |engine| name(engine))
        .column("Throws", |engine| &engine.title)
        .column("As good", |engine| engine.ties.as_ref().map(ties).unwrap_or_default());
    with_needs(table)
}

/// The largest force or moment of each engine at these orders.
pub(super) fn by_order(engines: &[&EngineRow], quantity: Planar, orders: &[u32]) -> Table {
    let first = match engines.first().map(|engine| engine.origin) {
        Some(Origin::Found(_)) => "Star",
        Some(Origin::Catalogue) | None => "Name",
    };
    let table = Table::of(engines.iter().copied()).column(first, |engine| name(engine));
    let with_orders = orders.iter().fold(table, |table, order| {
        table.column(phrase!("Order {}", *order), |engine| {
            let judged = engine.orders.iter().find(|judged| judged.order == *order);
            judged.map(|judged| cell(engine, judged, quantity)).unwrap_or_default()
        })
    });
    with_orders.done()
}

fn name(engine: &EngineRow) -> Text {
    match (engine.origin, &engine.report) {
        (Origin::Catalogue, Some(report)) => Text::link(Text::label(engine.name.clone()), report.clone()),
        (Origin::Catalogue, None) => Text::label(engine.name.clone()),
        (Origin::Found(_), _) => phrase!("{}: {}", engine.name.clone(), engine.firing_order.clone()),
    }
}

/// How many stars are as good.
fn ties(Ties { stars, all, tied }: &Ties) -> Text {
    match tied {
        None => phrase!("{} of {} stars", stars.to_string(), all.to_string()),
        Some(classes) => text::tied(stars.to_string(), all.to_string(), classes.to_string()),
    }
}

/// The largest value; its shape too, but for stars in line, which leave nothing but what is planar.
fn cell(engine: &EngineRow, order: &Order, quantity: Planar) -> Text {
    let left = part(order, quantity);
    if left.shape == Shape::Balanced {
        return Text::zero();
    }
    let Some(largest) = &left.largest else { return phrase!("not 0, {}", shape_name(left.shape)) };
    let exact = largest.exact.clone().filter(|form| letters(form) <= LONGEST_IN_TABLE);
    let amount = Amount { exact, ..*largest };
    match engine.origin {
        Origin::Catalogue if left.shape == Shape::DoesNotExist => shape_name(left.shape).into(),
        Origin::Catalogue => phrase!("{}, {}", amount, shape_name(left.shape)),
        Origin::Found(_) => amount.into(),
    }
}

fn part(order: &Order, quantity: Planar) -> &Remaining {
    quantity.choose(&order.force, &order.moment)
}

fn letters(form: &Form) -> usize {
    form.to_string().chars().count()
}

/// The values of orders 1 and 2 whose closed forms are too long for the tables.
///
/// Stars of four-stroke engines with an odd number of cylinders are those of the two-stroke ones.
pub(super) fn longer_forms(all: &[EngineRow]) -> Vec<Text> {
    let mut lines = Vec::new();
    for engine in all.iter().filter(|engine| engine.origin != Origin::Found(Cycle::FourStroke)) {
        for order in engine.orders.iter().filter(|order| REMEDIED.contains(&order.order)) {
            for (quantity, left) in [(Planar::Force, &order.force), (Planar::Moment, &order.moment)] {
                let Some(largest) = &left.largest else { continue };
                let is_long = largest.exact.as_ref().is_some_and(|form| letters(form) > LONGEST_IN_TABLE);
                let is_shown = match largest.number() {
                    Number::Closed(..) => true,
                    Number::Zero | Number::Exact(_) | Number::Decimal(_) => false,
                };
                if is_long && is_shown {
                    lines.push(text::long_form(name(engine), quantity, order.order, largest.clone()));
                }
            }
        }
    }
    lines
}
