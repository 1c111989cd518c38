//! The page over the reports of the catalogue: the families with their stars. `reports/README.md`.

use crankstar::engine::Engine;
use crankstar::file::Entry;
use crankstar::page::{Block, Document, Table, Text};
use crankstar::report::{self, CatalogueFamily, FirstOrderLeft};

/// The page over the reports of the catalogue.
pub fn page(engines: &[(Entry, Engine)]) -> Document {
    let families = report::catalogue_families(engines);
    let mut page = Document::new("README", "The catalogue");
    let mut lines = vec![Text::phrase("{} engines, a report each, every verdict proved.", vec![engines.len().into()])];
    lines.extend(report::catalogue_summary(&families));
    page.push(Block::Answer(lines));
    page.has_contents = true;
    for family in &families {
        page.push(Block::Heading(1, family.heading.into()));
        page.push(table(family));
        page.push(report::catalogue_pictures(family));
    }
    page.push(Block::Heading(1, "How to read it".into()));
    page.push(Block::List(READ.map(Text::from).into()));
    page.push(Block::Heading(1, "Beside the catalogue".into()));
    let beside = BESIDE.map(|(target, name, words)| Text::phrase(words, vec![Text::link(name, target)]));
    page.push(Block::List(beside.into()));
    page
}

/// The engines of a family, with what each leaves first.
fn table(family: &CatalogueFamily) -> Table {
    let mut table = Table::new(["Name", "Engine", "Firing", "Force from order", "Moment from order"]);
    for known in &family.engines {
        let [force, moment] = match known.first() {
            Some(first) => first.map(|first| first.map_or_else(|| "none".into(), left)),
            None => ["not stated".into(), "not stated".into()],
        };
        table.push(vec![
            Text::link(Text::label(known.name), format!("{}/report.md", known.name)),
            known.engine.title().into(),
            report::firing_cell(known.engine.firing()),
            force,
            moment,
        ]);
    }
    table
}

/// `order 2: 4, planar`.
fn left(first: FirstOrderLeft) -> Text {
    let shape = report::shape_name(first.shape).into();
    match first.size {
        Some(size) => Text::phrase("order {}: {}, {}", vec![first.order.into(), size, shape]),
        None => Text::phrase("order {}: {}", vec![first.order.into(), shape]),
    }
}

const READ: [&str; 3] = [
    "First left is the lowest order that remains of all that exist with centric cranks: 1 and the even ones. None: no order remains, proved for all of them.",
    "Behind the order stands the largest value through a revolution: forces in $m r \\omega^2 c_k$, moments in that times the spacing of the \
     cylinders, about the middle of the engine. A number after ≈ is a decimal, any other is exact.",
    "Rotating: a vector of constant length that turns with the crank; counter-rotating: against it; planar: it swings along a line; elliptical: neither.",
];

const BESIDE: [(&str, &str, &str); 17] = [
    (
        "atlas/README.md",
        "Atlas",
        "{}: the catalogue and the best in-line stars of 2 to 12 cylinders at orders 1 to 8, for print and as CSV.",
    ),
    (
        "stars/README.md",
        "Stars",
        "{}: which moments of 2 to 30 cylinders in line can vanish and which cannot, with proofs; four engines to try.",
    ),
    ("families", "Families", "{}: engines with open angles and lengths."),
    ("examples", "Examples", "{}: engines with numbers, in newtons."),
    (
        "questions",
        "Questions",
        "{}: a page of each question beside the report: values at an angle, a flywheel, a project guide's moments, an engine on its mounts, masses on a shaft.",
    ),
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
    ("forms/README.md", "Closed forms", "{}: lengths in closed form, before and after."),
    ("optimise/README.md", "Optimise", "{}: the best crankshafts of three engines, bearing load against mass."),
    ("grigoryev/README.md", "Grigoryev", "{}: a published sweep of V angles, checked."),
];
