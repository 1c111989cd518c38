//! What is told of the catalogue? A row per engine on a terminal; on a page the families with their stars.

use super::super::engine_cells;
use super::{Family, Known, answer, families, pictures};
use crate::engine::{Engine, Firing};
use crate::file::Entry;
use crate::page::{Block, Document, Table, Text, phrase};

/// The list: a row per engine, as narrow as a terminal.
pub fn catalogue_answer(engines: &[(Entry, Engine)]) -> Document {
    let mut table = Table::new(["Name", "Engine", "Firing", "Force", "Moment"]);
    for known in families(engines).iter().flat_map(|family| &family.engines) {
        let [force, moment] = orders(known);
        table.push(vec![
            Text::label(known.name),
            known.engine.title().into(),
            firing(known.engine.firing()),
            force,
            moment,
        ]);
    }
    let mut page = Document::new("catalogue", "The catalogue");
    page.push(table);
    page.push(Block::Note(LIST.into()));
    page
}

const LIST: &str = "Force, Moment: the lowest order that is left of it, of all that exist; none: no order is. \
    `crankstar classify NAME` tells how much.";

/// How it fires, in a word.
fn firing(firing: Option<&Firing>) -> Text {
    match firing {
        Some(firing) if firing.is_even() => engine_cells::firing(Some(firing)),
        Some(_) => "uneven".into(),
        None => "not given".into(),
    }
}

/// The numbers of the lowest orders left.
fn orders(known: &Known) -> [Text; 2] {
    match known.first() {
        Some(first) => first.map(|first| first.map_or_else(|| "none".into(), |first| first.order.into())),
        None => ["not stated".into(), "not stated".into()],
    }
}

/// The page over the reports of the catalogue.
pub fn catalogue_page(engines: &[(Entry, Engine)]) -> Document {
    let families = families(engines);
    let mut page = Document::new("README", "The catalogue");
    let mut lines = vec![phrase!("{} engines, a report each, every verdict proved.", engines.len())];
    lines.extend(answer(&families));
    page.push(Block::Answer(lines));
    page.has_contents = true;
    for family in &families {
        page.push(Block::Heading(1, family.heading.into()));
        page.push(table(family));
        page.push(pictures(family));
    }
    page.push(Block::Heading(1, "How it is read".into()));
    page.push(Block::List(READ.map(Text::from).into()));
    page.push(Block::Heading(1, "Beside the catalogue".into()));
    let beside = BESIDE.map(|(target, name, words)| phrase!(words, Text::link(name, target)));
    page.push(Block::List(beside.into()));
    page
}

/// The engines of a family, with what each leaves first.
fn table(family: &Family) -> Table {
    let mut table = Table::new(["Name", "Engine", "Firing", "First force left", "First moment left"]);
    for known in &family.engines {
        let [force, moment] = known.cells();
        table.push(vec![
            Text::link(Text::label(known.name), format!("{}/report.md", known.name)),
            known.engine.title().into(),
            engine_cells::firing(known.engine.firing()),
            force,
            moment,
        ]);
    }
    table
}

const READ: [&str; 3] = [
    "First left is the lowest order that is left of all that exist with centric cranks: 1 and the even ones. None: no order is left, proved for all of them.",
    "Behind the order stands the largest value through a revolution: forces in $m r \\omega^2 c_k$, moments in that times the spacing of the \
     cylinders, about the middle of the engine. A number after ≈ is a decimal, any other is exact.",
    "Rotating: a vector of constant length that turns with the crank; counter-rotating: against it; planar: it swings along a line; elliptical: neither.",
];

const BESIDE: [(&str, &str, &str); 16] = [
    (
        "atlas/README.md",
        "Atlas",
        "{}: the catalogue and the best in-line stars of 2 to 12 cylinders at orders 1 to 8, for print and as CSV.",
    ),
    (
        "stars/README.md",
        "Stars",
        "{}: what the crank star of 2 to 30 cylinders can lose and what never, with proofs; four engines to try.",
    ),
    ("families", "Families", "{}: engines with open angles and lengths."),
    ("examples", "Examples", "{}: engines with numbers, in newtons."),
    (
        "engines/README.md",
        "Engines of the world",
        "{}: engines that were built, what is known of them beside what is found.",
    ),
    ("claims/README.md", "Claims", "{}: published claims, checked."),
    (
        "firing/four-stroke.md",
        "Firing",
        "{}: which orders of the gas torque each engine leaves, and what is said of firing orders, checked.",
    ),
    ("thesis/README.md", "Thesis", "{}: a chapter of a thesis, reproduced."),
    ("accuracy/README.md", "Accuracy", "{}: what accuracy costs."),
    ("trust/README.md", "Trust", "{}: 100,000 random engines beside an independent method."),
    ("speed/README.md", "Speed", "{}: times on one machine, beside other programs, with the commands that took them."),
    ("stability/README.md", "Stability", "{}: hard cases, to fifty digits."),
    (
        "v-angles/README.md",
        "V angles",
        "{}: all bank angles and pin splits at which a V balances, for every star of up to six pins.",
    ),
    ("forms/README.md", "Closed forms", "{}: lengths as a person writes them, before and after."),
    ("optimise/README.md", "Optimise", "{}: the best crankshafts of three engines, bearing load against mass."),
    ("grigoryev/README.md", "Grigoryev", "{}: a published sweep of V angles, checked."),
];
