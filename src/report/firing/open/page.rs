//! What is on the page of firing stars with open angles, and on the terminal?

use super::super::super::family_page::{argument, left_open, only_open_angle};
use super::super::super::residual;
use super::super::page::{assumed, meaning};
use super::{OpenFiringStudy, picture, words};
use crate::engine::{Cycle, CycleOrder, FiringSpan, OpenFiring};
use crate::family::{OpenStar, SpanStar};
use crate::page::{Block, Document, Table, Text, phrase};
use crate::report::texts::open_firing as text;

/// The short answer.
pub fn open_firing_answer(study: &OpenFiringStudy<'_>) -> Document {
    let mut page = Document::new("firing", study.family.title());
    page.push(orders(study));
    page.push(Block::Note(text::legend()));
    page.blocks.extend(firing(study).into_iter().map(Block::Paragraph));
    page
}

/// The page.
pub fn open_firing_page(study: &OpenFiringStudy<'_>) -> Document {
    let is_of_a_mode = study.weights.is_mode_shape();
    let page = text::Page {
        family: study.family.title().into(),
        answer: Block::Answer(answer(study)).into(),
        orders: orders(study).into(),
        legend: [text::legend()].into(),
        lengths: picture::lengths(study).into(),
        meaning: meaning(is_of_a_mode).into_iter().collect(),
        firings: firings(study).into(),
        proofs: Block::List(study.orders.iter().flat_map(|star| argued(study, star)).collect()).into(),
        assumptions: assumed(is_of_a_mode).into(),
    };
    Document { name: "firing", ..page.document() }
}

/// What is open, and which orders vanish where.
fn answer(study: &OpenFiringStudy<'_>) -> Vec<Text> {
    let mut lines = vec![left_open(study.family)];
    let named = |is_meant: &dyn Fn(&OpenStar) -> bool| -> Vec<CycleOrder> {
        study.orders.iter().filter(|star| is_meant(star)).map(|star| star.order).collect()
    };
    let no_value = |star: &OpenStar| words::values(study, star).is_some_and(|values| values.is_empty());
    let (always, never) = (named(&OpenStar::always), named(&|star| star.never() || no_value(star)));
    if !always.is_empty() {
        let orders = residual::orders_in_words(&always);
        lines.push(text::vanish_always(orders));
    }
    if !never.is_empty() {
        let orders = residual::orders_in_words(&never);
        lines.push(text::vanish_never(orders));
    }
    for star in study.orders.iter().filter(|star| !star.always() && !star.never()) {
        let values = words::values(study, star).filter(|values| !values.is_empty());
        if let Some((values, unknown)) = values.zip(only_open_angle(study.family)) {
            let values = format!("{} = {}", words::symbol(unknown), words::list(&values));
            lines.push(text::vanish_at(star.order.to_string(), values));
        }
    }
    lines.extend(firing(study));
    lines
}

/// When the cylinders can fire, and what half orders need.
fn firing(study: &OpenFiringStudy<'_>) -> Vec<Text> {
    let lacking = study.lacks_half_orders().then(text::half_orders);
    words::can_fire(study).into_iter().chain(lacking).collect()
}

/// Orders, and when the star of each vanishes.
fn orders(study: &OpenFiringStudy<'_>) -> Table {
    let mut table = Table::new(["Order κ", "Firing star", "Length"]);
    for star in &study.orders {
        table.push(vec![star.order.to_string().into(), words::summary(study, star), words::length(study, star)]);
    }
    table
}

/// When each cylinder fires; its top dead centre where the layout does not say it.
fn firings(study: &OpenFiringStudy<'_>) -> Table {
    let family = study.family;
    let (none, turn) = (num_traits::Zero::zero(), num_traits::One::one());
    let spans = family.firing_spans([&none, &turn], false).unwrap_or_default();
    let two_stroke = family.cycle() == Some(Cycle::TwoStroke) && family.open_firing().is_none();
    let centres = || FiringSpan { within: None, angles: family.dead_centres() };
    let (spans, heading) = match (spans.is_empty(), two_stroke) {
        (true, false) => (vec![centres()], "Top dead centre"),
        (true, true) => (vec![centres()], "Fires at"),
        (false, _) => (spans, "Fires at"),
    };
    let of_span = |span: &FiringSpan| match (words::label(study, span), heading) {
        (Some(label), _) => phrase!("Fires at, where {}", label),
        (None, heading) => heading.into(),
    };
    let mut table = Table::new([Text::from("Cylinder")].into_iter().chain(spans.iter().map(of_span)));
    for (place, cylinder) in family.cylinders().iter().enumerate() {
        let angles = spans.iter().map(|span| Text::label(words::crank_angle(&span.angles[place])));
        table.push([Text::label(cylinder.name.clone())].into_iter().chain(angles).collect());
    }
    table
}

/// A star with its argument, a line for each range in which the cylinders fire at the same revolutions.
fn argued(study: &OpenFiringStudy<'_>, star: &OpenStar) -> Vec<Text> {
    let name = || star.order.to_string();
    let line = |part: &SpanStar| {
        let (value, argument) = (words::of_span(study, part), argument(&part.sum));
        let is_of_an_order = matches!(study.family.open_firing(), Some(OpenFiring::Order(_)));
        match words::label(study, &part.span).filter(|_| is_of_an_order) {
            Some(label) => phrase!("**Order {}, where {}:** {}. {}", name(), label, value, argument),
            None => phrase!("**Order {}:** {}. {}", name(), value, argument),
        }
    };
    match &star.spans {
        Ok(spans) if !spans.is_empty() => spans.iter().map(line).collect(),
        Ok(_) | Err(_) => vec![phrase!("**Order {}:** {}.", name(), words::summary(study, star))],
    }
}
