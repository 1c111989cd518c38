//! What is on the report of an engine? The answer, the engine, what is left, what cures it; then the proofs; then what they rest on.

mod answer;
mod articulated;
mod at_speed;
mod conventions;
mod cures;
mod engine;
mod geared;
mod left;
mod orders;
mod torque;
mod weighing;

pub use answer::{engine_answer, engine_answer_weighed};
pub(super) use conventions::reference_plane;
pub(super) use cures::is_usually_cured;
pub use cures::worth_curing;
pub(super) use orders::symbol;
pub use weighing::Weighing;
pub(super) use weighing::{Rest, Weighed, WeighedParts, assumed_ratio, circumstances};

use super::accuracy::{AccuracyCase, accuracy_section};
use super::calculation::{self, Numbers};
use super::convention::differs;
use super::firing::firing_section;
use super::remedy::remedy_section;
use super::texts::engine as text;
use super::torque::torque_section;
use super::torsion::torsion_section;
use super::{dead_centres, family_page, firmness, mechanism_words, moving, table, theorem};
use crate::engine::{Engine, Family};
use crate::family::OpenOrder;
use crate::loads::{Missing, Needed};
use crate::order::Masses;
use crate::page::{Block, Document, Fold, Table, Text};
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
    let is_alike = engine.mechanisms().len() < 2 && engine.faster_crank().is_none();
    let firmness = is_alike.then(|| firmness::section(engine, judged.pistons.as_ref().unwrap_or(&judged.orders)));
    let motion = in_motion.then(|| moving::scene(engine, judged, family, weighing));
    // Asked for in two places, and computed once.
    let gas = engine.effects().gas.then(|| crate::torque::torque(engine));
    let page = text::Page {
        engine: engine.title().into(),
        title_block: title_block(engine).into(),
        answer: Block::Answer(answer::lines(engine, judged, theorem.as_ref().ok(), &weighed)).into(),
        first_pictures: engine::first_pictures(engine, &stars).into(),
        in_motion: motion.map(|scene| moving::live(&[scene])).unwrap_or_default().into(),
        whose_masses: answer::whose(engine, judged).into(),
        sizes: weighing::sizes(weighed.as_judged.as_ref()).into(),
        summary: summary(engine, judged, &weighed).into(),
        torque_and_roll: torque::results(engine, judged).into(),
        pistons_alone: pistons_alone(engine, judged, &weighed).into(),
        units: [conventions::units(engine)].into(),
        exact_sums: exact_sums(engine, judged).into(),
        convention: differs(engine.convention()).into(),
        side_view: engine::seen_from_the_side(engine).into(),
        cylinders: table::cylinders(engine).into(),
        crankshafts: geared::crankshafts(engine).into(),
        firing: engine.firing().map(|firing| engine::fires(engine, firing)).into(),
        dead_centres: dead_centres::counted(engine).into(),
        source: engine.source().map(Text::from).unwrap_or_default(),
        articulated_rods: articulated::section(engine, judged).into(),
        numbers: match &numbers {
            None => Vec::new(),
            Some(Err(missing)) => lacking("Numbers", text::no_numbers(missing.to_string())),
            Some(Ok(numbers)) => calculation::outcome(engine, numbers, needed, matches!(gas, Some(Ok(_)))),
        }
        .into(),
        remedies: match subject.remedy() {
            None => Vec::new(),
            Some(Ok(remedy)) => remedy_section(&remedy),
            Some(Err(refused)) => lacking("Remedies", text::no_remedy(refused.to_string())),
        }
        .into(),
        torque: torque_section(engine, gas.as_ref()).into(),
        gas_and_inertia: firing_section(engine).into(),
        torsion: torsion_section(engine).into(),
        accuracy: accuracy.into_iter().flat_map(|case| accuracy_section(std::slice::from_ref(case))).collect(),
        family: family.into_iter().flat_map(|(family, orders)| family_page::section(engine, family, orders)).collect(),
        every_order: theorem::every_order(engine, &judged.orders, &theorem).into(),
        firmness: firmness.unwrap_or_default().into(),
        proofs: orders::proofs(engine, &stars).into(),
        inertia_torque: torque::section(engine, judged, known).into(),
        roll_moment: torque::roll_section(engine, judged).into(),
        working: known.into_iter().flat_map(|numbers| calculation::working(engine, numbers)).collect(),
        conventions: conventions::lines(engine).into(),
        layout_file: Block::Verbatim("toml", engine.file().clone()).into(),
    };
    Document { name: "report", has_contents: true, ..page.document() }
}

