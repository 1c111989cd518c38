//! What is on the page of the best crankshafts, on the terminal, and on a page that holds several?

use super::amounts::{self, Units};
use super::{optimise_layouts, plot, tables};
use crate::engine::Engine;
use crate::optimise::{Couple, Design, Front, Residual};
use crate::page::{Block, Document, Text, Unit, number};
use crate::report::texts::optimise as text;

/// The ends of the front, what is better than one balance factor for all throws, and which balance is kept.
fn answer(layout: &Engine, front: &Front, couple: &Couple) -> Vec<Text> {
    let units = Units::of(layout, front);
    let mut lines = Vec::new();
    match front.points.as_slice() {
        [] => {}
        [only] => {
            lines.push(text::only_one(amounts::kilograms(&only.design.mass), amounts::load(&only.design, units)));
        }
        [first, .., last] => lines.push(text::ends(
            amounts::kilograms(&first.design.mass),
            amounts::load(&first.design, units),
            amounts::kilograms(&last.design.mass),
            amounts::load(&last.design, units),
        )),
    }
    let compared = front.uniform.iter().rev().find_map(|uniform| {
        let best = uniform.best.as_ref()?;
        Some((uniform, best, amounts::less(&best.design, &uniform.design)?))
    });
    lines.extend(compared.map(|(uniform, best, less)| {
        text::uniform_factor(
            number::given(&uniform.factor),
            amounts::kilograms(&uniform.design.mass),
            amounts::load(&uniform.design, units),
            amounts::load(&best.design, units),
            less,
        )
    }));
    if layout.effects().gas {
        lines.push(text::gas_too(Text::code("crankstar bearings")));
    }
    let has_to_vanish = |design: &Design| match couple {
        Couple::Zero => vec![design.force, design.couple],
        Couple::AtMost(_) => vec![design.force],
    };
    let mut left = front.points.iter().flat_map(|point| has_to_vanish(&point.design));
    let is_exact = left.all(|left| left == Residual::Zero);
    lines.push(match couple {
        Couple::Zero | Couple::AtMost(_) if !is_exact => text::irrational(),
        Couple::Zero => text::no_residual(),
        Couple::AtMost(most) => text::couple_left(number::given_with(most, Unit::NEWTON_METRE)),
    });
    lines
}

/// The short answer: the front, and what uniform balance factors reach.
pub fn optimise_answer(layout: &Engine, front: &Front, couple: &Couple) -> Document {
    let mut page = Document::new("optimise", layout.title());
    page.push(tables::points(layout, front));
    page.blocks.extend(tables::compared(layout, front).map(Block::Table));
    page.blocks.extend(answer(layout, front, couple).into_iter().map(Block::Paragraph));
    page
}

/// The page; the layout file of each point is beside it.
pub fn optimise_page(layout: &Engine, front: &Front, couple: &Couple) -> Document {
    let compared = tables::compared(layout, front).map(|table| vec![Block::from(text::compared()), table.into()]);
    let files = optimise_layouts(front).into_iter().map(|file| Text::link(Text::code(file.name.clone()), file.name));
    let objective = if layout.effects().gas { text::gas_objective() } else { text::inertia_objective() };
    text::Page {
        engine: layout.title().into(),
        answer: Block::Answer(answer(layout, front, couple)).into(),
        front: plot::picture(layout, front).into(),
        uniform_factors: compared.unwrap_or_default().into(),
        points: tables::points(layout, front).into(),
        weights: tables::weights(layout, front).into(),
        classify: Text::code("classify"),
        loads: Text::code("loads"),
        bearings: Text::code("bearings"),
        report: Text::code("report"),
        files: Text::joined(files, ", "),
        objective: [objective].into(),
        several: (layout.crankshafts() > 1).then(text::several_crankshafts).into(),
    }
    .document()
}
