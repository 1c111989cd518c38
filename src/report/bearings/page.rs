//! What is on the page of the main bearings, and on the terminal?

use super::super::calculation::{self, percent_at_most};
use super::amounts::orders_of;
use super::{amounts, links, plots, tables};
use crate::engine::Engine;
use crate::loads::{BearingLoads, left_out_of_bearings, pin_loads};
use crate::page::{Block, Document, Text, phrase};

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
        several => phrase!("bearings {}", several.join(", ")),
    }
}

/// What the bearings with the largest peak are called.
fn names(loads: &BearingLoads) -> Vec<String> {
    loads.worst.iter().map(|index| loads.bearings[*index].name.clone()).collect()
}

/// What stands first: the largest force, and what the tables count in.
pub(in crate::report) fn first_lines(continuous: &BearingLoads, determinate: &BearingLoads) -> [Text; 3] {
    let largest = match (worst(continuous), worst(determinate)) {
        (Some(continuous), Some(determinate)) => {
            phrase!("Largest force: {}; by the determinate approximation {}.", continuous, determinate)
        }
        _ => "No bearing carries a force: 0 exactly.".into(),
    };
    [
        largest,
        SIGNS.into(),
        "The reactions of every order sum, exactly, to the loads of the crankpins and of the crankshaft, and their moments to those of these loads.".into(),
    ]
}

const SIGNS: &str = "R is the force on the bearing, y its component in the reference direction, x that across it; zero to peak, all orders shown together; 0 is exact and proved, ≈ decimal.";

/// The peaks of all bearings in one sentence.
pub(in crate::report) fn peaks_in_words(loads: &BearingLoads) -> Text {
    let unit = amounts::unit_of(loads);
    let peaks = Text::joined(loads.bearings.iter().map(|bearing| amounts::size(&bearing.peak, unit)), ", ");
    let numbers = names(loads);
    let worst = match numbers.as_slice() {
        [] => Text::from("none is loaded"),
        [only] => phrase!("bearing {} is the worst", only.clone()),
        several => phrase!("bearings {} are the worst", several.join(", ")),
    };
    phrase!("The peaks of the bearings in {} are, in order, {}: {}.", unit.label(), peaks, worst)
}

pub(in crate::report) const ASSUMPTIONS: [&str; 4] = [
    "The shaft is one straight beam of constant stiffness EI on rigid bearings in line that have no clearance and do not clamp it; masses of the shaft that the layout does not give are neglected.",
    "The loads are the inertia forces: those of the reciprocating masses, with the side force between piston and cylinder that they cause, and those of the rotating masses. Gas force and weight are neglected.",
    "A rod, two masses at its ends, pushes its crankpin along its own direction, so that the bearings take the side force of the piston, and the walls of the cylinders the opposite. Bearings and walls together take the force of the engine; the bearings alone do not.",
    "In the determinate approximation each span is a beam of its own: the two bearings beside a load share it by the law of the lever.",
];

const METHOD: &str = "A unit load at a position is carried by the bearings in fixed parts, found without rounding by the equation of three moments (Clapeyron 1857); the parts of a row sum to 1 and their moments to that of the load. Each order of each reaction is the sum of the order's vectors, each multiplied by the part of its position: the closed forms below are exact.";

const VECTORS: &str = "The two vectors of each order. Exact: the length of each sum in multiples of m r, with the coefficient of the motion that multiplies it, $c_k$ of the force along the axis and $n_k$ of the side force. In decimals: half of the sums times their numbers and ω², with the angle at θ = 0. Order 0 is a constant force, the mean side force of pistons with an offset; $u_k$ is the part of $n_k$ that $c_k$ does not have; reverse vectors have the conjugates.";

const PINS: &str = "Load of each crankpin by the rod of each cylinder in a revolution: the inertia of the piston, with its side force, and the rotating part of the rod; all orders shown together.";

