//! What is on the report of a family? For which angles and lengths each order vanishes, and why.

mod boxes_words;
mod circle_words;
mod coordinate;
mod document;
mod map;
mod picture;
mod plane_words;
mod quadratic_words;
mod sizes;
mod special_angles;
mod tables;
mod unknowns;
mod words;

pub use document::open_document;
pub use picture::{amplitudes, amplitudes_caption};
pub(super) use picture::{axis_name, which_angle};
pub(super) use words::{argument, condition_of, summary};

use num_traits::Zero;

use super::convention::{differs, seen};
use super::moving;
use crate::engine::{DELTA, Engine, Family, PHI, WHY_NOT};
use crate::family::{self, OpenOrder, OpenSum, OpenVerdict, When};
use crate::order::{Masses, masses_as_built};
use crate::page::{Block, Choice, Document, Fold, Picture, Text, number, phrase};
use crate::proof::Planar;
use crate::report::texts::family as text;

pub(super) use unknowns::{only_open_angle, unknowns, written};

/// The report of a family.
///
/// `in_motion`: whether it is shown in motion, where a page can.
pub fn family_page(family: &Family, orders: &[OpenOrder], in_motion: bool) -> Document {
    let scenes = in_motion.then(|| {
        let orders: Vec<u32> = orders.iter().map(|order| order.order).collect();
        moving::live(&moving::open_scenes(family, &orders))
    });
    let page = text::Page {
        family: family.title().into(),
        summary: family_summary(family, orders).into(),
        asked: asked(family).into(),
        verdicts: tables::summary(family, orders).into(),
        legend: [text::legend(lengths(family, orders))].into(),
        amplitudes: amplitude_picture(family, orders).into(),
        maps: map::maps(family, orders).into_iter().collect(),
        in_motion: scenes.unwrap_or_default().into(),
        drawn_otherwise: differs(family.convention()).into(),
        cylinders: tables::cylinders(family).into(),
        source: family.source().map(Text::from).unwrap_or_default(),
        proofs: family_proofs(family, orders).into(),
        seen: [seen(family.convention())].into(),
        firing: [super::texts::engine::lagging_throw()].into(),
        plane: tables::place(family, family.reference_plane()),
        assumed: [super::texts::mechanism::equal_rods()].into(),
    };
    Document { name: "report", has_contents: true, ..page.document() }
}

/// Which effects that the layout asks for need values of the unknowns.
fn asked(family: &Family) -> Option<Text> {
    let effects = family.effects().asked();
    let number = Choice::one_or_more(effects.len());
    (!effects.is_empty()).then(|| text::asked(Text::joined(effects.into_iter().map(Text::code), ", "), number))
}

/// The box that the report of a family opens with, by itself.
pub fn family_summary(family: &Family, orders: &[OpenOrder]) -> Block {
    Block::Answer(answer(family, orders))
}

/// The proofs of a family, order by order, under no heading of their own.
pub fn family_proofs(family: &Family, orders: &[OpenOrder]) -> Vec<Block> {
    let of_order = |order: &OpenOrder| {
        let heading = Block::Heading(2, phrase!("Order {}", order.order));
        let folded = Fold { summary: phrase!("Order {}: sums and certificates", order.order), blocks: proofs(order) };
        [heading, tables::phases(family, order.order).into(), Block::Folded(folded)]
    };
    orders.iter().flat_map(of_order).collect()
}

/// What a report of a member says of all lengths and angles.
pub(super) fn section(member: &Engine, family: &Family, orders: &[OpenOrder]) -> Vec<Block> {
    let has_others = masses_as_built(member) != Masses::Reciprocating;
    let mut blocks = vec![Block::Heading(1, "For all lengths".into())];
    blocks.extend(has_others.then(|| text::pistons_alone().into()));
    blocks.push(Block::Paragraph(left_open(family)));
    blocks.extend([tables::summary(family, orders).into(), Block::Note(text::legend(lengths(family, orders)))]);
    blocks.extend(amplitude_picture(family, orders));
    for order in orders {
        let summary = phrase!("Order {}, all lengths", order.order);
        blocks.push(Block::folded(summary, proofs(order)));
    }
    blocks
}

/// The short answer: what shakes at most, where counterweights help, and for which angles each order vanishes.
pub fn family_answer(family: &Family, orders: &[OpenOrder]) -> Document {
    let mut page = Document::new("verdicts", family.title());
    page.blocks.extend(answer(family, orders).into_iter().map(Block::Paragraph));
    page.push(tables::summary(family, orders));
    page.push(Block::Note(text::short_legend(hang_on_lengths(orders))));
    page
}

fn even_firing(family: &Family) -> Option<Text> {
    let of_phi = || family::even_firing(family).map(|angles| words::even_firing_words(&angles));
    of_phi().or_else(|| family::even_firing_lines(family).map(|even| words::even_firing_lines_words(&even)))
}

pub(super) fn left_open(family: &Family) -> Text {
    let unknowns: Vec<&str> = family.unknowns().into_iter().collect();
    let number = Choice::one_or_more(unknowns.len());
    let unknowns = unknowns.join(", ").replace(PHI, "φ").replace("delta", "δ");
    text::free_parameters(number, unknowns)
}

/// The amplitude of each order over the one open angle, with its exact zeros.
fn amplitude_picture(family: &Family, orders: &[OpenOrder]) -> Option<Block> {
    let (figure, caption) = amplitudes(family, orders).zip(amplitudes_caption(family, orders))?;
    Some(Picture::new("amplitudes", caption, figure).into())
}

