//! What is on the page of what accuracy costs, on the terminal, and in a report?

use super::further::{Further, FurtherLoad};
use super::{AccuracyCase, AccuracyStudy, plots, tables, words};
use crate::accuracy::Study;
use crate::page::{Block, Document, Text};
use crate::report::texts::accuracy as text;

fn studies(cases: &[AccuracyCase]) -> impl Iterator<Item = (usize, &AccuracyCase, &Study)> {
    let numbered = cases.iter().enumerate();
    numbered.flat_map(|(number, case)| case.studies.iter().map(move |study| (number + 1, case, study)))
}

/// The loads of bearings and what has gas, kind by kind.
fn further(cases: &[AccuracyCase]) -> impl Iterator<Item = (Text, &Further)> {
    let of = |load| {
        cases.iter().flat_map(move |case| {
            case.further.iter().filter(move |one| one.load == load).map(|one| (case.label(), one))
        })
    };
    FurtherLoad::ALL.into_iter().flat_map(of)
}

/// The short answer: a table a load and rod ratio.
pub(super) fn answer(AccuracyStudy { engine, cases }: &AccuracyStudy) -> Document {
    let mut answer = Document::new("accuracy", engine.title());
    for (_, case, study) in studies(cases) {
        answer.push(Block::Paragraph(words::answer(engine, case, study)));
        answer.blocks.extend(words::sure_digits(study).map(Block::Paragraph));
        if !study.rows.is_empty() {
            answer.push(tables::methods(engine, study));
        }
    }
    answer.push(text::columns());
    for (label, further) in further(cases) {
        answer.push(Block::Paragraph(further.answer(label)));
        answer.push(further.table());
    }
    answer
}

/// The page of one engine with errors and times, and a plot a load and rod ratio; made for this machine at this hour.
pub(super) fn page(AccuracyStudy { engine, cases }: &AccuracyStudy) -> Document {
    let answers = studies(cases).map(|(_, case, study)| words::answer(engine, case, study));
    let further_answers = further(cases).map(|(label, further)| further.answer(label));
    let mut loads: Vec<Block> = Vec::new();
    for (number, case, study) in studies(cases).filter(|(_, _, study)| !study.rows.is_empty()) {
        loads.extend([
            Block::Heading(1, words::heading(case, study)),
            plots::cost(number, case, study).into(),
            tables::methods(engine, study).into(),
            Block::Note(text::columns()),
        ]);
        loads.extend(words::sure_digits(study).map(Block::Paragraph));
    }
    let further_loads = further(cases).flat_map(|(label, further)| {
        [Block::Heading(1, further.heading(label)), further.table().into(), Block::Note(further.how())]
    });
    text::Page {
        engine: engine.title().into(),
        answer: Block::Answer(answers.chain(further_answers).collect()).into(),
        loads: loads.into(),
        further: further_loads.collect(),
        methods: text::methods().into(),
    }
    .document()
}

/// The section of a report on the errors of the methods; no times, so that it is the same on every machine.
pub fn accuracy_section(cases: &[AccuracyCase]) -> Vec<Block> {
    let mut blocks = vec![Block::Heading(1, "What accuracy costs".into())];
    blocks.extend(tables::errors(cases));
    blocks.push(Block::List(text::methods().into()));
    for (label, further) in further(cases) {
        blocks.push(Block::Paragraph(further.answer(label)));
        blocks.push(further.table().into());
        blocks.push(Block::Note(further.how()));
    }
    blocks
}