/// What stands in the place of a section that the layout asks for in vain.
fn lacking(heading: &'static str, why: Text) -> Vec<Block> {
    vec![Block::Heading(1, heading.into()), Block::Paragraph(why)]
}

/// The box that a report opens with, by itself.
pub fn engine_summary(engine: &Engine, judged: &Judgement) -> Block {
    let theorem = theorem_of(engine, judged);
    let weighed = WeighedParts::new(engine, judged, Weighing::usual());
    Block::Answer(answer::lines(engine, judged, theorem.as_ref().ok(), &weighed))
}

/// Each order with its star, its table and its proofs, under no heading of their own.
pub fn engine_proofs(engine: &Engine, judged: &Judgement) -> Vec<Block> {
    orders::proofs(engine, &orders::stars(judged, &WeighedParts::new(engine, judged, Weighing::usual())))
}

/// The same under their heading.
pub(super) fn proofs(engine: &Engine, judged: &Judgement) -> Vec<Block> {
    let heading = Block::Heading(1, "Proofs, order by order".into());
    [heading].into_iter().chain(engine_proofs(engine, judged)).collect()
}

/// Number, revision, author and what else the file says of itself, with the objective.
fn title_block(engine: &Engine) -> Vec<Block> {
    let block = engine.title_block();
    let table = Table::of(&block.rows)
        .column(Text::default(), |(name, _)| *name)
        .column(Text::default(), |(_, written)| written)
        .done_if_any();
    let objective = block.objective.as_ref().map(|words| Block::Paragraph(text::objective(words)));
    table.map(Block::Table).into_iter().chain(objective).collect()
}

/// What is left of each order.
fn summary(engine: &Engine, judged: &Judgement, weighed: &WeighedParts) -> Table {
    let firmness = match judged.masses {
        Masses::Reciprocating => table::Firmness::Shown,
        // Firmness is that of the pistons' zeros.
        Masses::Rotating | Masses::Counterweights | Masses::All => table::Firmness::NotShown,
    };
    table::summary(engine, &judged.orders, weighed.as_judged.as_ref(), firmness)
}

/// The same of the pistons alone, where the verdicts are on more.
fn pistons_alone(engine: &Engine, judged: &Judgement, weighed: &WeighedParts) -> Vec<Block> {
    let Some(pistons) = &judged.pistons else { return Vec::new() };
    let table = table::summary(engine, pistons, weighed.pistons.as_ref(), table::Firmness::Shown);
    vec![text::of_pistons().into(), table.into()]
}

/// The sums of the orders that are made of several, with why they are.
fn exact_sums(engine: &Engine, judged: &Judgement) -> Vec<Block> {
    let of_pistons = judged.pistons.iter().filter_map(|pistons| table::sums(pistons));
    let of_pistons = of_pistons.flat_map(|table| [text::of_pistons().into(), Block::Table(table)]);
    let sums: Vec<Block> = table::sums(&judged.orders).into_iter().map(Block::Table).chain(of_pistons).collect();
    if sums.is_empty() {
        return Vec::new();
    }
    let folded = Fold { summary: "Exact sums behind each order".into(), blocks: sums };
    vec![mechanism_words::why_several(engine).into(), Block::Folded(folded)]
}