/// What the orders that are not shown add at most.
pub(in crate::report) fn left_out(engine: &Engine, loads: &BearingLoads) -> Option<Text> {
    let unit = amounts::unit_of(loads);
    let bound = left_out_of_bearings(engine, loads).ok()??;
    let words = match bound.part() {
        Some(part) => {
            phrase!(
                "The orders that are not shown add at most {} % of the largest load to any bearing.",
                percent_at_most(part)
            )
        }
        None => phrase!(
            "The orders that are not shown add at most {} {} to the load of any bearing.",
            calculation::bound(bound.most, unit),
            unit.label()
        ),
    };
    // What links add has no bound in closed form.
    Some(match engine.has_links() {
        true => phrase!("{} With links on a master rod this bound is computed, not proved.", words),
        false => words,
    })
}

/// The short answer: the peaks of every bearing, and the largest value of each order.
pub fn bearings_answer(engine: &Engine, continuous: &BearingLoads, determinate: &BearingLoads) -> Document {
    let mut answer_page = Document::new("bearings", engine.title());
    answer_page.push(tables::peaks(engine, continuous, determinate));
    answer_page.push(tables::orders(continuous));
    answer_page.blocks.extend(first_lines(continuous, determinate).map(Block::Paragraph));
    answer_page.blocks.extend(links::answer(engine).map(Block::Paragraph));
    answer_page.blocks.extend(left_out(engine, continuous).map(Block::Paragraph));
    answer_page
}

/// The page, with two pictures of each bearing.
pub fn bearings_page(engine: &Engine, continuous: &BearingLoads, determinate: &BearingLoads) -> Document {
    let mut page = Document::new("bearings", phrase!("{}: main bearings", engine.title()));
    let section = |page: &mut Document, words: &'static str| page.push(Block::Heading(1, words.into()));
    page.push(Block::Answer(first_lines(continuous, determinate).into_iter().chain(links::answer(engine)).collect()));
    page.push(tables::peaks(engine, continuous, determinate));
    section(&mut page, "Order by order");
    page.blocks.extend(by_orders(engine, continuous));
    section(&mut page, "Through a revolution");
    for (bearing, pictures) in continuous.bearings.iter().zip(plots::drawings(engine.convention(), continuous)) {
        page.push(Block::Heading(2, phrase!("Bearing {}", bearing.name.clone())));
        page.push(Block::Pictures(pictures.into()));
    }
    let pins = pin_loads(engine, &orders_of(continuous));
    if let Ok(pins) = pins {
        section(&mut page, "Crankpins");
        page.push(Block::Paragraph(PINS.into()));
        page.push(tables::pins(engine, &pins));
    }
    page.blocks.extend(links::blocks(engine));
    section(&mut page, "Parts of a load");
    page.blocks.extend(parts_of_a_load(engine, continuous));
    section(&mut page, "Assumptions");
    page.push(Block::List(ASSUMPTIONS.map(Text::from).into()));
    page
}

/// The largest value of each order, what is omitted, and the exact vectors.
pub(in crate::report) fn by_orders(engine: &Engine, loads: &BearingLoads) -> Vec<Block> {
    let mut blocks = vec![Block::Paragraph("The largest value of each order:".into()), tables::orders(loads).into()];
    blocks.extend(left_out(engine, loads).map(Block::Paragraph));
    blocks.extend([Block::Paragraph(VECTORS.into()), tables::vectors(loads).into()]);
    if let Some(numbers) = tables::numbers(engine, loads) {
        blocks.extend([Block::Paragraph("The coefficients of the motion:".into()), numbers.into()]);
    }
    blocks
}

/// Which part of a load each bearing carries, and how that was found.
pub(in crate::report) fn parts_of_a_load(engine: &Engine, loads: &BearingLoads) -> Vec<Block> {
    vec![Block::Paragraph(METHOD.into()), tables::parts(engine, loads).into()]
}
