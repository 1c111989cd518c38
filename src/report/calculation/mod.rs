//! How are the numbers of an engine shown, so that a reader can work them out again? Results first, then every line of the calculation.
//!
//! `inputs → equations → lines (symbol = formula = figures = result) → tables and plots → limits`

mod amounts;
mod books;
pub(super) mod data;
mod equations;
mod expression;
mod given;
mod inputs;
mod largest;
mod links;
mod page;
mod plots;
mod results;
mod roll;
mod study;
mod summary;
mod tables;
mod words;

pub(super) use amounts::{Unit, about_the_axis, bound, largest, share, vector};
pub(super) use books::books_line;
pub(super) use inputs::table as inputs_table;
pub use largest::Numbers;
pub(super) use largest::{percent, percent_at_most};
pub use page::loads_page;
pub use study::LoadsStudy;
pub use summary::loads_answer;
pub(super) use summary::loads_answer_weighed;

use super::bearings;
use crate::engine::{Engine, Measure};
use crate::loads::{Loads, Missing, Needed};
use crate::page::{Block, Fold, Text, phrase};
use crate::proof::Planar;
use expression::Line;

/// The loads of a layout that holds numbers; none where the file gives none.
pub(super) fn numbers_of(engine: &Engine, orders: &[u32], needed: Option<&Needed>) -> Option<Result<Numbers, Missing>> {
    let asks = engine.dimensions().given.iter().any(|given| given.quantity != Measure::Speed);
    asks.then(|| Numbers::new(engine, orders, needed))
}

fn heading(level: u8, words: &'static str) -> Block {
    Block::Heading(level, words.into())
}

fn formula(line: &Line) -> Block {
    Block::Formula(line.tex(), None)
}

/// What comes out: the largest values, what makes them up, order by order and through a revolution.
pub(super) fn outcome(engine: &Engine, numbers: &Numbers, needed: Option<&Needed>) -> Vec<Block> {
    let loads = &numbers.loads;
    let mut blocks = vec![heading(1, "Numbers")];
    blocks.push(Block::List(largest::largest_lines(engine, numbers, Unit::as_read)));
    blocks.extend(chosen(engine, numbers, needed));
    blocks.push(tables::ellipses(engine, loads).into());
    blocks.push(Block::Note(tables::units(engine, loads)));
    blocks.extend(drawn(engine, loads));
    blocks.extend([heading(2, "Effects included"), tables::effects(engine, loads).into()]);
    blocks.push(Block::Note(SHARES.into()));
    blocks.extend(roll::turning(engine, loads));
    blocks.extend(main_bearings(engine, loads));
    blocks
}

/// Which orders were kept, and what the others add at most.
fn chosen(engine: &Engine, numbers: &Numbers, needed: Option<&Needed>) -> Option<Block> {
    let lines = largest::chosen_lines(engine, numbers, needed, Unit::as_read);
    (!lines.is_empty()).then(|| Block::Paragraph(Text::joined(lines, " ")))
}

/// All plots, two beside each other.
fn drawn(engine: &Engine, loads: &Loads) -> Vec<Block> {
    plots::figures(engine, loads).chunks(2).map(|pair| Block::Pictures(pair.to_vec())).collect()
}

const SHARES: &str = "The share is the component of the effect along the peak, at the crank angle of the peak; the shares of a column sum to the peak.";

fn main_bearings(engine: &Engine, loads: &Loads) -> Vec<Block> {
    let Some([continuous, determinate]) = &loads.bearings else { return Vec::new() };
    let mut blocks = vec![heading(2, "Main bearings")];
    blocks.extend(bearings::first_lines(continuous, determinate).map(Block::Paragraph));
    blocks.push(bearings::peaks(engine, continuous, determinate).into());
    blocks.push(bearings::orders(continuous).into());
    blocks.extend(bearings::left_out(engine, continuous).map(Block::Paragraph));
    blocks.extend(
        bearings::drawings(engine.convention(), continuous)
            .into_iter()
            .map(|pictures| Block::Pictures(pictures.into())),
    );
    blocks
}

/// How it comes out: inputs, equations, every line from its figures, and where the numbers end.
pub(super) fn working(engine: &Engine, numbers: &Numbers) -> Vec<Block> {
    let loads = &numbers.loads;
    let mut blocks = vec![heading(1, "The calculation"), heading(2, "Inputs"), inputs::table(engine).into()];
    let turning = inputs::turning(engine);
    if !turning.rows.is_empty() {
        blocks.push(turning.into());
    }
    let source = engine.dimensions().source.as_ref();
    blocks.extend(source.map(|source| Block::Paragraph(phrase!("Source of the inputs: {}.", source))));
    let assumed = words::assumptions(engine, loads).into_iter();
    let assumed = assumed.chain(engine.title_block().assumptions.iter().map(Text::from));
    blocks.extend([heading(2, "Assumptions"), Block::List(assumed.collect())]);
    if loads.bearings.is_some() {
        blocks.push(Block::List(super::texts::bearings::assumptions().into()));
    }
    blocks.extend([heading(2, "Limits of validity"), Block::List(words::limits(engine, loads))]);
    blocks.push(Block::Folded(Fold { summary: "Symbols and equations".into(), blocks: equations(engine, loads) }));
    blocks.push(Block::Folded(Fold { summary: "Line by line".into(), blocks: lines(engine, numbers) }));
    blocks
}

fn equations(engine: &Engine, loads: &Loads) -> Vec<Block> {
    let mut blocks = vec![words::nomenclature(engine, loads).into()];
    for (words, tex, number) in equations::equations(engine, loads) {
        blocks.extend([Block::Paragraph(words), Block::Formula(tex, Some(number))]);
    }
    blocks
}

const LINES: &str = "Symbol = formula ≈ figures ≈ result; each result is computed from the figures shown.";

fn lines(engine: &Engine, numbers: &Numbers) -> Vec<Block> {
    let loads = &numbers.loads;
    let mut blocks = vec![Block::Paragraph(LINES.into())];
    blocks.extend(inputs::lines(engine, loads).iter().map(formula));
    for group in results::orders(engine, loads) {
        blocks.push(Block::Heading(2, group.heading));
        blocks.extend(group.lines.iter().map(formula));
    }
    blocks.extend([heading(2, "The two vectors of each order, whose lengths add up to the largest value")]);
    blocks.push(tables::vectors(engine, loads).into());
    for quantity in Planar::BOTH {
        if let Some(lines) = results::peak(engine, loads, quantity) {
            let listed = amounts::peak(&amounts::waveform(loads, quantity).peak(), Unit::of(engine, loads, quantity));
            blocks.push(Block::Paragraph(phrase!("The {force|moment} of the listed orders is {}:", quantity, listed)));
            blocks.extend(lines.iter().map(formula));
        }
    }
    if let Some(group) = results::torque(engine, loads) {
        blocks.push(Block::Heading(2, group.heading));
        blocks.extend(group.lines.iter().map(formula));
    }
    blocks
}
