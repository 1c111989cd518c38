//! What is on the page of the main bearings, and on the terminal?

use super::super::calculation::{self, percent_at_most};
use super::amounts::orders_of;
use super::{amounts, links, plots, tables};
use crate::engine::Engine;
use crate::loads::{BearingLoads, left_out_of_bearings, pin_loads};
use crate::page::{Block, Document, Text, phrase};
use crate::report::texts::bearings as text;

/// The bearings with the largest peak: `bearing 3 with ≈ 18746 N`; none where no bearing feels anything.
pub(in crate::report) fn worst(loads: &BearingLoads) -> Option<Text> {
    let unit = amounts::unit_of(loads);
    let numbers = names(loads);
    let peak = loads.worst.first().map(|index| &loads.bearings[*index].peak)?;
    let size = amounts::size(peak, unit);
    Some(phrase!("{} with {} {}", called(&numbers), size, unit.label()))
}

/// Bearings by their names: `bearing 3`, `bearings 2, 4`.
pub(in crate::report) fn called(names: &[String]) -> Text {
    match names {
        [only] => phrase!("bearing {}", only.clone()),
        several => phrase!("bearings {}", listed(several)),
    }
}

/// Names in a row, each a label by itself: a list in another language has it alone.
fn listed(names: &[String]) -> Text {
    Text::joined(names.iter().cloned().map(Text::label), ", ")
}

/// What the bearings with the largest peak are called.
fn names(loads: &BearingLoads) -> Vec<String> {
    loads.worst.iter().map(|index| loads.bearings[*index].name.clone()).collect()
}

/// What stands first: the largest force, and what the tables count in.
pub(in crate::report) fn first_lines(
    engine: &Engine,
    continuous: &BearingLoads,
    determinate: &BearingLoads,
) -> [Text; 3] {
    let largest = match (worst(continuous), worst(determinate)) {
        (Some(continuous), Some(determinate)) => text::largest(continuous, determinate),
        _ => text::no_force(left_out(engine, continuous).is_some()),
    };
    [largest, text::signs(), text::sums()]
}

/// The peaks of all bearings in one sentence.
pub(in crate::report) fn peaks_in_words(loads: &BearingLoads) -> Text {
    let unit = amounts::unit_of(loads);
    let peaks = Text::joined(loads.bearings.iter().map(|bearing| amounts::size(&bearing.peak, unit)), ", ");
    let numbers = names(loads);
    let worst = match numbers.as_slice() {
        [] => "none is loaded".into(),
        [only] => text::worst(only.clone()),
        several => text::several_worst(listed(several)),
    };
    text::peaks(unit.label(), peaks, worst)
}

/// What the orders that are not shown add at most.
pub(in crate::report) fn left_out(engine: &Engine, loads: &BearingLoads) -> Option<Text> {
    let unit = amounts::unit_of(loads);
    let bound = left_out_of_bearings(engine, loads).ok()??;
    let words = match bound.part() {
        Some(part) => text::left_out_part(percent_at_most(part)),
        None => text::left_out(calculation::bound(bound.most, unit), unit.label()),
    };
    // Only what rods add has a bound in closed form.
    Some(if engine.only_rods().is_err() { text::not_proved(words) } else { words })
}

/// The same in a cell.
pub(in crate::report) fn left_out_in_short(engine: &Engine, loads: &BearingLoads) -> Option<Text> {
    let unit = amounts::unit_of(loads);
    let bound = left_out_of_bearings(engine, loads).ok()??;
    let words = match bound.part() {
        Some(part) => phrase!("{} % of the largest", percent_at_most(part)),
        None => phrase!("{} {}", calculation::bound(bound.most, unit), unit.label()),
    };
    Some(if engine.only_rods().is_err() { phrase!("{}, not proved", words) } else { words })
}

/// The short answer: the peaks of every bearing, and the largest value of each order.
pub fn bearings_answer(engine: &Engine, continuous: &BearingLoads, determinate: &BearingLoads) -> Document {
    let mut answer_page = Document::new("bearings", engine.title());
    answer_page.push(tables::peaks(engine, continuous, determinate));
    answer_page.push(tables::orders(continuous));
    answer_page.blocks.extend(first_lines(engine, continuous, determinate).map(Block::Paragraph));
    answer_page.blocks.extend(links::answer(engine).map(Block::Paragraph));
    answer_page.blocks.extend(left_out(engine, continuous).map(Block::Paragraph));
    answer_page
}

/// The page, with two pictures of each bearing.
pub fn bearings_page(engine: &Engine, continuous: &BearingLoads, determinate: &BearingLoads) -> Document {
    let answer = first_lines(engine, continuous, determinate).into_iter().chain(links::answer(engine));
    let pictures = continuous.bearings.iter().zip(plots::drawings(engine.convention(), continuous));
    let each_bearing = pictures.flat_map(|(bearing, pictures)| {
        [Block::Heading(2, phrase!("Bearing {}", bearing.name.clone())), Block::Pictures(pictures.into())]
    });
    let pins = pin_loads(engine, &orders_of(continuous)).map(|pins| tables::pins(engine, &pins));
    text::Page {
        engine: engine.title().into(),
        answer: Block::Answer(answer.collect()).into(),
        peaks: tables::peaks(engine, continuous, determinate).into(),
        orders: by_orders(engine, continuous).into(),
        each_bearing: each_bearing.collect(),
        pins: pins.ok().filter(|pins| !pins.rows.is_empty()).into(),
        articulated_rods: links::blocks(engine).into(),
        parts: parts_of_a_load(engine, continuous).into(),
        assumptions: beam_assumptions(engine).into(),
    }
    .document()
}

/// What the loads of the main bearings rest on.
pub(in crate::report) fn beam_assumptions(engine: &Engine) -> [Text; 4] {
    let [shaft, loads, rods, determinate] = text::assumptions();
    [shaft, loads, if engine.has_yokes_alone() { text::yokes() } else { rods }, determinate]
}

/// The largest value of each order, what is omitted, and the exact vectors.
pub(in crate::report) fn by_orders(engine: &Engine, loads: &BearingLoads) -> Vec<Block> {
    let mut blocks = vec![text::largest_values().into(), tables::orders(loads).into()];
    blocks.extend(left_out(engine, loads).map(Block::Paragraph));
    blocks.extend([text::vectors().into(), tables::vectors(loads).into()]);
    if let Some(numbers) = tables::numbers(engine, loads) {
        blocks.extend([text::coefficients().into(), numbers.into()]);
    }
    blocks
}

/// Which part of a load each bearing carries, and how that was found.
pub(in crate::report) fn parts_of_a_load(engine: &Engine, loads: &BearingLoads) -> Vec<Block> {
    vec![text::method().into(), tables::parts(engine, loads).into()]
}
