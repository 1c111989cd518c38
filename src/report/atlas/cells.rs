//! How do the numbers of an engine stand in the tables of the atlas?

use serde::Serialize;

use super::super::dialect::Dialect;
use super::super::residual::shape_name;
use super::super::typeset::Amount;
use super::REMEDIED;
use super::entry::{EngineRow, Left, Origin, Ties};
use crate::engine::Cycle;
use crate::proof::Shape;

/// Longer closed forms do not stand in the tables.
const LONGEST_IN_TABLE: usize = 24;

/// An engine: forces, moments, and what is said of both.
#[derive(Serialize)]
pub(super) struct Row {
    name: String,
    title: String,
    firing: String,
    force: Vec<String>,
    moment: Vec<String>,
    first_left: [String; 2],
    remedy: String,
}

impl Row {
    pub fn new(engine: &EngineRow, dialect: Dialect) -> Self {
        let with_shape = engine.origin == Origin::Catalogue;
        let cell = |left: &Left| dialect.prose(&cell(left, with_shape, dialect));
        Row {
            name: name(engine, dialect),
            title: dialect.quoted(&engine.title),
            firing: dialect.prose(&firing(engine)),
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

fn name(engine: &EngineRow, dialect: Dialect) -> String {
    match (engine.origin, dialect) {
        (Origin::Catalogue, Dialect::Latex) => dialect.literal(&engine.name),
        (Origin::Catalogue, _) => format!("[{0}](../{0}/report.md)", engine.name),
        (Origin::Found(_), _) => format!("{}: {}", engine.name, engine.firing_order),
    }
}

/// How the engine fires; of a star, which all fire evenly, how many are as good.
fn firing(engine: &EngineRow) -> String {
    match &engine.ties {
        None => engine.firing.clone(),
        Some(Ties { stars, all, tied: None }) => format!("{stars} of {all} stars"),
        Some(Ties { stars, all, tied: Some(classes) }) => {
            format!("{stars} of {all} stars, with the least $M_4$ of the {classes} classes that have $M_1 = M_2 = 0$")
        }
    }
}

fn cell(left: &Left, with_shape: bool, dialect: Dialect) -> String {
    if left.shape == Shape::Balanced {
        return if dialect == Dialect::Latex { "0" } else { "**0**" }.to_owned();
    }
    let exact = left.largest.exact.clone().filter(|form| form.to_string().chars().count() <= LONGEST_IN_TABLE);
    let amount = Amount { exact, ..left.largest };
    // A narrow space, at which no line breaks, keeps the sign with its number.
    let text = if dialect == Dialect::Latex { amount.prose() } else { amount.plain() }.replace("≈ ", "≈\u{202f}");
    if with_shape { format!("{text}, {}", shape_name(left.shape)) } else { text }
}

/// The moments of orders 1 and 2 whose closed forms are too long for the tables: engine, quantity, form.
///
/// Stars of four-stroke engines with an odd number of cylinders are those of the two-stroke ones.
pub(super) fn longer_forms(all: &[EngineRow], dialect: Dialect) -> Vec<[String; 3]> {
    let is_new = |engine: &&EngineRow| engine.origin != Origin::Found(Cycle::FourStroke);
    let mut rows = Vec::new();
    for engine in all.iter().filter(is_new) {
        for order in engine.orders.iter().filter(|order| REMEDIED.contains(&order.order)) {
            for (quantity, amount) in [("force", &order.force.largest), ("moment", &order.moment.largest)] {
                let is_long = |form: &crate::numbers::Form| form.to_string().chars().count() > LONGEST_IN_TABLE;
                if !amount.exact.as_ref().is_some_and(is_long) {
                    continue;
                }
                let words = if dialect == Dialect::Latex { amount.prose() } else { amount.plain() };
                let name = match engine.origin {
                    Origin::Catalogue => dialect.literal(&engine.name),
                    Origin::Found(_) => dialect.prose(&format!("{}: {}", engine.name, engine.firing_order)),
                };
                rows.push([name, format!("{quantity} {}", order.order), dialect.prose(&words)]);
            }
        }
    }
    rows
}
