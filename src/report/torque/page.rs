//! What is on the page of the torque, and on the terminal?

use super::{TorqueStudy, plots, settings, tables, words};
use crate::engine::Engine;
use crate::loads::Missing;
use crate::page::{Block, Document, Fold, phrase};
use crate::report::mechanism_words;
use crate::report::texts::torque as text;
use crate::torque::{EngineTorque, Evenness, guide_moments};

/// The short answer.
pub(super) fn answer(TorqueStudy { engine, torque }: &TorqueStudy) -> Document {
    let mut answer = Document::new("torque", engine.title());
    answer.blocks.extend(words::answer(engine, torque).into_iter().map(Block::Paragraph));
    answer.push(tables::orders(torque));
    if !torque.shafts.is_empty() {
        answer.push(tables::shafts(engine, torque));
    }
    answer.blocks.extend(words::warnings(engine, torque).into_iter().map(Block::Note));
    if has_assumed(engine) {
        answer.push(Block::Note(text::some_assumed()));
    }
    answer
}

/// What the report of an engine shows of its torque, where the file asks for the gas; none where it does not.
pub(in crate::report) fn torque_section(engine: &Engine, torque: Option<&Result<EngineTorque, Missing>>) -> Vec<Block> {
    let Some(torque) = torque else { return Vec::new() };
    let heading = Block::Heading(1, "Torque of gas and inertia".into());
    match torque {
        Err(lack) => vec![heading, Block::Paragraph(phrase!("No torque: {}.", lack.to_string()))],
        Ok(torque) => {
            let mut blocks = vec![heading, Block::List(words::answer(engine, torque))];
            blocks.extend(words::warnings(engine, torque).into_iter().map(Block::Note));
            blocks.push(plots::torque(torque).into());
            blocks.extend(by_orders(engine, torque));
            blocks.push(Block::Folded(Fold {
                summary: "Gas: what is given and assumed".into(),
                blocks: vec![settings::table(engine, torque).into(), Block::List(words::assumptions(engine))],
            }));
            blocks
        }
    }
}

/// The page, with its pictures.
pub(super) fn page(TorqueStudy { engine, torque }: &TorqueStudy) -> Document {
    text::Page {
        engine: engine.title().into(),
        answer: Block::Answer(words::answer(engine, torque)).into(),
        warnings: words::warnings(engine, torque).into(),
        through_a_cycle: plots::torque(torque).into(),
        orders: by_orders(engine, torque).into(),
        shafts: (!torque.shafts.is_empty()).then(|| tables::shafts(engine, torque)).into(),
        pressure: Block::Pictures(plots::pressure(engine, torque).into()).into(),
        classes: tables::classes(engine, torque).into(),
        settings: settings::table(engine, torque).into(),
        flywheel: torque.evenness.as_ref().map_or_else(Vec::new, flywheel).into(),
        guide_moments: guides(engine, torque).into(),
        links: mechanism_words::in_torque(engine).into(),
        accuracy: tables::accuracy(torque).into(),
        assumptions: words::assumptions(engine).into(),
    }
    .document()
}

/// The orders, and what they do to the frame.
fn by_orders(engine: &Engine, torque: &EngineTorque) -> Vec<Block> {
    let star = if torque.classes.len() > 1 { text::stars_of_classes() } else { text::star() };
    vec![star.into(), tables::orders(torque).into(), words::roll(engine, torque).into()]
}

/// What the flywheel has to do.
fn flywheel(evenness: &Evenness) -> Vec<Block> {
    vec![Block::Heading(1, "Flywheel".into()), tables::flywheel(evenness).into(), text::flywheel().into()]
}

/// The guide-force moments of several cylinders.
fn guides(engine: &Engine, torque: &EngineTorque) -> Option<Block> {
    let moments = guide_moments(engine, torque).filter(|_| engine.cylinders().len() > 1)?;
    let told = std::iter::once(text::guides()).chain(mechanism_words::in_guides(engine));
    let blocks = told.map(Block::from).chain([tables::guides(&moments).into()]);
    Some(Block::folded("Guide-force moments", blocks.collect()))
}

/// Whether some value of the gas was not given.
pub(in crate::report) fn has_assumed(engine: &Engine) -> bool {
    use crate::engine::PressureLaw;
    let Some(gas) = engine.gas() else { return false };
    let of_law = |law: &PressureLaw| match law {
        PressureLaw::Table(_) => false,
        PressureLaw::Cycle(ideal) => !ideal.assumed.is_empty(),
        PressureLaw::Stage(stage) => !stage.assumed.is_empty(),
    };
    gas.chambers.iter().any(|chamber| chamber.crankcase_assumed) || gas.laws.iter().any(of_law)
}
