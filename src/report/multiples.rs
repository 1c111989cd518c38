//! How do the vector stars of several engines stand beside each other? Small multiples of one order.

use num_traits::Zero;

use super::figure::{Figure, Point};
use super::star::{PANEL, RESULTANT, Star, draw_star, scale};
use crate::engine::Engine;
use crate::verdict::OrderBalance;

/// One column of small multiples: an engine, or its cylinders with equal rods, at one order.
pub(super) struct Column<'a> {
    /// What stands above it.
    pub name: String,
    /// The engine.
    pub engine: &'a Engine,
    /// The order.
    pub order: &'a OrderBalance,
}

/// Columns beside each other; more begin a new band.
const MOST_COLUMNS: usize = 4;
/// Resultants below this length, in millimetres, are drawn thinner.
const SHORT: f64 = 8.0;
/// Height of the names above a band.
const NAMES: f64 = 7.0;

/// The stars of one order of several engines, a column each, every row drawn to one scale: force, then moment.
///
/// The reverse stars are left out where all engines have their cylinders in one line: there they are mirror images.
pub(super) fn multiples(columns: &[Column]) -> Figure {
    let in_line = |engine: &Engine| engine.cylinders().windows(2).all(|pair| pair[0].bank == pair[1].bank);
    let senses = if columns.iter().all(|column| in_line(column.engine)) { 1 } else { 2 };
    let has_arm = |column: &Column| column.order.moment.direct.sum.terms().iter().any(|term| !term.weight.is_zero());
    let quantities = if columns.iter().any(has_arm) { 2 } else { 1 };
    let stars = |column: &Column| -> Vec<Star> {
        let balances = [&column.order.force, &column.order.moment].into_iter().take(quantities);
        balances.flat_map(|balance| balance.verdicts().into_iter().take(senses)).map(Star::new).collect()
    };
    let stars: Vec<Vec<Star>> = columns.iter().map(stars).collect();
    let rows = senses * quantities;
    // Direct and reverse stars share their scale; moments only where they are in one unit.
    let scale_of = |column: &Column, quantity: usize| {
        let alike = |other: &Column| quantity == 0 || other.engine.length_unit() == column.engine.length_unit();
        let of_quantity =
            |stars: &Vec<Star>| stars[quantity * senses..][..senses].iter().map(Star::reach).fold(0.0, f64::max);
        let reaches = columns.iter().zip(&stars).filter(|(other, _)| alike(other)).map(|(_, stars)| of_quantity(stars));
        scale(reaches.fold(0.0, f64::max))
    };
    let band = rows as f64 * PANEL.1 + NAMES;
    let bands = columns.len().div_ceil(MOST_COLUMNS);
    let mut figure = Figure::new(columns.len().min(MOST_COLUMNS) as f64 * PANEL.0, bands as f64 * band);
    for (index, (column, stars)) in columns.iter().zip(&stars).enumerate() {
        let left = (index % MOST_COLUMNS) as f64 * PANEL.0;
        let bottom = (bands - 1 - index / MOST_COLUMNS) as f64 * band;
        figure.heading(Point::new(left + PANEL.0 / 2.0, bottom + band - NAMES / 2.0), shortened(&column.name));
        let verdicts = [&column.order.force, &column.order.moment]
            .into_iter()
            .take(quantities)
            .flat_map(|balance| balance.verdicts().into_iter().take(senses));
        for (row, (verdict, star)) in verdicts.zip(stars).enumerate() {
            let corner = Point::new(left, bottom + (rows - 1 - row) as f64 * PANEL.1);
            let scale = scale_of(column, row / senses);
            // A short resultant is drawn thinner, so that its head does not hide it.
            let length = star.resultant.map_or(0.0, |sum| sum.norm() * scale);
            let width = RESULTANT * (length / SHORT).clamp(0.2, 1.0);
            draw_star(&mut figure, corner, column.engine, verdict, star, (scale, width));
        }
    }
    figure
}

/// Letters of a name that a panel has room for.
const LONGEST_NAME: usize = 38;

fn shortened(name: &str) -> String {
    match name.chars().count() {
        0..=LONGEST_NAME => name.to_owned(),
        _ => name.chars().take(LONGEST_NAME - 1).chain(['…']).collect(),
    }
}
