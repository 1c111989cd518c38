//! What stands on the page of what accuracy costs, on the terminal, and in a report?

use super::{AccuracyCase, bearings, engine_torque, gas_bearings, plots, tables, words};
use crate::accuracy::Study;
use crate::engine::Engine;
use crate::page::{Block, Document, Table, Text, phrase};

fn studies(cases: &[AccuracyCase]) -> impl Iterator<Item = (usize, &AccuracyCase, &Study)> {
    let numbered = cases.iter().enumerate();
    numbered.flat_map(|(number, case)| case.studies.iter().map(move |study| (number + 1, case, study)))
}

/// What is compared beside the loads, of a case that has it.
struct Further {
    heading: Text,
    answer: Text,
    table: Table,
    how: &'static str,
}

/// The bearing loads of each case that has main bearings, the torque of each that has gas, the bearing loads of each that has both.
fn further(engine: &Engine, cases: &[AccuracyCase]) -> Vec<Further> {
    let of_bearings = |case: &AccuracyCase| {
        let rows = case.bearings.as_deref()?;
        Some(Further {
            heading: phrase!("Largest bearing load of inertia, {}", case.label()),
            answer: bearings::answer(engine, case.label(), rows),
            table: bearings::table(engine, rows),
            how: bearings::HOW,
        })
    };
    let of_gas = |case: &AccuracyCase| {
        let rows = case.engine_torque.as_deref()?;
        Some(Further {
            heading: phrase!("Largest torque, gas and inertia, {}", case.label()),
            answer: engine_torque::answer(case.label(), rows),
            table: engine_torque::table(rows),
            how: engine_torque::HOW,
        })
    };
    let of_gas_bearings = |case: &AccuracyCase| {
        let rows = case.gas_bearings.as_deref()?;
        Some(Further {
            heading: phrase!("Largest bearing load, gas and masses, {}", case.label()),
            answer: gas_bearings::answer(case.label(), rows),
            table: gas_bearings::table(rows),
            how: gas_bearings::HOW,
        })
    };
    let kinds: [&dyn Fn(&AccuracyCase) -> Option<Further>; 3] = [&of_bearings, &of_gas, &of_gas_bearings];
    kinds.into_iter().flat_map(|kind| cases.iter().filter_map(kind)).collect()
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
    for Further { answer: words, table, .. } in further(engine, cases) {
        answer.push(Block::Paragraph(words));
        answer.push(table);
    }
    answer
}

/// The page of one engine with errors and times, and a plot a load and rod ratio; made for this machine at this hour.
pub fn accuracy_page(engine: &Engine, cases: &[AccuracyCase]) -> Document {
    let mut page = Document::new("accuracy", phrase!("{}: what accuracy costs", engine.title()));
    let of_loads = studies(cases).map(|(_, case, study)| words::answer(engine, case, study));
    let further = further(engine, cases);
    let beside = further.iter().map(|further| further.answer.clone());
    page.push(Block::Answer(of_loads.chain(beside).collect()));
    for (number, case, study) in studies(cases).filter(|(_, _, study)| !study.rows.is_empty()) {
        page.push(Block::Heading(1, words::heading(case, study)));
        page.push(plots::cost(number, case, study));
        page.push(tables::methods(engine, study));
        page.push(Block::Note(tables::FRONT.into()));
        page.blocks.extend(words::sure_digits(study).map(Block::Paragraph));
    }
    for Further { heading, table, how, .. } in further {
        page.push(Block::Heading(1, heading));
        page.push(table);
        page.push(Block::Note(how.into()));
    }
    page.push(Block::Heading(1, "How the methods work".into()));
    page.push(Block::List(words::METHODS.into_iter().chain([words::TIMES]).map(Text::from).collect()));
    page
}

/// The section of a report on the errors of the methods; no times, so that it is the same on every machine.
pub fn accuracy_section(engine: &Engine, cases: &[AccuracyCase]) -> Vec<Block> {
    let mut blocks = vec![Block::Heading(1, "What accuracy costs".into())];
    blocks.extend(tables::errors(cases));
    blocks.push(Block::List(words::METHODS.map(Text::from).into()));
    for Further { answer, table, how, .. } in further(engine, cases) {
        blocks.extend([Block::Paragraph(answer), table.into(), Block::Note(how.into())]);
    }
    blocks
}
