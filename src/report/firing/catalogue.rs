//! Which orders of the gas torque does each engine of the catalogue leave? One table per cycle, and the proof of each engine.

use super::super::argument;
use super::super::typeset;
use super::words;
use super::{FiringStudy, page};
use crate::engine::{Cycle, Engine, Firing};
use crate::file::Entry;
use crate::firing::{FiringPattern, NoStar, Weights};
use crate::page::{Block, Document, Table, Text, phrase};
use crate::report::texts::firing_catalogue as text;

/// The engine as it runs in this cycle: any as a two-stroke, one that says when it fires as a four-stroke.
///
/// # Errors
/// An engine that does not say when it fires in this cycle.
pub fn run_as(engine: &Engine, cycle: Cycle) -> Result<Engine, NoStar> {
    match (cycle, engine.cycle(), engine.firing()) {
        (Cycle::FourStroke, Some(Cycle::FourStroke), Some(_)) => Ok(engine.clone()),
        (Cycle::FourStroke, _, _) => Err(NoStar::NoFiring),
        (Cycle::TwoStroke, _, _) => {
            let mut draft = engine.clone().into_draft();
            draft.cycle = Some(cycle);
            draft.firing = Some(Firing::two_stroke(engine.cylinders()));
            draft.build().map_err(|_| NoStar::NoFiring)
        }
    }
}

/// The engines of the catalogue as they run in a cycle.
struct Runs {
    cycle: Cycle,
    runs: Vec<(Entry, Option<Engine>)>,
}

impl Runs {
    fn new(engines: &[(Entry, Engine)], cycle: Cycle) -> Self {
        Runs { cycle, runs: engines.iter().map(|(entry, engine)| (*entry, run_as(engine, cycle).ok())).collect() }
    }

    /// The stars of those that say when they fire.
    fn studies(&self) -> Vec<(Entry, FiringStudy)> {
        let study = |engine| FiringStudy::new(engine, &[], Weights::Rigid).ok();
        self.runs.iter().filter_map(|(entry, engine)| Some((*entry, study(engine.as_ref()?)?))).collect()
    }

    /// What is found of all, with a table; engines that do not say when they fire are named, and nothing else is said of them.
    fn answer(&self, studies: &[(Entry, FiringStudy)]) -> Document {
        let (name, title, words) = match self.cycle {
            Cycle::FourStroke => ("four-stroke", "Firing stars of four-stroke engines", text::four_stroke()),
            Cycle::TwoStroke => ("two-stroke", "Firing stars of two-stroke engines", text::two_stroke()),
        };
        let mut page = Document::new(name, title);
        page.push(Block::Answer(found(studies)));
        page.push(words);
        page.push(table(studies));
        let silent = self.runs.iter().filter(|(_, engine)| engine.is_none()).map(|(entry, _)| entry.name);
        let silent: Vec<&str> = silent.collect();
        if !silent.is_empty() {
            page.push(Block::Note(text::no_firing_order(silent.join(", "))));
        }
        page
    }
}

/// The table of a cycle.
pub fn firing_catalogue_answer(engines: &[(Entry, Engine)], cycle: Cycle) -> Document {
    let runs = Runs::new(engines, cycle);
    runs.answer(&runs.studies())
}

/// The page of a cycle: the table, and the proof of each engine.
pub fn firing_catalogue_page(engines: &[(Entry, Engine)], cycle: Cycle) -> Document {
    let runs = Runs::new(engines, cycle);
    let studies = runs.studies();
    let mut page = runs.answer(&studies);
    page.push(Block::Heading(1, "Proofs".into()));
    page.blocks.extend(studies.iter().filter_map(|(entry, study)| proof(*entry, study)));
    page.section("Assumptions", Block::List(page::assumed(false)));
    page
}

/// What holds of all of them: counted, not supposed.
fn found(studies: &[(Entry, FiringStudy)]) -> Vec<Text> {
    let leaves_minor = |study: &FiringStudy| study.pattern().is_ok_and(leaves_minor);
    let is_even = |study: &FiringStudy| study.engine.firing().is_some_and(Firing::is_even);
    let count = |holds: &dyn Fn(&FiringStudy) -> bool| studies.iter().filter(|(_, study)| holds(study)).count();
    let even = count(&is_even);
    let fires = match count(&|study| is_even(study) && leaves_minor(study)) {
        0 => text::even_without_minor(even, studies.len()),
        minor => text::even_with_minor(even, studies.len(), minor),
    };
    vec![fires, text::with_minor(count(&leaves_minor))]
}

fn leaves_minor(pattern: &FiringPattern) -> bool {
    pattern.left().any(|order| !order.is_major())
}

/// Engines × (intervals, orders left, strongest minor order).
fn table(studies: &[(Entry, FiringStudy)]) -> Table {
    let name = |entry: &Entry| Text::link(entry.name.to_owned(), format!("../{}/report.md", entry.name));
    Table::of(studies)
        .column("Engine", |(entry, _)| name(entry))
        .column("Firing intervals", |(_, study)| intervals(&study.engine))
        .column("Residual orders of the gas torque", |(_, study)| match study.pattern() {
            Ok(pattern) => words::left_in_short(pattern),
            Err(why) => words::no_pattern(why),
        })
        .column("Strongest minor order", |(_, study)| match study.pattern() {
            // Orders of several stars have no length to be compared by.
            Ok(pattern) if leaves_minor(pattern) => {
                words::strongest_in_short(pattern).unwrap_or_else(|| "several stars".into())
            }
            Ok(_) => "none".into(),
            Err(_) => "–".into(),
        })
        .done()
}

/// `18 × 40°`, or each of them.
fn intervals(engine: &Engine) -> Text {
    let Some(firing) = engine.firing() else { return "–".into() };
    let all = firing.intervals();
    match (all.as_slice(), firing.is_even()) {
        ([first, ..], true) => phrase!("{} × {}", all.len(), typeset::turns_in_decimals(first)),
        _ => typeset::listed(all.iter().map(typeset::turns_in_decimals)).into(),
    }
}

/// The stars of one period, up to its middle: the others are their mirror images.
fn proof(entry: Entry, study: &FiringStudy) -> Option<Block> {
    let pattern = study.pattern().ok()?;
    let lines = pattern.half().flat_map(|order| order.stars.iter().map(move |star| (order, star)));
    let mut blocks = vec![Block::Paragraph(words::why(pattern))];
    let (argued, certified): (Vec<Text>, Vec<Text>) = lines
        .map(|(order, star)| {
            let certificate = argument::certificate_of(&star.sum, &star.certificate);
            (page::argued(study, order, star), phrase!("Order {}: {}", order.order.to_string(), certificate))
        })
        .unzip();
    blocks.extend([Block::List(argued), Block::List(certified)]);
    Some(Block::folded(phrase!("{}: {}", Text::label(entry.name), study.engine.title()), blocks))
}
