//! What is on the page of the best crankshafts, on the terminal, and on a page that holds several?

use super::amounts::{self, Units};
use super::{optimise_layouts, plot, tables};
use crate::engine::Engine;
use crate::optimise::{Couple, Design, Front, Residual};
use crate::page::{Block, Document, Text, Unit, number, phrase};

const METHOD: [&str; 5] = [
    "The variables are the mass × radius of each counterweight, in its plane: its size, which is the balance factor that the weight adds to its throw, and its direction, given as the skew from opposite to its throw, positive ahead of it. A larger radius gives the same mass × radius with less mass, so the largest radius is always the best.",
    OBJECTIVE,
    "For a given mass this is a convex problem (a second-order cone program): every bearing load is affine in the counterweights. Crank angles are sampled, and those at which a solution peaks higher are added until peak and samples agree. The multipliers of the solution prove, by weak duality, the least load possible at that mass: the column “above the least possible”, computed in floats.",
    "The solution is then rounded to whole steps of mass × radius, and two of the weights (one where a couple is allowed) are solved for again, exactly, so that force and couple vanish: a zero is decided on the exact sums of the layout file of the point. A weight that points along no throw is written as components along two of them.",
    "Figures that are not exact have four digits at most. They are computed from the layout files of the points, not taken from the solver.",
];

const OBJECTIVE: &str = "The mass is that of the source of the balance factors: the masses of the throws brought to their crank radii, half the reciprocating ones among them, and \
     the counterweights. The load is the largest force on any main bearing in a revolution, all orders together, on a continuous beam.";

const WITH_GAS: &str = "The mass is that of the source of the balance factors: the masses of the throws brought to their crank radii, half the reciprocating ones among them, and \
     the counterweights. The load is the largest force of gas and masses on any main bearing in a cycle, by the forces themselves and not by orders, on a continuous beam.";

const SEVERAL: &str = "The crankshafts are chosen together: their masses add up, the load is the largest on any of them, and the counterweights of each balance what turns with it at its own speed. Force and couple are the largest residual on any of them.";

/// How the crankshafts are found: by the loads of the masses, or of gas and masses.
fn method(layout: &Engine) -> Vec<Text> {
    let objective = if layout.effects().gas { WITH_GAS } else { OBJECTIVE };
    let lines = METHOD.into_iter().map(|line| if line == OBJECTIVE { objective.into() } else { line.into() });
    let several = (layout.crankshafts() > 1).then(|| SEVERAL.into());
    lines.chain(several).collect()
}

/// The ends of the front, what is better than one balance factor for all throws, and which balance is kept.
fn answer(layout: &Engine, front: &Front, couple: &Couple) -> Vec<Text> {
    let units = Units::of(layout, front);
    let mut lines = Vec::new();
    match front.points.as_slice() {
        [] => {}
        [only] => lines.push(phrase!(
            "One crankshaft keeps the balance that is asked for: its mass is {}, its largest bearing load {}.",
            amounts::kilograms(&only.design.mass),
            amounts::load(&only.design, units)
        )),
        [first, .., last] => lines.push(phrase!(
            "The lightest crankshaft that keeps the balance has a mass of {} and a largest bearing load of {}; the one with the least load has {} and {}.",
            amounts::kilograms(&first.design.mass),
            amounts::load(&first.design, units),
            amounts::kilograms(&last.design.mass),
            amounts::load(&last.design, units)
        )),
    }
    let compared = front.uniform.iter().rev().find_map(|uniform| {
        let best = uniform.best.as_ref()?;
        Some((uniform, best, amounts::less(&best.design, &uniform.design)?))
    });
    lines.extend(compared.map(|(uniform, best, less)| {
        phrase!(
            "With a balance factor of {} on all throws the crankshaft has a mass of {} and a largest bearing load of {}; with the best counterweights of the same mass it is {}, {} less.",
            number::given(&uniform.factor),
            amounts::kilograms(&uniform.design.mass),
            amounts::load(&uniform.design, units),
            amounts::load(&best.design, units),
            less
        )
    }));
    if layout.effects().gas {
        lines.push(phrase!(
            "The loads of gas and masses together are minimised: {} gives the same for each layout file.",
            Text::code("crankstar bearings")
        ));
    }
    let has_to_vanish = |design: &Design| match couple {
        Couple::Zero => vec![design.force, design.couple],
        Couple::AtMost(_) => vec![design.force],
    };
    let mut left = front.points.iter().flat_map(|point| has_to_vanish(&point.design));
    let is_exact = left.all(|left| left == Residual::Zero);
    lines.push(match couple {
        Couple::Zero | Couple::AtMost(_) if !is_exact => "With an offset of the cylinder axis order 1 is multiplied by an irrational number, which no rational mass cancels: it is rounded to twelve digits, and what that leaves of a first-order force or couple that has to vanish is proved to be below 10⁻⁹ m r ω² a cylinder, the couple at the longest arm.".into(),
        Couple::Zero => "There is no residual of the first-order force and couple that turn with the crank: 0 is exact and proved.".into(),
        Couple::AtMost(most) => phrase!(
            "There is no residual of the first-order force that turns with the crank, and of its couple at most {}: 0 is exact and proved.",
            number::given_with(most, Unit::NEWTON_METRE)
        ),
    });
    lines
}

const WEIGHTS: &str = "The balance factor that each weight adds to its throw, in percent, and its angle ahead of the direction opposite to the throw:";

const COMPARED: &str = "One balance factor for all throws, as is usual, beside the best crankshaft of the same mass and the lightest with the same load:";

/// The short answer: the front, and what uniform balance factors reach.
pub fn optimise_answer(layout: &Engine, front: &Front, couple: &Couple) -> Document {
    let mut page = Document::new("optimise", layout.title());
    page.push(tables::points(layout, front));
    page.blocks.extend(tables::compared(layout, front).map(Block::Table));
    page.blocks.extend(answer(layout, front, couple).into_iter().map(Block::Paragraph));
    page
}

fn comparison(layout: &Engine, front: &Front) -> Vec<Block> {
    let table = tables::compared(layout, front);
    table.map_or_else(Vec::new, |table| vec![Block::Paragraph(COMPARED.into()), table.into()])
}

/// The page; the layout file of each point is beside it.
pub fn optimise_page(layout: &Engine, front: &Front, couple: &Couple) -> Document {
    let mut page = Document::new("optimise", phrase!("{}: the best counterweights", layout.title()));
    page.push(Block::Answer(answer(layout, front, couple)));
    page.push(plot::picture(layout, front));
    page.blocks.extend(comparison(layout, front));
    page.section("From the lightest to the least loaded", tables::points(layout, front));
    page.section("The counterweights", WEIGHTS);
    page.push(tables::weights(layout, front));
    let files = optimise_layouts(front).into_iter().map(|file| Text::link(Text::code(file.name.clone()), file.name));
    page.push(phrase!(
        "Layout files of these crankshafts, for the commands {}, {}, {} and {}: {}.",
        Text::code("classify"),
        Text::code("loads"),
        Text::code("bearings"),
        Text::code("report"),
        Text::joined(files, ", ")
    ));
    page.section("Method", Block::List(method(layout)));
    page
}
