//! What stands on the page of the main bearings?

use serde::Serialize;

use super::super::calculation::Rows;
use super::super::dialect::Dialect;
use super::super::folder::File;
use super::super::page::NamedFigure;
use super::super::render;
use super::super::table::Table;
use super::amounts;
use super::{plots, tables};
use crate::engine::Engine;
use crate::loads::BearingLoads;

#[derive(Serialize)]
struct Page {
    title: String,
    headline: Vec<String>,
    peaks: Table,
    assumptions: Vec<String>,
    method: String,
    parts: Table,
    orders: Table,
    vectors: Table,
    bearings: Vec<Section>,
}

#[derive(Serialize)]
struct Section {
    heading: String,
    drawings: Vec<Drawing>,
}

#[derive(Serialize)]
struct Drawing {
    caption: String,
    file: String,
}

/// The bearings with the largest peak: `bearing 3 with ≈ 18733 N`; none where no bearing feels anything.
pub(in super::super) fn worst(loads: &BearingLoads) -> Option<String> {
    let unit = amounts::unit_of(loads);
    let numbers: Vec<String> = loads.worst.iter().map(|index| (index + 1).to_string()).collect();
    let named = if numbers.len() == 1 { "bearing" } else { "bearings" };
    let peak = loads.worst.first().map(|index| &loads.bearings[*index].peak);
    peak.map(|peak| format!("{named} {} with {} {}", numbers.join(", "), amounts::size(peak, unit), unit.name))
}

/// What follows the tables on a terminal, and stands first on the page.
pub fn bearings_lines(continuous: &BearingLoads, determinate: &BearingLoads) -> Vec<String> {
    let largest = match (worst(continuous), worst(determinate)) {
        (Some(continuous), Some(determinate)) => {
            format!("Largest force: {continuous}; by the determinate approximation {determinate}.")
        }
        _ => "No bearing feels a force: 0 exactly.".to_owned(),
    };
    vec![
        largest,
        "R is the force that the bearing feels, y its component in the reference direction, x that across it; zero to peak, all orders shown together; 0 is exact and proved, ≈ decimal."
            .to_owned(),
        "The reactions of every order sum, exactly, to the force of the engine and to its moment.".to_owned(),
    ]
}

/// The peaks of all bearings in one sentence.
pub(in crate::report) fn peaks_in_words(loads: &BearingLoads) -> String {
    let unit = amounts::unit_of(loads);
    let peaks: Vec<String> = loads.bearings.iter().map(|bearing| amounts::size(&bearing.peak, unit)).collect();
    let numbers: Vec<String> = loads.worst.iter().map(|index| (index + 1).to_string()).collect();
    let worst = match numbers.as_slice() {
        [] => "none is loaded".to_owned(),
        [only] => format!("bearing {only} is the worst"),
        several => format!("bearings {} are the worst", several.join(" and ")),
    };
    format!("The peaks of the bearings in {} are, in order, {}: {worst}.", unit.name, peaks.join(", "))
}

pub(in crate::report) const ASSUMPTIONS: [&str; 4] = [
    "The shaft is one straight beam of constant stiffness EI on rigid bearings in line that have no clearance and do not clamp it; masses of the shaft \
     itself that the layout does not name are left out.",
    "The loads are the inertia forces: those of the reciprocating masses along the cylinder axes, and those of the masses that turn. No gas force, no weight.",
    "The side force between piston and cylinder, about λ/2 of m r ω² a cylinder, is left out, on the piston and on the crankpin: with both the engine as a whole feels no force of it, only the inertia torque.",
    "In the determinate approximation each span is a beam of its own: the two bearings beside a load share it by the law of the lever.",
];

const METHOD: &str = "A unit load at a position is carried by the bearings in fixed parts, found without rounding by the equation of three moments \
    (Clapeyron 1857); the parts of a row sum to 1 and their moments to that of the load. Each order of each reaction is the sum of the \
    order's vectors, each times the part of its position: the closed forms below are exact.";

/// The page with its drawings: `bearings.md` and two SVG files a bearing.
pub fn bearings_page(engine: &Engine, continuous: &BearingLoads, determinate: &BearingLoads) -> Vec<File> {
    let dialect = Dialect::GithubMarkdown;
    let set = |rows: Rows| {
        let header: Vec<&str> = rows.header.iter().map(String::as_str).collect();
        Table::new(dialect, &header, rows.rows)
    };
    let drawings = plots::drawings(continuous);
    let drawing = |named: &NamedFigure| Drawing { caption: named.caption.clone(), file: format!("{}.svg", named.name) };
    let section = |(index, drawn): (usize, &[NamedFigure; 2])| Section {
        heading: format!("Bearing {}", index + 1),
        drawings: drawn.iter().map(drawing).collect(),
    };
    let page = Page {
        title: dialect.quoted(engine.title()),
        headline: bearings_lines(continuous, determinate).iter().map(|line| dialect.prose(line)).collect(),
        peaks: set(tables::bearings_rows(engine, continuous, determinate)),
        assumptions: ASSUMPTIONS.iter().map(|line| dialect.prose(line)).collect(),
        method: dialect.prose(METHOD),
        parts: set(tables::parts(engine, continuous)),
        orders: set(tables::bearings_tables(continuous)),
        vectors: set(tables::vectors(continuous)),
        bearings: drawings.iter().enumerate().map(section).collect(),
    };
    let mut files = vec![File { name: "bearings.md".into(), text: render::bearings(&page) }];
    files.extend(drawings.into_iter().flatten().map(NamedFigure::into_svg));
    files
}
