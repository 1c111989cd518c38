//! How are the inertia torque, where the file asks for it, and the roll moment of geared crankshafts proved?

use super::super::calculation::Numbers;
use super::super::star::{legend_of_one_scale, torque_figure};
use super::super::{argument, residual};
use super::geared;
use super::orders::{certified, value};
use crate::engine::{Engine, WHY_NOT};
use crate::page::{Block, Fold, Picture, Table, Text};
use crate::report::texts::{engine as text, residual as of_residual};
use crate::verdict::{self, JudgedStar, Judgement, OrderVerdict, TorquePart};

const ROLL: &str = "R_k = \\sum_j \\left( c_k\\, m_j r_j\\, a_j - s_j\\, t_k\\, m_j r_j^2 \\right) e^{ik(\\beta_j - \\alpha_j)}, \\qquad a_j = \\sum d \\sin(\\alpha_j - \\eta) - s_j\\, e_j";
const TORQUE: &str = "Q_k = \\sum_j m_j\\, r_j^2\\, e^{ik(\\beta_j - \\alpha_j)}";

/// The verdicts: at the orders that it has numbers of, else at the first and those of force and moment; one per mechanism where
/// they differ.
fn verdicts(engine: &Engine, judged: &Judgement, numbers: Option<&Numbers>) -> Vec<TorquePart> {
    if !engine.effects().torque && engine.geared_cranks().is_empty() {
        return Vec::new();
    }
    let orders: Vec<u32> = match numbers.and_then(|numbers| numbers.loads.torque.as_ref()) {
        Some(torque) => torque.orders.iter().map(|order| order.order).collect(),
        None => verdict::torque_orders(&judged.orders.iter().map(|order| order.order).collect::<Vec<_>>()),
    };
    let judged = verdict::torque(engine, &orders);
    let judged = judged.unwrap_or_else(|number| unreachable!("these orders were examined: {number}"));
    judged.into_iter().flat_map(|torque| torque.parts).collect()
}

/// The section; none where the torque is not asked for.
pub(super) fn section(engine: &Engine, judged: &Judgement, numbers: Option<&Numbers>) -> Vec<Block> {
    let parts = verdicts(engine, judged, numbers);
    if parts.is_empty() {
        return Vec::new();
    }
    let verdicts: Vec<_> = parts.iter().filter(|part| part.exists).map(|part| &part.verdict).collect();
    let judged: Vec<JudgedStar> = verdicts.iter().map(|verdict| JudgedStar::from(*verdict)).collect();
    let stars = Picture::new(
        "torque-stars",
        text::torque_stars(legend_of_one_scale(engine, &judged)),
        torque_figure(engine, &verdicts),
    );
    let mut blocks = vec![
        Block::Heading(1, "Inertia torque".into()),
        text::torque_amplitude().into(),
        Block::Formula(TORQUE.to_owned(), None),
    ];
    blocks.extend(engine.faster_crank().map(|_| Block::Paragraph(text::torque_of_faster_crank())));
    blocks.push(stars.into());
    blocks.extend(proofs(parts.iter(), |part| argued(engine, part), "Inertia torque: the certificates"));
    blocks
}

/// Why each sum is zero or not, and folded below that the certificates.
fn proofs<'a>(
    parts: impl Iterator<Item = &'a TorquePart> + Clone,
    argued: impl Fn(&TorquePart) -> Text,
    certificates: &'static str,
) -> [Block; 2] {
    let certified = parts.clone().map(|part| certified(&part.verdict)).collect();
    let folded = Fold { summary: certificates.into(), blocks: vec![Block::List(certified)] };
    [Block::List(parts.map(argued).collect()), Block::Folded(folded)]
}

/// The orders of force and moment, and the first of the torque: some exist of it alone.
fn about_the_axis(engine: &Engine, judged: &Judgement) -> Vec<OrderVerdict> {
    let orders = verdict::torque_orders(&judged.orders.iter().map(|order| order.order).collect::<Vec<_>>());
    let judged = verdict::classify(engine, &orders, judged.masses, &verdict::quantities(engine, true));
    judged.unwrap_or_else(|number| unreachable!("these orders were examined: {number}"))
}

/// Torque and roll moment of crankshafts that are geared together, order by order; nothing where there is one.
pub(super) fn results(engine: &Engine, judged: &Judgement) -> Vec<Block> {
    if engine.geared_cranks().is_empty() {
        return Vec::new();
    }
    let orders = about_the_axis(engine, judged);
    let has_roll = orders.iter().any(|order| order.roll.is_some());
    let torques = orders.iter().filter_map(|order| Some((order, order.torque.as_ref()?)));
    let table = Table::of(torques)
        .column("Order", |(order, _)| order.order)
        .column("Torque", |(_, torque)| residual::torque(torque))
        .column_if(has_roll, "Roll", |(order, _)| order.roll.as_ref().map(residual::roll).unwrap_or_default())
        .done_if_any();
    let Some(table) = table else { return Vec::new() };
    let asked = geared::roll_asked_of(engine).map(Block::Paragraph);
    [table.into(), Block::Note(of_residual::torque_and_roll())].into_iter().chain(asked).collect()
}

/// The proofs of the roll moment; none where there is one crankshaft.
pub(super) fn roll_section(engine: &Engine, judged: &Judgement) -> Vec<Block> {
    let orders = about_the_axis(engine, judged);
    let parts: Vec<&TorquePart> =
        orders.iter().filter_map(|order| order.roll.as_ref()).flat_map(|roll| &roll.parts).collect();
    if parts.is_empty() {
        return Vec::new();
    }
    let mut blocks = vec![
        Block::Heading(1, "Roll moment".into()),
        text::roll_amplitude().into(),
        Block::Formula(ROLL.to_owned(), None),
        text::roll_arms().into(),
    ];
    blocks.extend(engine.faster_crank().map(|_| Block::Paragraph(text::roll_of_faster_crank())));
    let argued = |part: &TorquePart| roll_argued(engine, part);
    blocks.extend(proofs(parts.into_iter(), argued, "Roll moment: the certificates"));
    blocks
}

fn roll_argued(engine: &Engine, part: &TorquePart) -> Text {
    let verdict = &part.verdict;
    let argument = argument::argument(engine, verdict);
    match (residual::is_of_torques(part), part.exists) {
        (_, false) => text::roll_by_arms_missing(verdict.order, WHY_NOT),
        (true, true) => text::roll_by_torques(verdict.order, value(verdict), argument),
        (false, true) => text::roll_by_arms(verdict.order, value(verdict), argument),
    }
}

fn argued(engine: &Engine, part: &TorquePart) -> Text {
    let verdict = &part.verdict;
    let argument = || argument::argument(engine, verdict);
    let sources = part.class.as_ref().map(residual::class_sources);
    match (sources, part.exists) {
        (None, false) => text::torque_missing(verdict.order, WHY_NOT),
        (Some(class), false) => text::torque_missing_of_class(verdict.order, class, WHY_NOT),
        (None, true) => text::torque_of_order(verdict.order, value(verdict), argument()),
        (Some(class), true) => text::torque_of_class(verdict.order, class, value(verdict), argument()),
    }
}
