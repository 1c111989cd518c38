//! What is on the page of a shaft that twists, and on the terminal?

use super::study::TorsionStudy;
use super::{amounts, damped_tables as damped, gears, plots, tables, words};
use crate::engine::Engine;
use crate::page::{Block, Document, Picture, Table, Text, phrase};
use crate::report::texts::torsion as text;

/// The short answer: what shakes, then the first modes and the strongest orders.
pub(super) fn answer(study: &TorsionStudy) -> Document {
    let mut answer_page = Document::new("torsion", study.engine.title());
    answer_page.blocks.extend(words::answer(study).into_iter().map(Block::Paragraph));
    let resonances = damped::strongest(study);
    if !resonances.rows.is_empty() {
        answer_page.push(resonances);
    }
    answer_page.push(tables::modes(study, tables::MOST_ROWS));
    let (critical, orders) = tables::strongest(study);
    let shown = critical.rows.len();
    if shown == 0 {
        // That none excites the first mode is said above.
        return answer_page;
    }
    answer_page.push(critical);
    if shown < orders {
        let command = Text::code("crankstar torsion --output");
        answer_page.push(Block::Note(match study.highest_speed() {
            None => text::shown(shown, orders, command),
            Some(speed) => text::shown_below(shown, orders, amounts::given_rpm(speed), command),
        }));
    }
    answer_page
}

/// What the report of an engine shows of its torsional vibration, where the file asks for it; none where it does not.
pub(in crate::report) fn torsion_section(engine: &Engine) -> Vec<Block> {
    if !engine.effects().torsion {
        return Vec::new();
    }
    let heading = Block::Heading(1, "Torsional vibration".into());
    match TorsionStudy::new(engine, &[]) {
        Err(why) => vec![heading, Block::Paragraph(phrase!("No critical speeds: {}.", why.to_string()))],
        Ok(study) => {
            let shaft = vec![tables::discs(&study).into(), Block::List(words::assumed(&study))];
            let mut blocks = vec![
                heading,
                Block::List(words::answer(&study)),
                Block::Pictures(pictures(&study)),
                tables::critical(&study).into(),
            ];
            blocks.extend(forced_twist(&study));
            blocks.extend(words::found(&study).into_iter().map(Block::Paragraph));
            blocks.push(Block::folded(text::shaft_and_assumptions(), shaft));
            blocks
        }
    }
}

/// How far the orders twist the shaft, where the layout has the torque.
fn forced_twist(study: &TorsionStudy) -> Vec<Block> {
    let mut blocks = Vec::new();
    let orders = study.forced();
    if let Some(speed) = study.speed.filter(|_| !orders.is_empty()) {
        blocks.push(Block::Heading(2, "Forced twist".into()));
        blocks.push(Block::Paragraph(words::forced(study, speed)));
        blocks.push(tables::forced(study, &orders).into());
    }
    let mut section = |words: Text, table: Table| {
        if !table.rows.is_empty() {
            blocks.extend([words.into(), table.into()]);
        }
    };
    if let Some(vibration) = study.at_speed() {
        let speed = || amounts::given_rpm(vibration.speed);
        let twists = !study.is_still();
        if twists {
            section(text::shafts(speed()), damped::shafts(study, vibration));
        }
        if (0..study.train.gears.len()).any(|gear| twists || vibration.mesh(gear) > 0.0) {
            section(text::gears(speed()), gears::gears(study));
            section(text::orders_of_gears(speed()), gears::orders(study, vibration));
        }
        if twists {
            section(text::discs(speed()), damped::twists(study, vibration));
        }
        section(text::heat(speed()), damped::heat(study, vibration));
    }
    section(text::resonances(), damped::resonances(study));
    section("Dampers:".into(), damped::dampers(study));
    blocks
}

fn pictures(study: &TorsionStudy) -> Vec<Picture> {
    plots::campbell(study).into_iter().chain([plots::modes(study)]).chain(plots::over_range(study)).collect()
}

/// The nodes, where they are not counted along a row alone.
fn nodes(study: &TorsionStudy) -> Vec<Block> {
    match study.torsion().is_damped() || !study.is_row() {
        true => vec![text::nodes().into(), damped::nodes(study).into()],
        false => Vec::new(),
    }
}

/// The page, with modes and a Campbell diagram.
pub(super) fn page(study: &TorsionStudy) -> Document {
    text::Page {
        engine: study.engine.title().into(),
        answer: Block::Answer(words::answer(study)).into(),
        pictures: pictures(study).into(),
        modes: tables::modes(study, usize::MAX).into(),
        nodes: nodes(study).into(),
        critical_speeds: tables::critical(study).into(),
        forced_twist: forced_twist(study).into(),
        discs: tables::discs(study).into(),
        method: words::found(study).into_iter().collect(),
        assumptions: words::assumed(study).into(),
    }
    .document()
}
