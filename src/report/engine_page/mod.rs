//! What is on the report of an engine? The answer, the engine, what is left, what cures it; then the proofs; then what they rest on.

mod answer;
mod articulated;
mod at_speed;
mod conventions;
mod corrected;
mod cures;
mod engine;
mod geared;
mod left;
mod orders;
mod torque;
mod weighing;

pub use answer::{engine_answer, engine_answer_weighed};
pub(super) use conventions::{FIRES, reference_plane};
pub(super) use cures::is_usually_cured;
pub use cures::worth_curing;
pub(super) use orders::symbol;
pub use weighing::Weighing;
pub(super) use weighing::{Rest, Weighed, WeighedParts, assumed_ratio, circumstances};

use super::accuracy::{AccuracyCase, accuracy_section};
use super::calculation::{self, Numbers};
use super::firing::firing_section;
use super::remedy::remedy_section;
use super::torque::torque_section;
use super::torsion::torsion_section;
use super::{family_page, firmness, mechanism_words, moving, table, theorem};
use crate::engine::{Engine, Family};
use crate::family::OpenOrder;
use crate::loads::{Missing, Needed};
use crate::order::Masses;
use crate::page::{Block, Document, Fold, Table, Text, phrase};
use crate::remedy::{self, Remedy, RemedyError, Request};
use crate::verdict::Judgement;
use answer::theorem_of;

/// What a report shows of an engine.
#[derive(Clone, Copy)]
pub struct Contents<'a> {
    /// The engine.
    pub engine: &'a Engine,
    /// The verdicts on it.
    pub judged: &'a Judgement,
    /// The family that it is a member of, judged, where the file gives values to symbols.
    pub family: Option<(&'a Family, &'a [OpenOrder])>,
    /// The choice of the orders, where it was made by an accuracy.
    pub needed: Option<&'a Needed>,
    /// Whether the engine is shown in motion, where a page can.
    pub in_motion: bool,
    /// The errors of the methods for the peak loads, where they are asked for.
    pub accuracy: Option<&'a AccuracyCase>,
    /// What is reported one by one, and what together.
    pub weighing: &'a Weighing,
}

impl Contents<'_> {
    /// The remedy for orders 1 and 2, where the file asks for it.
    fn remedy(&self) -> Option<Result<Remedy, RemedyError>> {
        let orders = [1, 2].into_iter().filter(|order| self.judged.orders.iter().any(|judged| judged.order == *order));
        let request = Request { orders: orders.collect(), ..Request::default() };
        self.engine.effects().remedy.then(|| remedy::remedy(self.engine, &request))
    }

    /// The numbers of the engine, where its file gives any.
    fn numbers(&self) -> Option<Result<Numbers, Missing>> {
        let orders: Vec<u32> = self.judged.orders.iter().map(|order| order.order).collect();
        calculation::numbers_of(self.engine, &orders, self.needed)
    }
}

/// The engine with its first star, and the short answer: what a notebook shows of it.
pub fn engine_at_a_glance(engine: &Engine, judged: &Judgement) -> Document {
    let weighed = WeighedParts::new(engine, judged, Weighing::usual());
    let pictures = Block::Pictures(engine::first_pictures(engine, &orders::stars(judged, &weighed)));
    let answer = engine_answer(engine, judged);
    Document {
        blocks: [pictures].into_iter().chain(answer.blocks).collect(),
        ..Document::new("glance", engine.title())
    }
}

