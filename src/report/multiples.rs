//! How are the vector stars of several engines drawn beside each other? Small multiples of one order.

use num_traits::Zero;

use super::figure::Figure;
use super::star::{Panel, Scale, Sheet, Star, WIDTH, shortened};
use crate::engine::Engine;
use crate::proof::Planar;
use crate::verdict::OrderBalance;

/// One column of small multiples: an engine, or its cylinders with equal rods, at one order.
pub struct Column<'a> {
    /// What is above it.
    pub name: String,
    /// The engine.
    pub engine: &'a Engine,
    /// The order.
    pub order: &'a OrderBalance,
}

/// Columns beside each other; more begin a new drawing.
const MOST_COLUMNS: usize = 3;

/// The stars of one order of several engines, a column each, as many as fit a page in each drawing: force, then moment, all
/// forces to one scale and all moments to one.
///
/// The reverse stars are omitted where all engines have their cylinders in one line: there they are mirror images.
pub fn multiples(columns: &[Column]) -> Vec<Figure> {
    let in_line = |engine: &Engine| engine.cylinders().windows(2).all(|pair| pair[0].bank == pair[1].bank);
    let senses = if columns.iter().all(|column| in_line(column.engine)) { 1 } else { 2 };
    let has_arm = |column: &Column| column.order.moment.direct.sum.terms().iter().any(|term| !term.weight.is_zero());
    let quantities = if columns.iter().any(has_arm) { 2 } else { 1 };
    let rows_of = |column: &Column| -> Vec<Star> {
        let balances = [&column.order.force, &column.order.moment].into_iter().take(quantities);
        balances.flat_map(|balance| balance.verdicts().into_iter().take(senses)).map(Star::new).collect()
    };
    let stars: Vec<Vec<Star>> = columns.iter().map(rows_of).collect();
    // Bands are as long as each other, as far as they can be.
    let bands = columns.len().div_ceil(MOST_COLUMNS).max(1);
    let in_band = columns.len().div_ceil(bands).max(1);
    let numbered: Vec<usize> = (0..columns.len()).collect();
    let draw = |band: &[usize]| {
        let mut sheet = Sheet::new(in_band);
        sheet.names(&band.iter().map(|index| shortened(&columns[*index].name, WIDTH - 2.0)).collect::<Vec<_>>());
        for row in 0..senses * quantities {
            let panel = |index: &usize| {
                let column = &columns[*index];
                let balance = if row < senses { &column.order.force } else { &column.order.moment };
                let verdict = balance.verdicts()[row % senses];
                let scale = scale(columns, &stars, column, balance.quantity, senses);
                Panel::new(column.engine, verdict, &stars[*index][row], scale)
            };
            sheet.row(band.iter().map(panel).collect(), (row + 1) % senses == 0);
        }
        sheet.finish()
    };
    numbered.chunks(in_band).map(draw).collect()
}

/// Direct and reverse stars of all columns share their scale; moments only where they are in one unit.
fn scale(columns: &[Column], stars: &[Vec<Star>], of: &Column, quantity: Planar, senses: usize) -> Scale {
    let (alike, rows): (&dyn Fn(&Column) -> bool, _) = match quantity {
        Planar::Force => (&|_| true, 0..senses),
        Planar::Moment => (&|column| column.engine.length_unit() == of.engine.length_unit(), senses..2 * senses),
    };
    let alike = columns.iter().zip(stars).filter(|(column, _)| alike(column));
    Scale::of(alike.flat_map(|(_, stars)| &stars[rows.clone()]), quantity, of.engine)
}
