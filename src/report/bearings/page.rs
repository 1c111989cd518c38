//! What stands on the page of the main bearings, and on the terminal?

use super::{amounts, plots, tables};
use crate::engine::Engine;
use crate::loads::BearingLoads;
use crate::page::{Block, Document, Text, phrase};

/// The bearings with the largest peak: `bearing 3 with ≈ 18733 N`; none where no bearing feels anything.
pub(in crate::report) fn worst(loads: &BearingLoads) -> Option<Text> {
    let unit = amounts::unit_of(loads);
    let numbers: Vec<String> = loads.worst.iter().map(|index| (index + 1).to_string()).collect();
    let peak = loads.worst.first().map(|index| &loads.bearings[*index].peak)?;
    let size = amounts::size(peak, unit);
    Some(match numbers.as_slice() {
        [only] => phrase!("bearing {} with {} {}", only.clone(), size, unit.name),
        several => phrase!("bearings {} with {} {}", several.join(", "), size, unit.name),
    })
}

/// What stands first: the largest force, and what the tables count in.
pub(in crate::report) fn answer(continuous: &BearingLoads, determinate: &BearingLoads) -> [Text; 3] {
    let largest = match (worst(continuous), worst(determinate)) {
        (Some(continuous), Some(determinate)) => {
            phrase!("Largest force: {}; by the determinate approximation {}.", continuous, determinate)
        }
        _ => "No bearing feels a force: 0 exactly.".into(),
    };
    [
        largest,
        SIGNS.into(),
        "The reactions of every order sum, exactly, to the force of the engine and to its moment.".into(),
    ]
}

const SIGNS: &str = "R is the force that the bearing feels, y its component in the reference direction, x that across it; zero to peak, all \
                     orders shown together; 0 is exact and proved, ≈ decimal.";

/// The peaks of all bearings in one sentence.
pub(in crate::report) fn peaks_in_words(loads: &BearingLoads) -> Text {
    let unit = amounts::unit_of(loads);
    let peaks = Text::joined(loads.bearings.iter().map(|bearing| amounts::size(&bearing.peak, unit)), ", ");
    let numbers: Vec<String> = loads.worst.iter().map(|index| (index + 1).to_string()).collect();
    let worst = match numbers.as_slice() {
        [] => Text::from("none is loaded"),
        [only] => phrase!("bearing {} is the worst", only.clone()),
        several => phrase!("bearings {} are the worst", several.join(", ")),
    };
    phrase!("The peaks of the bearings in {} are, in order, {}: {}.", unit.name, peaks, worst)
}

pub(in crate::report) const ASSUMPTIONS: [&str; 4] = [
    "The shaft is one straight beam of constant stiffness EI on rigid bearings in line that have no clearance and do not clamp it; masses of the shaft \
     itself that the layout does not name are left out.",
    "The loads are the inertia forces: those of the reciprocating masses along the cylinder axes, and those of the masses that turn. No gas force, no weight.",
    "The side force between piston and cylinder, about λ/2 of m r ω² per cylinder, is left out, on the piston and on the crankpin: with both the engine as a whole feels no force of it, only the inertia torque.",
    "In the determinate approximation each span is a beam of its own: the two bearings beside a load share it by the law of the lever.",
];

const METHOD: &str = "A unit load at a position is carried by the bearings in fixed parts, found without rounding by the equation of three moments \
    (Clapeyron 1857); the parts of a row sum to 1 and their moments to that of the load. Each order of each reaction is the sum of the \
    order's vectors, each times the part of its position: the closed forms below are exact.";

const VECTORS: &str = "The two vectors of each order, exact in multiples of m r times the coefficient of the order, and in decimals half of that times \
    the coefficient and ω², with the angle at θ = 0:";

/// The short answer: the peaks of every bearing, and the largest value of each order.
pub fn bearings_answer(engine: &Engine, continuous: &BearingLoads, determinate: &BearingLoads) -> Document {
    let mut answer_page = Document::new("bearings", engine.title());
    answer_page.push(tables::peaks(engine, continuous, determinate));
    answer_page.push(tables::orders(continuous));
    answer_page.blocks.extend(answer(continuous, determinate).map(Block::Paragraph));
    answer_page
}

/// The page, with two pictures of each bearing.
pub fn bearings_page(engine: &Engine, continuous: &BearingLoads, determinate: &BearingLoads) -> Document {
    let mut page = Document::new("bearings", phrase!("{}: main bearings", engine.title()));
    let section = |page: &mut Document, words: &'static str| page.push(Block::Heading(1, words.into()));
    page.push(Block::Answer(answer(continuous, determinate).to_vec()));
    page.push(tables::peaks(engine, continuous, determinate));
    section(&mut page, "Order by order");
    page.push(Block::Paragraph("The largest value of each order:".into()));
    page.push(tables::orders(continuous));
    page.push(Block::Paragraph(VECTORS.into()));
    page.push(tables::vectors(continuous));
    section(&mut page, "Through a revolution");
    for (index, pictures) in plots::drawings(continuous).into_iter().enumerate() {
        page.push(Block::Heading(2, phrase!("Bearing {}", index + 1)));
        page.push(Block::Pictures(pictures.into()));
    }
    section(&mut page, "Parts of a load");
    page.push(Block::Paragraph(METHOD.into()));
    page.push(tables::parts(engine, continuous));
    section(&mut page, "Assumptions");
    page.push(Block::List(ASSUMPTIONS.map(Text::from).into()));
    page
}
