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

use super::bearings;
use crate::engine::{Engine, Measure};
use crate::loads::{Loads, Missing, Needed};
use crate::page::{Block, Fold, Text};
use crate::proof::Planar;
use crate::report::texts::loads as text;
use expression::Line;

/// The loads of a layout that holds numbers; none where the file gives none.
pub(super) fn numbers_of(engine: &Engine, orders: &[u32], needed: Option<&Needed>) -> Option<Result<Numbers, Missing>> {
    let asks = engine.dimensions().given.iter().any(|given| given.quantity != Measure::Speed);
    asks.then(|| Numbers::new(engine, orders, needed))
}

fn heading(level: u8, words: impl Into<Text>) -> Block {
    Block::Heading(level, words.into())
}

fn formula(line: &Line) -> Block {
    Block::Formula(line.tex(), None)
}

/// What comes out: the largest values, what makes them up, order by order and through a revolution.
pub(super) fn outcome(engine: &Engine, numbers: &Numbers, needed: Option<&Needed>, has_torque: bool) -> Vec<Block> {
    let loads = &numbers.loads;
    let mut blocks = vec![heading(1, "Numbers")];
    blocks.push(Block::List(largest::largest_lines(engine, numbers, Unit::as_read)));
    blocks.extend(chosen(engine, numbers, needed));
    blocks.extend(ellipses(engine, loads));
    blocks.extend(drawn(engine, loads));
    blocks.push(heading(2, "Effects included"));
    blocks.extend(effects(engine, loads, words::Sections::OfReport { has_torque }));
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

/// The ellipse of each order, and what its table counts in.
fn ellipses(engine: &Engine, loads: &Loads) -> Vec<Block> {
    vec![tables::ellipses(engine, loads).into(), Block::Note(tables::units(engine, loads))]
}

/// The two vectors of each order, under their heading.
fn vectors(engine: &Engine, loads: &Loads) -> Vec<Block> {
    vec![heading(2, text::two_vectors()), tables::vectors(engine, loads).into()]
}

/// What is in the scene, and what a share is.
fn effects(engine: &Engine, loads: &Loads, page: words::Sections) -> Vec<Block> {
    vec![tables::effects(engine, loads, page).into(), Block::Note(text::shares())]
}

fn main_bearings(engine: &Engine, loads: &Loads) -> Vec<Block> {
    let Some([continuous, determinate]) = &loads.bearings else { return Vec::new() };
    let mut blocks = vec![heading(2, "Main bearings")];
    blocks.extend(bearings::first_lines(engine, continuous, determinate).map(Block::Paragraph));
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
    blocks.extend(source.map(|source| Block::Paragraph(text::source(source))));
    let assumed = words::assumptions(engine, loads).into_iter();
    let assumed = assumed.chain(engine.title_block().assumptions.iter().map(Text::from));
    blocks.extend([heading(2, "Assumptions"), Block::List(assumed.collect())]);
    if loads.bearings.is_some() {
        blocks.push(Block::List(super::bearings::beam_assumptions(engine).into()));
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

fn lines(engine: &Engine, numbers: &Numbers) -> Vec<Block> {
    let loads = &numbers.loads;
    let mut blocks = vec![Block::Paragraph(text::line_by_line())];
    blocks.extend(inputs::lines(engine, loads).iter().map(formula));
    for group in results::orders(engine, loads) {
        blocks.push(Block::Heading(2, group.heading));
        blocks.extend(group.lines.iter().map(formula));
    }
    blocks.extend(vectors(engine, loads));
    for quantity in Planar::BOTH {
        if let Some(lines) = results::peak(engine, loads, quantity) {
            let listed = amounts::peak(&amounts::waveform(loads, quantity).peak(), Unit::of(engine, loads, quantity));
            blocks.push(Block::Paragraph(text::peak_of_listed_orders(quantity, listed)));
            blocks.extend(lines.iter().map(formula));
        }
    }
    if let Some(group) = results::torque(engine, loads) {
        blocks.push(Block::Heading(2, group.heading));
        blocks.extend(group.lines.iter().map(formula));
    }
    blocks
}
