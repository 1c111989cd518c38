//! What is on the page of a comparison, and on the terminal? The answer, sizes, exact verdicts, vector stars, how to read it.

use super::super::catalogue::first_left;
use super::super::multiples::{self, Column};
use super::super::residual;
use super::rows::Sized;
use super::{Compared, notes, orders_of, rows};
use crate::page::{Block, Document, Picture, Text};
use crate::proof::{Planar, Shape};
use crate::report::texts::compare as text;
use crate::text::Format;
use crate::verdict::{NextLeft, OrderBalance};

/// Engines that are beside each other on a terminal; more begin a new table.
const MOST_BESIDE: usize = 3;

/// The same on a page.
const MOST_ON_A_PAGE: usize = 5;

/// Stars of more engines than this are folded.
const MOST_OF_STARS: usize = 4;

/// The short answer: who is balanced furthest, and the tables.
pub fn compare_answer(engines: &[Compared]) -> Document {
    let mut page = Document::new("compare", "Comparison");
    page.blocks.extend(tables(engines, MOST_BESIDE));
    page.push(Block::List(notes::notes(engines)));
    page
}

/// The page, with the stars of each order in one picture.
pub fn compare_page(engines: &[Compared]) -> Document {
    let stars: Vec<Block> =
        orders_of(engines).into_iter().flat_map(|order| stars(engines, order).map(Block::from)).collect();
    text::Page {
        tables: tables(engines, MOST_ON_A_PAGE).into(),
        stars: match engines.len() > MOST_OF_STARS {
            true => Block::folded("The stars of each order", stars).into(),
            false => stars.into(),
        },
        notes: notes::notes(engines).into(),
    }
    .document()
}

/// The answer, sizes and cures, then the exact verdicts: this many engines beside each other.
fn tables(engines: &[Compared], beside: usize) -> Vec<Block> {
    let all: Vec<Sized> = engines.iter().map(Sized::new).collect();
    let sizes = all.chunks(beside).map(|shown| rows::sizes(&all, shown).into());
    let verdicts = all.chunks(beside).map(|shown| rows::verdicts(&all, shown).into());
    let mut blocks = vec![Block::Answer(answer(engines))];
    blocks.extend(sizes);
    blocks.extend(rows::apart(&all).map(Block::Note));
    blocks.push(Block::Heading(1, "Exact verdicts".into()));
    blocks.extend(verdicts);
    blocks
}

/// What stands first: which engines are balanced furthest, or at orders 1 and 2; else a line per engine.
fn answer(engines: &[Compared]) -> Vec<Text> {
    let line = furthest(engines).or_else(|| balanced(engines));
    line.map_or_else(|| engines.iter().map(left).collect(), |line| vec![line])
}

/// The engines that have neither force nor moment at orders 1 and 2, where both are compared.
fn balanced(engines: &[Compared]) -> Option<Text> {
    let is_zero = |engine: &Compared| {
        [1, 2]
            .into_iter()
            .all(|order| engine.at(order).is_some_and(|of| of.force.is_balanced() && of.moment.is_balanced()))
    };
    let names = notes::names(engines, is_zero);
    (!names.is_empty()).then(|| text::no_low_orders(names))
}

/// The engines that leave nothing up to the highest order, where every order of all is known and they are not all alike. What turns with the
/// crank at order 1 is not counted: counterweights cancel it.
fn furthest(engines: &[Compared]) -> Option<Text> {
    let lowest: Vec<(u32, bool)> = engines.iter().map(lowest_left).collect::<Option<_>>()?;
    let highest = lowest.iter().map(|(order, _)| *order).max()?;
    let best = || engines.iter().zip(&lowest).filter(|(_, (order, _))| *order == highest);
    let names = Text::joined(best().map(|(engine, _)| (&engine.name).into()), ", ");
    let needs_weights = best().any(|(_, (_, needs_weights))| *needs_weights);
    match (best().count() == engines.len(), highest) {
        (true, _) => None,
        (false, u32::MAX) => Some(text::balanced(needs_weights, names)),
        (false, order) => Some(text::balanced_below(order, needs_weights, names)),
    }
}

/// The lowest order at which anything is left but what counterweights on the crank cancel, and whether it takes these; the highest number
/// where nothing is left; none where it is not known.
fn lowest_left(engine: &Compared) -> Option<(u32, bool)> {
    let theorem = engine.theorem.as_ref().ok()?;
    let [force, moment] = first_left(theorem, &engine.engine)?;
    let firsts = || [force, moment].into_iter().flatten();
    let lowest = firsts().map(|(order, _)| order).min().unwrap_or(u32::MAX);
    let is_cancelled = |first: (u32, Shape)| first.0 > 1 || first == (1, Shape::Rotating);
    if lowest > 1 || !firsts().all(is_cancelled) {
        return Some((lowest, false));
    }
    match theorem.next_left(&Planar::BOTH, &[1]) {
        NextLeft::Order(order) => Some((order, true)),
        NextLeft::None => Some((u32::MAX, true)),
        NextLeft::NotKnown => None,
    }
}

/// What an engine leaves of all orders.
fn left(engine: &Compared) -> Text {
    let name = &engine.name;
    let theorem = engine.theorem.as_ref().ok();
    let Some([force, moment]) = theorem.and_then(|theorem| first_left(theorem, &engine.engine)) else {
        return text::not_stated(name);
    };
    match (force, moment) {
        (None, None) => text::no_residual(name),
        (Some((order, shape)), None) | (None, Some((order, shape))) => {
            text::one_residual(name, force.is_some(), order, residual::shape_name(shape))
        }
        (Some((force, force_shape)), Some((moment, moment_shape))) => text::both_residuals(
            name,
            force,
            residual::shape_name(force_shape),
            moment,
            residual::shape_name(moment_shape),
        ),
    }
}

/// The stars of an order, in as many pictures as the engines need.
fn stars(engines: &[Compared], order: u32) -> impl Iterator<Item = Picture> {
    let columns: Vec<Column> = engines.iter().flat_map(|engine| columns(engine, order)).collect();
    let picture = move |(index, figure)| Picture {
        name: match index {
            0 => format!("stars-order-{order}"),
            later => format!("stars-order-{order}-{}", later + 1),
        },
        caption: text::stars_of_order(order),
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
