//! How is the inertia torque proved, where the file asks for it?

use super::super::calculation::Numbers;
use super::super::star::{torque_figure, torque_legend};
use super::super::{argument, residual};
use super::orders::{certified, value};
use crate::engine::Engine;
use crate::page::{Block, Fold, Picture, Text, phrase};
use crate::verdict::{self, Judgement, TorquePart};

const TORQUE: &str = "Q_k = \\sum_j m_j\\, r_j^2\\, e^{ik(\\beta_j - \\alpha_j)}";

/// The verdicts: at the orders that it has numbers of, else at the first and those of force and moment; one per mechanism where
/// they differ.
fn verdicts(engine: &Engine, judged: &Judgement, numbers: Option<&Numbers>) -> Vec<TorquePart> {
    if !engine.effects().torque {
        return Vec::new();
    }
    let orders: Vec<u32> = match numbers.and_then(|numbers| numbers.loads.torque.as_ref()) {
        Some(torque) => torque.orders.iter().map(|order| order.order).collect(),
        None => verdict::torque_orders(&judged.orders.iter().map(|order| order.order).collect::<Vec<_>>()),
    };
    let judged = verdict::torque(engine, &orders);
    let judged = judged.unwrap_or_else(|number| unreachable!("these orders were judged: {number}"));
    judged.into_iter().flat_map(|torque| torque.parts).collect()
}

/// The section; none where the torque is not asked for.
pub(super) fn section(engine: &Engine, judged: &Judgement, numbers: Option<&Numbers>) -> Vec<Block> {
    let parts = verdicts(engine, judged, numbers);
    if parts.is_empty() {
        return Vec::new();
    }
    let verdicts: Vec<_> = parts.iter().map(|part| &part.verdict).collect();
    let stars = Picture {
        name: "torque-stars".to_owned(),
        caption: phrase!("Vector stars of the inertia torque. {}", torque_legend(engine, &verdicts)),
        figure: torque_figure(engine, &verdicts),
    };
    let argued = parts.iter().map(|part| argued(engine, part)).collect();
    let certificates = verdicts.iter().map(|verdict| certified(verdict)).collect();
    vec![
        Block::Heading(1, "Inertia torque".into()),
        Block::Paragraph(
            "The inertia torque of order k has the amplitude of the star, in multiples of the layout's mass and crank radius,".into(),
        ),
        Block::Formula(TORQUE.to_owned(), None),
        stars.into(),
        Block::List(argued),
        Block::Folded(Fold {
            summary: "Inertia torque: the certificates".into(),
            blocks: vec![Block::List(certificates)],
        }),
    ]
}

fn argued(engine: &Engine, part: &TorquePart) -> Text {
    let verdict = &part.verdict;
    let argument = argument::argument(engine, verdict);
    match &part.class {
        None => phrase!("**Order {}:** {}. {}", verdict.order, value(verdict), argument),
        Some(class) => {
            let of = residual::class_sources(class);
            phrase!("**Order {} ({}):** {}. {}", verdict.order, of, value(verdict), argument)
        }
    }
}
