//! How do the numbers of an engine stand in the tables of the atlas?

use serde::Serialize;

use super::super::dialect::Dialect;
use super::super::left;
use super::super::typeset::Amount;
use super::REMEDIED;
use super::entry::{Engine, Origin, Ties};
use crate::layout::Cycle;
use crate::verdict::{Balance, OrderBalance};

/// Longer closed forms do not stand in the tables.
const LONGEST_IN_TABLE: usize = 24;

/// An engine: a line of forces, a line of moments, and what is said of both.
#[derive(Serialize)]
pub(super) struct Row {
    name: String,
    title: String,
    force: Vec<String>,
    moment: Vec<String>,
    first_left: [String; 2],
    remedy: String,
}

impl Row {
    pub fn new(engine: &Engine, dialect: Dialect) -> Self {
        let with_shape = engine.origin == Origin::Catalogue;
        let cell = |balance: &Balance| dialect.prose(&cell(balance, with_shape, dialect));
        Row {
            name: name(engine, dialect),
            title: title(engine, dialect),
            force: engine.orders.iter().map(|order| cell(&order.force)).collect(),
            moment: engine.orders.iter().map(|order| cell(&order.moment)).collect(),
            first_left: engine.first_left.each_ref().map(|words| dialect.prose(&first(words, with_shape))),
            remedy: dialect.prose(&engine.remedy),
        }
    }
}

/// Stars in line leave nothing but what is planar.
fn first(words: &str, with_shape: bool) -> String {
    if with_shape { words.to_owned() } else { words.trim_end_matches(", planar").to_owned() }
}

fn name(engine: &Engine, dialect: Dialect) -> String {
    match (engine.origin, dialect) {
        (Origin::Catalogue, Dialect::Latex) => dialect.quoted(&engine.name),
        (Origin::Catalogue, _) => format!("[{0}](../{0}/report.md)", engine.name),
        (Origin::Found(_), _) => format!("{} cylinders, {}", engine.name, engine.firing_order),
    }
}

fn title(engine: &Engine, dialect: Dialect) -> String {
    let Some(Ties { stars, all, tied }) = &engine.ties else {
        return format!("{}; {}", dialect.quoted(&engine.title), dialect.prose(&engine.firing));
    };
    let ties = match tied {
        Some(classes) => format!("M₁ = M₂ = 0 in {classes} classes, of which it has the least M₄: {stars} of {all} stars"),
        None => format!("{stars} of {all} stars"),
    };
    dialect.prose(&format!("{}; {ties}", engine.title))
}

fn cell(balance: &Balance, with_shape: bool, dialect: Dialect) -> String {
    if balance.is_balanced() {
        return if dialect == Dialect::Latex { "0" } else { "**0**" }.to_owned();
    }
    let mut amount = left::largest(balance);
    amount.exact = amount.exact.filter(|form| form.to_string().chars().count() <= LONGEST_IN_TABLE);
    let text = if dialect == Dialect::Latex { amount.prose() } else { amount.plain() };
    if with_shape { format!("{text}, {}", left::shape_name(balance.shape)) } else { text }
}

/// The moments of orders 1 and 2 whose closed forms are too long for the tables: engine, quantity, form.
///
/// Stars of four-stroke engines with an odd number of cylinders are those of the two-stroke ones.
pub(super) fn longer_forms(all: &[Engine], dialect: Dialect) -> Vec<[String; 3]> {
    let is_new = |engine: &&Engine| engine.origin != Origin::Found(Cycle::FourStroke);
    let mut rows = Vec::new();
    for engine in all.iter().filter(is_new) {
        for order in engine.orders.iter().filter(|order| REMEDIED.contains(&order.order)) {
            for (quantity, amount) in amounts(order) {
                let is_long = |form: &crate::numbers::Form| form.to_string().chars().count() > LONGEST_IN_TABLE;
                if !amount.exact.as_ref().is_some_and(is_long) {
                    continue;
                }
                let words = if dialect == Dialect::Latex { amount.prose() } else { amount.plain() };
                let name = match engine.origin {
                    Origin::Catalogue => dialect.quoted(&engine.name),
                    Origin::Found(_) => dialect.prose(&format!("{} cylinders, {}", engine.name, engine.firing_order)),
                };
                rows.push([name, format!("{quantity} {}", order.order), dialect.prose(&words)]);
            }
        }
    }
    rows
}

fn amounts(order: &OrderBalance) -> [(&'static str, Amount); 2] {
    [("force", left::largest(&order.force)), ("moment", left::largest(&order.moment))]
}