/// How large the orders are at most, over all open angles; none where they have no size, or it depends on several lengths.
fn most(family: &Family, orders: &[OpenOrder]) -> Option<Text> {
    let sizes = sizes::Sizes::new(family, orders.iter().map(|order| order.order).max()?)?;
    let mut told = Vec::new();
    for quantity in Planar::BOTH {
        let Some(unit) = picture::unit(family, Some(&sizes), quantity) else {
            let of = orders.iter().filter(|order| !order.verdicts(quantity).iter().all(OpenVerdict::always));
            let of: Vec<u32> = of.map(|order| order.order).collect();
            told.extend((!of.is_empty()).then(|| text::depends_on_lengths(super::residual::orders_in_words(&of))));
            continue;
        };
        let size =
            |(order, size): (u32, f64)| text::largest(quantity, format!("{} {unit}", number::sensible(size)), order);
        let (large, small) = sizes.told(quantity, orders);
        told.extend(large.into_iter().map(size));
        told.extend((!small.is_empty()).then(|| text::small(quantity, super::residual::orders_in_words(&small))));
    }
    let has_angle = [PHI, DELTA].iter().any(|angle| family.unknowns().contains(angle));
    let (circumstances, shakes) = (sizes.circumstances(), Text::joined(told, ", "));
    (!shakes.is_empty()).then(|| match has_angle {
        true => text::largest_residual(circumstances, shakes),
        false => text::what_shakes(circumstances, shakes),
    })
}

/// What is open, and where each order vanishes.
fn answer(family: &Family, orders: &[OpenOrder]) -> Vec<Text> {
    let turns = family.cylinders().iter().any(|cylinder| !cylinder.rotating_mass.is_zero());
    let mut lines: Vec<Text> = turns.then(text::pistons_alone).into_iter().collect();
    lines.extend(most(family, orders));
    lines.extend(special_angles::sentences(family, orders));
    let always = |verdicts: &[OpenVerdict; 2]| verdicts.iter().all(OpenVerdict::always);
    let list = |is_meant: &dyn Fn(&OpenOrder) -> bool| -> Vec<u32> {
        orders.iter().filter(|order| is_meant(order)).map(|order| order.order).collect()
    };
    let both = list(&|order| always(&order.force) && always(&order.moment));
    let forces = list(&|order| always(&order.force) && !always(&order.moment));
    if !both.is_empty() {
        lines.push(text::both_vanish(super::residual::orders_in_words(&both)));
    }
    if !forces.is_empty() {
        lines.push(text::force_vanishes(super::residual::orders_in_words(&forces)));
    }
    lines.extend(even_firing(family));
    lines.push(left_open(family));
    lines
}

/// Whether some moment may vanish for given lengths where it does not for all.
fn hang_on_lengths(orders: &[OpenOrder]) -> bool {
    orders.iter().flat_map(|order| &order.moment).any(OpenVerdict::hangs_on_lengths)
}

/// Where moments vanish: for all lengths, for all while others may for some, or no length is open.
fn lengths(family: &Family, orders: &[OpenOrder]) -> Choice {
    let is_open = family.unknowns().into_iter().any(|name| ![PHI, DELTA].contains(&name));
    match (is_open, hang_on_lengths(orders)) {
        (false, _) => Choice::of(0),
        (true, false) => Choice::of(1),
        (true, true) => Choice::of(2),
    }
}

/// For which angles a vector vanishes, a sentence each, where that is solved.
pub fn exact_angles(orders: &[OpenOrder]) -> Vec<Text> {
    let verdicts = orders.iter().flat_map(|order| order.force.iter().chain(&order.moment));
    let sentence = |verdict: &OpenVerdict| {
        let listed = verdict.bank_angles().filter(|angles| !angles.is_empty());
        if let Some(angles) = listed {
            return Some(text::vanishes_at(verdict.sense, verdict.quantity, verdict.order, words::list(&angles)));
        }
        let [OpenSum { when, .. }] = verdict.sums.as_slice() else { return None };
        let zeros = match when {
            When::Cosine(found) => words::cosine(found),
            When::Circle(circle) if circle.is_complete() => circle_words::zeros(circle)?,
            When::Circle(_) | When::Always | When::Never(_) | When::Where(_) | When::Irrational { .. } => return None,
            When::Triangle(_) | When::Classes(_) | When::Quadratic(_) => return None,
            When::Product(_) | When::Boxes(_) | When::NotSolved(_) => return None,
        };
        Some(text::vanishes_where(verdict.sense, verdict.quantity, verdict.order, zeros))
    };
    verdicts.filter(|verdict| !verdict.always()).filter_map(sentence).collect()
}

/// Each vector of an order with its argument, and the certificates.
fn proofs(order: &OpenOrder) -> Vec<Block> {
    if !order.force[0].exists {
        return vec![Block::Paragraph(WHY_NOT.into())];
    }
    let argued = order.force.iter().chain(&order.moment).map(|verdict| {
        let none = verdict.sums.is_empty().then(text::no_weight);
        let sums = verdict.sums.iter().map(words::argument).chain(none).chain(words::left_sentence(verdict));
        let sums = sums.chain(
            (verdict.sums.len() > 1 && verdict.meeting().is_some_and(|met| met.is_empty())).then(text::contradictory),
        );
        text::argument(verdict.quantity, verdict.sense, words::summary(verdict), Text::joined(sums, " "))
    });
    vec![Block::List(argued.collect())]
}
