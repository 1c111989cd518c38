//! What is on the report of a family? For which angles and lengths each order vanishes, and why.

mod boxes_words;
mod circle_words;
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

use super::convention::{differs, seen};
use super::moving;
use crate::engine::{DELTA, Family, PHI};
use crate::family::{self, OpenOrder, OpenSum, OpenVerdict, When};
use crate::page::{Block, Document, Fold, Picture, Text, number, phrase};
use crate::proof::Planar;

pub(super) use unknowns::{unknowns, written};

const LEGEND: &str = "**0** vanishes for all values of the unknowns, proved; a vanishing moment vanishes for all lengths. Angles are those \
                      in (0°, 360°), complete, and exact unless marked ≈; ≡ is modulo 360°.";

/// The report of a family.
///
/// `in_motion`: whether it is shown in motion, where a page can.
pub fn family_page(family: &Family, orders: &[OpenOrder], in_motion: bool) -> Document {
    let mut page = Document { has_contents: true, ..Document::new("report", family.title()) };
    page.push(family_summary(family, orders));
    page.push(tables::summary(orders));
    page.push(Block::Note(LEGEND.into()));
    page.blocks.extend(amplitude_picture(family, orders));
    page.blocks.extend(map::maps(family, orders).into_iter().map(Block::from));
    if in_motion {
        let orders: Vec<u32> = orders.iter().map(|order| order.order).collect();
        page.blocks.extend(moving::live(&moving::open_scenes(family, &orders)));
    }
    page.push(Block::Heading(1, "The engine".into()));
    page.blocks.extend(differs(family.convention()).map(Block::Paragraph));
    page.push(tables::cylinders(family));
    let source = family.source().map(|source| phrase!("Source of the crank star: {}.", source));
    page.blocks.extend(source.map(Block::Paragraph));
    page.push(Block::Heading(1, "Proofs, order by order".into()));
    page.blocks.extend(family_proofs(family, orders));
    page.push(Block::Heading(1, "Conventions".into()));
    let plane = unknowns::open_length(family.reference_plane());
    page.push(Block::List(vec![
        seen(family.convention()),
        super::texts::engine::lagging_throw(),
        phrase!("Moments are taken about the plane z = {}.", plane),
        super::texts::mechanism::equal_rods(),
    ]));
    page
}

/// The box that the report of a family opens with, by itself.
pub fn family_summary(family: &Family, orders: &[OpenOrder]) -> Block {
    Block::Answer(answer(family, orders))
}

/// The proofs of a family, order by order, under no heading of their own.
pub fn family_proofs(family: &Family, orders: &[OpenOrder]) -> Vec<Block> {
    let of_order = |order: &OpenOrder| {
        let heading = Block::Heading(2, phrase!("Order {}", order.order));
        let folded = Fold { summary: "Why: sums and certificates".into(), blocks: proofs(order) };
        [heading, tables::phases(family, order.order).into(), Block::Folded(folded)]
    };
    orders.iter().flat_map(of_order).collect()
}

/// What a report of a member says of all lengths and angles.
pub(super) fn section(family: &Family, orders: &[OpenOrder]) -> Vec<Block> {
    let mut blocks = vec![Block::Heading(1, "For all lengths".into()), Block::Paragraph(left_open(family))];
    blocks.extend([tables::summary(orders).into(), Block::Note(LEGEND.into())]);
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
    page.push(tables::summary(orders));
    page.push(Block::Note(
        "0 vanishes for all values of the unknowns, proved; angles are complete in (0°, 360°), and exact unless marked ≈.".into(),
    ));
    page
}

fn even_firing(family: &Family) -> Option<Text> {
    let of_phi = || family::even_firing(family).map(|angles| words::even_firing_words(&angles));
    of_phi().or_else(|| family::even_firing_lines(family).map(|even| words::even_firing_lines_words(&even)))
}

