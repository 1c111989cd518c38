//! What does the atlas show? Every engine of the catalogue and the best stars in line, at orders 1 to 8, in one table each.

mod cells;
mod csv;
mod entry;

use serde::Serialize;

use super::dialect::Dialect;
use super::folder::File;
use super::{engine_cells, render};
use crate::engine::{BuildError, Cycle, Engine};
use crate::file::Entry;
use crate::search::Best;
use entry::{EngineRow, Origin};

/// Numbers of cylinders whose best stars stand in the atlas.
pub const ATLAS_CYLINDERS: std::ops::RangeInclusive<u32> = 2..=12;
/// The orders of the atlas.
const ORDERS: [u32; 8] = [1, 2, 3, 4, 5, 6, 7, 8];
/// The orders that the remedies are for.
const REMEDIED: [u32; 2] = [1, 2];

/// What the templates place.
#[derive(Serialize)]
struct Page {
    orders: [u32; 8],
    notes: Vec<String>,
    sections: Vec<Section>,
    forms: Vec<[String; 3]>,
}

/// One table.
#[derive(Serialize)]
struct Section {
    heading: &'static str,
    intro: String,
    /// What the column of the firing is called.
    last: &'static str,
    rows: Vec<cells::Row>,
}

/// The atlas in three files: `README.md`, `atlas.tex` and `atlas.csv`.
///
/// # Errors
/// Those of a layout file, for a star that is no engine; none is known to arise.
pub fn atlas(engines: &[(Entry, Engine)], stars: &[Best]) -> Result<Vec<File>, BuildError> {
    let mut all: Vec<EngineRow> = engines.iter().map(|(known, layout)| EngineRow::known(known.name, layout)).collect();
    for best in stars {
        for star in &best.stars {
            all.push(EngineRow::found(best, star)?);
        }
    }
    let file = |name: &str, text: String| File { name: name.to_owned(), text };
    let page = |dialect| render::atlas(&page(&all, dialect), dialect);
    Ok(vec![
        file("README.md", page(Dialect::GithubMarkdown)),
        file("atlas.tex", page(Dialect::Latex)),
        file("atlas.csv", csv::csv(&all)),
    ])
}

const NOTES: [&str; 6] = [
    "**0** is exact and proved; the other numbers are the largest value through a revolution, $\\tfrac{1}{2}(\\lvert P^{+} \\rvert + \\lvert P^{-} \\rvert)$, \
     = exact, ≈ decimal: forces in $m r \\omega^2 c_k$, moments in that times the spacing (the unit of the positions), about the middle of the engine.",
    "Orders 3, 5 and 7 exist only where the cylinder axes miss the crankshaft (pin offset): with centric cranks their $c_k$ is 0. **First left** is the \
     lowest order that is left of all that exist with centric cranks: 1 and the even ones.",
    "Rotating: a vector of constant length that turns with the crank; counter-rotating: against it; planar: it swings along a line; elliptical: neither.",
    engine_cells::REMEDIES,
    "Remedies are those of orders 1 and 2, for the reciprocating masses.",
    "Closed forms of more than 24 signs are left to the list at the end (orders 1 and 2) and to atlas.csv (all).",
];

fn page(all: &[EngineRow], dialect: Dialect) -> Page {
    let section = |heading, intro: &str, origin: Origin| {
        let engines = all.iter().filter(|engine| engine.origin == origin);
        let last = if origin == Origin::Catalogue { "Firing" } else { "As good" };
        Section {
            heading,
            intro: dialect.prose(intro),
            last,
            rows: engines.map(|e| cells::Row::new(e, dialect)).collect(),
        }
    };
    let sections = vec![
        section("The catalogue", "What each engine leaves of every order, and how it moves.", Origin::Catalogue),
        section("The best stars in line, two-stroke", TWO_STROKE, Origin::Found(Cycle::TwoStroke)),
        section("The best stars in line, four-stroke", FOUR_STROKE, Origin::Found(Cycle::FourStroke)),
    ];
    Page {
        orders: ORDERS,
        notes: NOTES.iter().map(|note| dialect.prose(note)).collect(),
        sections,
        forms: cells::longer_forms(all, dialect),
    }
}

const TWO_STROKE: &str = "All crank stars of 2 to 12 cylinders that fire evenly, one spacing apart, judged exactly: those that no other \
    equals in the moments of orders 1 and 2 and beats in one. An engine is named by its number of cylinders and its firing order; as good are the stars (with cylinder 1 at 0°) that have \
    the same moments of orders 1 and 2. All cylinder axes are parallel, so that every force and moment is planar.";

const FOUR_STROKE: &str = "The same for four-stroke engines. With an odd number of cylinders the stars are those of the two-stroke engine, in another firing order.";
