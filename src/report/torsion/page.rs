//! What is on the page of a shaft that twists, and on the terminal?

use super::study::TorsionStudy;
use super::{amounts, damped_tables as damped, gears, plots, tables, words};
use crate::engine::Engine;
use crate::page::{Block, Document, Number, Picture, Table, Text, phrase};

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
    answer_page.push(critical);
    if shown < orders {
        let command = Text::code("crankstar torsion --output");
        answer_page.push(Block::Note(match study.highest_speed() {
            None => phrase!(
                "{} orders of {} are shown, those with the longest stars in the first mode: {} writes all of them.",
                shown,
                orders,
                command
            ),
            Some(speed) => phrase!(
                "{} orders of {} are shown: of those that meet the first mode at no more than {} rpm the ones with the longest stars. {} writes all of them.",
                shown,
                orders,
                Number::Decimal(speed),
                command
            ),
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
            blocks.push(Block::folded("Torsional vibration: the shaft, and what is assumed", shaft));
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
        let speed = || amounts::rpm(vibration.speed);
        section(
            phrase!("Shafts at {}, all orders together, and the largest in the range:", speed()),
            damped::shafts(study, vibration),
        );
        if !study.train.gears.is_empty() {
            section(
                phrase!("Teeth of gears at {}, all orders together, and the largest in the range:", speed()),
                gears::gears(study),
            );
            section(
                phrase!("Teeth of gears at {}, order by order, at the first disc of each, zero to peak:", speed()),
                gears::orders(study, vibration),
            );
        }
        section(phrase!("Discs at {}, all orders together:", speed()), damped::twists(study, vibration));
        section(phrase!("Heat at {}:", speed()), damped::heat(study, vibration));
    }
    section("Resonances in the range, each order by itself:".into(), damped::resonances(study));
    section("Dampers:".into(), damped::dampers(study));
    blocks
}

fn pictures(study: &TorsionStudy) -> Vec<Picture> {
    plots::campbell(study).into_iter().chain([plots::modes(study)]).chain(plots::over_range(study)).collect()
}

/// The page, with modes and a Campbell diagram.
pub(super) fn page(study: &TorsionStudy) -> Document {
    let mut page = Document::new("torsion", phrase!("{}: torsional vibration", study.engine.title()));
    page.push(Block::Answer(words::answer(study)));
    page.push(Block::Pictures(pictures(study)));
    page.section("Natural frequencies", tables::modes(study, usize::MAX));
    if study.torsion().is_damped() || !study.is_row() {
        page.push("Nodes of the first modes:");
        page.push(damped::nodes(study));
    }
    page.section(
        "Critical speeds",
        "Critical speeds of each order in the first modes, and its star as a part of the longest possible in the mode:",
    );
    page.push(tables::critical(study));
    page.blocks.extend(forced_twist(study));
    page.section("The shaft", tables::discs(study));
    page.push(Block::Heading(1, "Method".into()));
    page.blocks.extend(words::found(study).into_iter().map(Block::Paragraph));
    page.section("Assumptions", Block::List(words::assumed(study)));
    page
}
