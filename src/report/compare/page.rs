//! What stands on the page of a comparison, and on the terminal? The answer, the vector stars, the table, how it is read.

use super::super::calculation::Unit;
use super::super::multiples::{self, Column};
use super::super::residual;
use super::{Compared, notes, orders_of, rows};
use crate::loads::OrderLoads;
use crate::page::{Block, Document, Picture, Text, phrase};
use crate::proof::Planar;
use crate::text::Format;
use crate::verdict::{FirstLeft, OrderBalance};

/// Engines that stand beside each other on a terminal; more begin a new table.
const MOST_BESIDE: usize = 3;

/// The same on a page.
const MOST_ON_A_PAGE: usize = 5;

/// The short answer: what each engine leaves, and the tables.
pub fn compare_answer(engines: &[Compared]) -> Document {
    let mut page = Document::new("compare", "Comparison");
    page.push(Block::Answer(answer(engines)));
    for shown in engines.chunks(MOST_BESIDE) {
        page.push(rows::table(engines, shown));
    }
    page.push(Block::List(notes::notes(engines)));
    page
}

/// The page, with the stars of each order in one picture.
pub fn compare_page(engines: &[Compared]) -> Document {
    let mut page = Document::new("compare", "Comparison");
    page.push(Block::Answer(answer(engines)));
    page.push(Block::Heading(1, "Vector stars".into()));
    for order in orders_of(engines) {
        page.blocks.extend(stars(engines, order).map(Block::from));
    }
    page.push(Block::Heading(1, "Side by side".into()));
    for shown in engines.chunks(MOST_ON_A_PAGE) {
        page.push(rows::table(engines, shown));
    }
    page.push(Block::Heading(1, "How it is read".into()));
    page.push(Block::List(notes::notes(engines)));
    page
}

/// What stands first: a line per engine, and which of them is balanced up to the highest order.
fn answer(engines: &[Compared]) -> Vec<Text> {
    let mut lines: Vec<Text> = furthest(engines).into_iter().collect();
    lines.extend(engines.iter().map(left));
    if engines.iter().all(Compared::has_newtons) {
        lines.extend(engines.iter().filter_map(largest));
    }
    lines
}

/// The engines that leave nothing up to the highest order, where every order of all is known and they are not all alike.
fn furthest(engines: &[Compared]) -> Option<Text> {
    let lowest: Vec<u32> = engines.iter().map(lowest_left).collect::<Option<_>>()?;
    let highest = lowest.iter().copied().max()?;
    let best: Vec<&Compared> =
        engines.iter().zip(&lowest).filter(|(_, order)| **order == highest).map(|(engine, _)| engine).collect();
    let names = Text::joined(best.iter().map(|engine| (&engine.name).into()), ", ");
    match (best.len(), highest) {
        (several, _) if several == engines.len() => None,
        (_, u32::MAX) => Some(phrase!("Balanced at every order: {}.", names)),
        (_, order) => Some(phrase!("Balanced furthest: {}, with nothing left below order {}.", names, order)),
    }
}

/// The lowest order at which anything is left, the highest number where nothing is; none where it is not known.
fn lowest_left(engine: &Compared) -> Option<u32> {
    let [force, moment] = first_left(engine)?;
    let order = |first: Option<(u32, &'static str)>| first.map_or(u32::MAX, |(order, _)| order);
    Some(order(force).min(order(moment)))
}

/// The lowest order of the force and of the moment that is left, with its shape; none of all where it is not known.
fn first_left(engine: &Compared) -> Option<[Option<(u32, &'static str)>; 2]> {
    let theorem = engine.theorem.as_ref().ok()?;
    let first = |quantity| match theorem.first_left(&engine.engine, quantity) {
        FirstLeft::Nothing => Some(None),
        FirstLeft::Order(order, shape) => Some(Some((order, residual::shape_name(shape)))),
        FirstLeft::NotKnown => None,
    };
    Some([first(Planar::Force)?, first(Planar::Moment)?])
}

/// What an engine leaves of all orders.
fn left(engine: &Compared) -> Text {
    let name = &engine.name;
    let Some([force, moment]) = first_left(engine) else {
        return phrase!("**{}**: nothing is stated on every order; the table has the orders that are compared.", name);
    };
    match (force, moment) {
        (None, None) => phrase!("**{}** leaves neither force nor moment, at any order.", name),
        (Some((order, shape)), None) => {
            phrase!("**{}** leaves a force from order {} on, {}, and no moment at any order.", name, order, shape)
        }
        (None, Some((order, shape))) => {
            phrase!("**{}** leaves a moment from order {} on, {}, and no force at any order.", name, order, shape)
        }
        (Some((force, force_shape)), Some((moment, moment_shape))) => phrase!(
            "**{}** leaves a force from order {} on, {}, and a moment from order {} on, {}.",
            name,
            force,
            force_shape,
            moment,
            moment_shape
        ),
    }
}

/// The order with the largest force and that with the largest moment, in newtons.
fn largest(engine: &Compared) -> Option<Text> {
    let loads = engine.loads.as_ref().ok()?;
    let of = |quantity: Planar, value: fn(&OrderLoads) -> f64| {
        let largest = loads.orders.iter().max_by(|one, other| value(one).total_cmp(&value(other)))?;
        let unit = Unit::of(&engine.engine, loads, quantity);
        let size = phrase!("{} {}", Text::measured(value(largest) * unit.factor, unit.unit), unit.label());
        (value(largest) * unit.factor > 0.0).then_some((size, largest.order))
    };
    let (name, speed) = (&engine.name, rows::speed(engine));
    let force = of(Planar::Force, |loads| loads.force.largest());
    let moment = of(Planar::Moment, |loads| loads.moment.largest());
    Some(match (force, moment) {
        (None, None) => phrase!("**{}** at {} rpm: no force and no moment at these orders.", name, speed),
        (Some((size, order)), None) => {
            phrase!("**{}** at {} rpm: the largest force is {}, of order {}; no moment.", name, speed, size, order)
        }
        (None, Some((size, order))) => {
            phrase!("**{}** at {} rpm: the largest moment is {}, of order {}; no force.", name, speed, size, order)
        }
        (Some((force, of_force)), Some((moment, of_moment))) => phrase!(
            "**{}** at {} rpm: the largest force is {}, of order {}, the largest moment {}, of order {}.",
            name,
            speed,
            force,
            of_force,
            moment,
            of_moment
        ),
    })
}

/// The stars of an order, in as many pictures as the engines need.
fn stars(engines: &[Compared], order: u32) -> impl Iterator<Item = Picture> {
    let columns: Vec<Column> = engines.iter().flat_map(|engine| columns(engine, order)).collect();
    let picture = move |(index, figure)| Picture {
        name: match index {
            0 => format!("stars-order-{order}"),
            later => format!("stars-order-{order}-{}", later + 1),
        },
        caption: phrase!(
            "Vector stars of order {}: force above moment, each to one scale where units are the same. Blue, orange and green polygons sum to zero; a red arrow is what is left.",
            order
        ),
        figure,
    };
    multiples::multiples(&columns).into_iter().enumerate().map(picture)
}

fn columns<'a>(engine: &'a Compared, order: u32) -> impl Iterator<Item = Column<'a>> {
    let name = move |judged: &OrderBalance| match &judged.class {
        None => engine.name.escaped(Format::Plain),
        Some(class) => format!("{}, {}", engine.name.escaped(Format::Plain), residual::class_sources(class)),
    };
    let parts = engine.at(order).into_iter().flat_map(|judged| &judged.parts);
    parts.map(move |judged| Column { name: name(judged), engine: &engine.engine, order: judged })
}