pub(super) fn left_open(family: &Family) -> Text {
    let unknowns: Vec<&str> = family.unknowns().into_iter().collect();
    let unknowns = unknowns.join(", ").replace(PHI, "φ").replace("delta", "δ");
    phrase!("Free parameters: {}.", unknowns)
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
            let of = orders.iter().filter(|order| !sizes::verdicts(order, quantity).iter().all(OpenVerdict::always));
            let of: Vec<u32> = of.map(|order| order.order).collect();
            let words = "a moment of {} that depends on the lengths";
            told.extend((!of.is_empty()).then(|| phrase!(words, super::residual::orders_in_words(&of))));
            continue;
        };
        let size = |(order, size): (u32, f64)| {
            phrase!("{force|moment} {} (order {})", quantity, format!("{} {unit}", number::sensible(size)), order)
        };
        let (large, small) = sizes.told(quantity, orders);
        told.extend(large.into_iter().map(size));
        told.extend((!small.is_empty()).then(|| {
            phrase!(
                "{1:force|moment} below 1 % of the largest{1: or of one piston's|} at {2}",
                quantity,
                super::residual::orders_in_words(&small)
            )
        }));
    }
    let has_angle = [PHI, DELTA].iter().any(|angle| family.unknowns().contains(angle));
    let words = match has_angle {
        true => "**Largest residual over all angles** ({}, numerical): {}.",
        false => "**What shakes** ({}): {}.",
    };
    (!told.is_empty()).then(|| phrase!(words, sizes.circumstances(), Text::joined(told, ", ")))
}

/// What is open, and where each order vanishes.
fn answer(family: &Family, orders: &[OpenOrder]) -> Vec<Text> {
    let mut lines: Vec<Text> = most(family, orders).into_iter().collect();
    lines.extend(special_angles::sentences(family, orders));
    let always = |verdicts: &[OpenVerdict; 2]| verdicts.iter().all(OpenVerdict::always);
    let list = |is_meant: &dyn Fn(&OpenOrder) -> bool| -> Vec<u32> {
        orders.iter().filter(|order| is_meant(order)).map(|order| order.order).collect()
    };
    let both = list(&|order| always(&order.force) && always(&order.moment));
    let forces = list(&|order| always(&order.force) && !always(&order.moment));
    if !both.is_empty() {
        lines.push(phrase!(
            "Force and moment of {} vanish in the whole family.",
            super::residual::orders_in_words(&both)
        ));
    }
    if !forces.is_empty() {
        lines.push(phrase!("The force of {} vanishes in the whole family.", super::residual::orders_in_words(&forces)));
    }
    lines.extend(even_firing(family));
    lines.push(left_open(family));
    lines
}

/// For which angles a vector vanishes, a sentence each, where that is solved.
pub fn exact_angles(orders: &[OpenOrder]) -> Vec<Text> {
    let verdicts = orders.iter().flat_map(|order| order.force.iter().chain(&order.moment));
    let sentence = |verdict: &OpenVerdict| {
        let listed = verdict.bank_angles().filter(|angles| !angles.is_empty() && !verdict.always());
        if let Some(angles) = listed {
            return Some(phrase!(
                "The {direct|reverse} {force|moment} of order {} vanishes exactly at φ = {}.",
                verdict.sense,
                verdict.quantity,
                verdict.order,
                words::list(&angles)
            ));
        }
        let [OpenSum { when, .. }] = verdict.sums.as_slice() else { return None };
        let zeros = match when {
            When::Cosine(found) => words::cosine(found),
            When::Circle(circle) if circle.is_complete() => circle_words::zeros(circle)?,
            When::Circle(_) | When::Always | When::Never(_) | When::Where(_) | When::Irrational { .. } => return None,
            When::Triangle(_) | When::Classes(_) | When::Quadratic(_) => return None,
            When::Product(_) | When::Boxes(_) | When::NotSolved(_) => return None,
        };
        Some(phrase!(
            "The {direct|reverse} {force|moment} of order {} vanishes exactly where {}.",
            verdict.sense,
            verdict.quantity,
            verdict.order,
            zeros
        ))
    };
    verdicts.filter_map(sentence).collect()
}

/// Each vector of an order with its argument, and the certificates.
fn proofs(order: &OpenOrder) -> Vec<Block> {
    let argued = order.force.iter().chain(&order.moment).map(|verdict| {
        let none = verdict.sums.is_empty().then(|| "Every weight is zero.".into());
        let sums = verdict.sums.iter().map(words::argument).chain(none).chain(words::left_sentence(verdict));
        phrase!(
            "**{Force|Moment}, {direct|reverse}:** {}. {}",
            verdict.quantity,
            verdict.sense,
            words::summary(verdict),
            Text::joined(sums, " ")
        )
    });
    vec![Block::List(argued.collect())]
}
