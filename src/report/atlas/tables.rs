//! How do the numbers of an engine stand in the tables of the atlas?

use super::super::residual::shape_name;
use super::super::typeset::Amount;
use super::REMEDIED;
use super::entry::{EngineRow, Order, Origin, Remaining, Ties};
use crate::engine::Cycle;
use crate::numbers::Form;
use crate::page::{Number, Table, Text, phrase};
use crate::proof::{Planar, Shape};

/// Longer closed forms do not stand in the tables.
const LONGEST_IN_TABLE: usize = 24;

/// What each engine of the catalogue is, leaves first, and needs.
pub(super) fn known(engines: &[&EngineRow]) -> Table {
    let mut table = Table::new(["Name", "Engine", "Firing", "First force left", "First moment left", "Remedy"]);
    for engine in engines {
        let [force, moment] = engine.first_left.clone();
        table.push(vec![
            name(engine),
            (&engine.title).into(),
            engine.firing.clone(),
            force,
            moment,
            engine.remedy.clone(),
        ]);
    }
    table
}

/// The same of the stars that were found, with how many are as good.
pub(super) fn found(engines: &[&EngineRow]) -> Table {
    let mut table = Table::new(["Star", "Throws", "As good", "First force left", "First moment left", "Remedy"]);
    for engine in engines {
        let [force, moment] = engine.first_left.clone();
        table.push(vec![
            name(engine),
            (&engine.title).into(),
            engine.ties.as_ref().map(ties).unwrap_or_default(),
            force,
            moment,
            engine.remedy.clone(),
        ]);
    }
    table
}

/// The largest force or moment of each engine at these orders.
pub(super) fn by_order(engines: &[&EngineRow], quantity: Planar, orders: &[u32]) -> Table {
    let first = match engines.first().map(|engine| engine.origin) {
        Some(Origin::Found(_)) => "Star",
        Some(Origin::Catalogue) | None => "Name",
    };
    let headings = orders.iter().map(|order| phrase!("Order {}", *order));
    let mut table = Table::new([Text::from(first)].into_iter().chain(headings));
    for engine in engines {
        let of = |order: &u32| engine.orders.iter().find(|judged| judged.order == *order);
        let cells =
            orders.iter().map(|order| of(order).map(|judged| cell(engine, judged, quantity)).unwrap_or_default());
        table.push([name(engine)].into_iter().chain(cells).collect());
    }
    table
}

fn name(engine: &EngineRow) -> Text {
    match engine.origin {
        Origin::Catalogue => Text::link(Text::label(engine.name.clone()), format!("../{}/report.md", engine.name)),
        Origin::Found(_) => phrase!("{}: {}", engine.name.clone(), engine.firing_order.clone()),
    }
}

/// How many stars are as good.
fn ties(Ties { stars, all, tied }: &Ties) -> Text {
    match tied {
        None => phrase!("{} of {} stars", stars.to_string(), all.to_string()),
        Some(classes) => phrase!(
            "{} of {} stars, with the least $M_4$ of the {} classes that have $M_1 = M_2 = 0$",
            stars.to_string(),
            all.to_string(),
            classes.to_string()
        ),
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
    match quantity {
        Planar::Force => &order.force,
        Planar::Moment => &order.moment,
    }
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
            for (words, left) in
                [("{}, force of order {}: {}", &order.force), ("{}, moment of order {}: {}", &order.moment)]
            {
                let Some(largest) = &left.largest else { continue };
                let is_long = largest.exact.as_ref().is_some_and(|form| letters(form) > LONGEST_IN_TABLE);
                let is_shown = match largest.number() {
                    Number::Closed(..) => true,
                    Number::Zero | Number::Exact(_) | Number::Decimal(_) => false,
                };
                if is_long && is_shown {
                    lines.push(phrase!(words, name(engine), order.order, largest.clone()));
                }
            }
        }
    }
    lines
}
