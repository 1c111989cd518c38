//! What stands on the page of what accuracy costs, on the terminal, and in a report?

use super::engine_torque::PeakRow;
use super::{AccuracyCase, bearings, engine_torque, gas_bearings, plots, tables, words};
use crate::accuracy::{BearingRow, Study};
use crate::engine::Engine;
use crate::page::{Block, Document, Text, phrase};

fn studies(cases: &[AccuracyCase]) -> impl Iterator<Item = (usize, &AccuracyCase, &Study)> {
    let numbered = cases.iter().enumerate();
    numbered.flat_map(|(number, case)| case.studies.iter().map(move |study| (number + 1, case, study)))
}

/// The bearing loads of each case that has main bearings.
pub(super) fn of_bearings(cases: &[AccuracyCase]) -> impl Iterator<Item = (Text, &[BearingRow])> {
    cases.iter().filter_map(|case| Some((case.label(), case.bearings.as_deref()?)))
}

/// The engine torque of each case that has gas.
fn of_gas(cases: &[AccuracyCase]) -> impl Iterator<Item = (Text, &[PeakRow])> {
    cases.iter().filter_map(|case| Some((case.label(), case.engine_torque.as_deref()?)))
}

/// The bearing loads with gas of each case that has both.
fn of_gas_bearings(cases: &[AccuracyCase]) -> impl Iterator<Item = (Text, &[PeakRow])> {
    cases.iter().filter_map(|case| Some((case.label(), case.gas_bearings.as_deref()?)))
}

/// The blocks on bearings and engine torque, of the cases that have them.
fn further(engine: &Engine, cases: &[AccuracyCase]) -> Vec<Block> {
    let mut blocks = Vec::new();
    for (label, rows) in of_bearings(cases) {
        blocks.push(Block::Heading(1, phrase!("Largest bearing load of inertia, {}", label)));
        blocks.push(bearings::table(engine, rows).into());
        blocks.push(Block::Note(bearings::HOW.into()));
    }
    for (label, rows) in of_gas(cases) {
        blocks.push(Block::Heading(1, phrase!("Largest torque, gas and inertia, {}", label)));
        blocks.push(engine_torque::table(rows).into());
        blocks.push(Block::Note(engine_torque::HOW.into()));
    }
    for (label, rows) in of_gas_bearings(cases) {
        blocks.push(Block::Heading(1, phrase!("Largest bearing load, gas and masses, {}", label)));
        blocks.push(gas_bearings::table(rows).into());
        blocks.push(Block::Note(gas_bearings::HOW.into()));
    }
    blocks
}

/// The short answer: a table a load and rod ratio.
pub fn accuracy_answer(engine: &Engine, cases: &[AccuracyCase]) -> Document {
    let mut answer = Document::new("accuracy", engine.title());
    for (_, case, study) in studies(cases) {
        answer.push(Block::Paragraph(words::answer(engine, case, study)));
        answer.blocks.extend(words::sure_digits(study).map(Block::Paragraph));
        if !study.rows.is_empty() {
            answer.push(tables::methods(engine, study));
        }
    }
    answer.push(Block::Paragraph(tables::FRONT.into()));
    for (label, rows) in of_bearings(cases) {
        answer.push(Block::Paragraph(bearings::answer(engine, label, rows)));
        answer.push(bearings::table(engine, rows));
    }
    for (label, rows) in of_gas(cases) {
        answer.push(Block::Paragraph(engine_torque::answer(label, rows)));
        answer.push(engine_torque::table(rows));
    }
    for (label, rows) in of_gas_bearings(cases) {
        answer.push(Block::Paragraph(gas_bearings::answer(label, rows)));
        answer.push(gas_bearings::table(rows));
    }
    answer
}

/// The page of one engine with errors and times, and a plot a load and rod ratio; made for this machine at this hour.
pub fn accuracy_page(engine: &Engine, cases: &[AccuracyCase]) -> Document {
    let mut page = Document::new("accuracy", phrase!("{}: what accuracy costs", engine.title()));
    let of_loads = studies(cases).map(|(_, case, study)| words::answer(engine, case, study));
    let of_torque = of_gas(cases).map(|(label, rows)| engine_torque::answer(label, rows));
    let of_bearings = of_bearings(cases).map(|(label, rows)| bearings::answer(engine, label, rows));
    let with_gas = of_gas_bearings(cases).map(|(label, rows)| gas_bearings::answer(label, rows));
    page.push(Block::Answer(of_loads.chain(of_bearings).chain(of_torque).chain(with_gas).collect()));
    for (number, case, study) in studies(cases).filter(|(_, _, study)| !study.rows.is_empty()) {
        page.push(Block::Heading(1, words::heading(case, study)));
        page.push(plots::cost(number, case, study));
        page.push(tables::methods(engine, study));
        page.push(Block::Note(tables::FRONT.into()));
        page.blocks.extend(words::sure_digits(study).map(Block::Paragraph));
    }
    page.blocks.extend(further(engine, cases));
    page.push(Block::Heading(1, "How the methods work".into()));
    page.push(Block::List(words::METHODS.into_iter().chain([words::TIMES]).map(Text::from).collect()));
    page
}

/// The section of a report on the errors of the methods; no times, so that it is the same on every machine.
pub fn accuracy_section(engine: &Engine, cases: &[AccuracyCase]) -> Vec<Block> {
    let mut blocks = vec![Block::Heading(1, "What accuracy costs".into())];
    blocks.extend(tables::errors(cases));
    blocks.push(Block::List(words::METHODS.map(Text::from).into()));
    for (label, rows) in of_bearings(cases) {
        blocks.push(Block::Paragraph(bearings::answer(engine, label, rows)));
        blocks.push(bearings::table(engine, rows).into());
        blocks.push(Block::Note(bearings::HOW.into()));
    }
    for (label, rows) in of_gas(cases) {
        blocks.push(Block::Paragraph(engine_torque::answer(label, rows)));
        blocks.push(engine_torque::table(rows).into());
        blocks.push(Block::Note(engine_torque::HOW.into()));
    }
    for (label, rows) in of_gas_bearings(cases) {
        blocks.push(Block::Paragraph(gas_bearings::answer(label, rows)));
        blocks.push(gas_bearings::table(rows).into());
        blocks.push(Block::Note(gas_bearings::HOW.into()));
    }
    blocks
}