/// The report of an engine.
pub fn engine_page(subject: Contents) -> Document {
    let Contents { engine, judged, family, needed, in_motion, accuracy, weighing } = subject;
    let numbers = subject.numbers();
    let known = numbers.as_ref().and_then(|numbers| numbers.as_ref().ok());
    let theorem = theorem_of(engine, judged);
    let weighed = WeighedParts::new(engine, judged, weighing);
    let stars = orders::stars(judged, &weighed);
    let mut page = Document { has_contents: true, ..Document::new("report", engine.title()) };
    page.blocks.extend(title_block(engine));
    page.push(Block::Answer(answer::lines(engine, judged, theorem.as_ref().ok(), &weighed)));
    page.push(Block::Pictures(engine::first_pictures(engine, &stars)));
    if in_motion {
        page.blocks.extend(moving::live(&[moving::scene(engine, judged, family, weighing)]));
    }
    page.blocks.extend(results(engine, judged, &weighed));
    page.blocks.extend(engine::section(engine));
    page.blocks.extend(articulated::section(engine, judged));
    match &numbers {
        None => {}
        Some(Err(missing)) => page.blocks.extend(lacking("Numbers", phrase!("No numbers: {}.", missing.to_string()))),
        Some(Ok(numbers)) => page.blocks.extend(calculation::outcome(engine, numbers, needed)),
    }
    match subject.remedy() {
        None => {}
        Some(Ok(remedy)) => page.blocks.extend(remedy_section(&remedy)),
        Some(Err(refused)) => page.blocks.extend(lacking("Remedies", phrase!("No remedy: {}.", refused.to_string()))),
    }
    page.blocks.extend(torque_section(engine));
    page.blocks.extend(firing_section(engine));
    page.blocks.extend(torsion_section(engine));
    page.blocks.extend(accuracy.into_iter().flat_map(|case| accuracy_section(std::slice::from_ref(case))));
    page.blocks.extend(family.into_iter().flat_map(|(family, orders)| family_page::section(family, orders)));
    page.blocks.extend(theorem::section(engine, &judged.orders, &theorem));
    if engine.mechanisms().len() < 2 && engine.faster_crank().is_none() {
        page.blocks.extend(firmness::section(engine, judged.pistons.as_ref().unwrap_or(&judged.orders)));
    }
    page.blocks.extend(orders::section(engine, &stars));
    page.blocks.extend(torque::section(engine, judged, known));
    page.blocks.extend(torque::roll_section(engine, judged));
    page.blocks.extend(known.into_iter().flat_map(|numbers| calculation::working(engine, numbers)));
    page.blocks.extend(conventions::section(engine));
    page.push(Block::Heading(1, "Layout file".into()));
    page.push(Block::Verbatim("toml", engine.file().clone()));
    page
}

/// What stands in the place of a section that the layout asks for in vain.
fn lacking(heading: &'static str, why: Text) -> [Block; 2] {
    [Block::Heading(1, heading.into()), Block::Paragraph(why)]
}

/// The box that a report opens with, by itself.
pub fn engine_summary(engine: &Engine, judged: &Judgement) -> Block {
    let theorem = theorem_of(engine, judged);
    let weighed = WeighedParts::new(engine, judged, Weighing::usual());
    Block::Answer(answer::lines(engine, judged, theorem.as_ref().ok(), &weighed))
}

/// The proofs of a report by themselves, order by order, under no heading of their own.
pub fn engine_proofs(engine: &Engine, judged: &Judgement) -> Vec<Block> {
    proofs(engine, judged).into_iter().skip(1).collect()
}

/// Each order with its star, its table and its proofs.
pub(super) fn proofs(engine: &Engine, judged: &Judgement) -> Vec<Block> {
    orders::section(engine, &orders::stars(judged, &WeighedParts::new(engine, judged, Weighing::usual())))
}

/// Number, revision, author and what else the file says of itself, with the objective.
fn title_block(engine: &Engine) -> Vec<Block> {
    let block = engine.title_block();
    let table = Table::of(&block.rows)
        .column(Text::default(), |(name, _)| *name)
        .column(Text::default(), |(_, written)| written)
        .done();
    let table = (!table.rows.is_empty()).then_some(Block::Table(table));
    let objective = block.objective.as_ref().map(|words| Block::Paragraph(phrase!("**Objective.** {}", words)));
    table.into_iter().chain(objective).collect()
}

/// What is left of each order: of the engine as it is built, and of its pistons.
fn results(engine: &Engine, judged: &Judgement, weighed: &WeighedParts) -> Vec<Block> {
    let firmness = match judged.masses {
        Masses::Reciprocating => table::Firmness::Shown,
        // Firmness is that of the pistons' zeros.
        Masses::Rotating | Masses::Counterweights | Masses::All => table::Firmness::NotShown,
    };
    let WeighedParts { as_judged, pistons: of_pistons } = weighed;
    let mut blocks = vec![Block::Heading(1, "Order by order".into())];
    blocks.extend(answer::whose(engine, judged).map(Block::Paragraph));
    blocks.extend(weighing::sizes(as_judged.as_ref()).map(Block::Paragraph));
    blocks.push(table::summary(engine, &judged.orders, as_judged.as_ref(), firmness).into());
    blocks.extend(torque::results(engine, judged));
    if let Some(pistons) = &judged.pistons {
        blocks.push(Block::Paragraph("The pistons alone:".into()));
        blocks.push(table::summary(engine, pistons, of_pistons.as_ref(), table::Firmness::Shown).into());
    }
    blocks.push(Block::Note(conventions::units(engine)));
    let sums =
        table::sums(&judged.orders).into_iter().chain(judged.pistons.iter().filter_map(|pistons| table::sums(pistons)));
    let sums: Vec<Block> = sums.map(Block::Table).collect();
    if !sums.is_empty() {
        blocks.push(Block::Paragraph(mechanism_words::why_several(engine)));
        blocks.push(Block::Folded(Fold { summary: "Exact sums behind each order".into(), blocks: sums }));
    }
    blocks
}
