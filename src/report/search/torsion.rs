//! How is it told which firing orders of a star twist the shaft least? A table a star, the best order first.

use crate::page::number::Amount;
use crate::page::{Block, Number, Table, Text, phrase};
use crate::report::{residual, typeset};
use crate::search::{Front, MOST_TORSION_STARS, RankedOrder, StarTorsion, Torsion};

/// More firing orders of a star than this are not listed.
const MOST_LISTED: usize = 12;

const HOW: &str = "Each number is the length of the sum of phase vectors, the firing star weighed by the deflections. Listed are the firing orders to which no \
                   other is as good in every minor order and better in one, compared exactly; first that whose strongest minor order is weakest.";
const ONE_EACH: &str = "Only the star that is named is evaluated, not those that equal it in their moments.";

/// The firing orders of the first stars of a front.
pub fn search_torsion(front: &Front, torsion: &Torsion) -> Vec<Block> {
    let mut blocks = vec![Block::Heading(1, "Firing orders by torsional vibration".into())];
    let shape: Vec<Text> = torsion.shape.iter().map(|deflection| Number::exact(deflection).into()).collect();
    blocks.push(Block::Paragraph(phrase!(
        "The deflections of the throws in the mode, from the free end: {}. The sums repeat after order {}, at which all deflections add up for any firing order.",
        Text::joined(shape, ", "),
        torsion.repeats_after.to_string()
    )));
    for (index, star) in torsion.stars.iter().enumerate() {
        blocks.extend(of_star(index + 1, star, torsion));
    }
    blocks.push(Block::List([HOW, ONE_EACH].map(Text::from).into()));
    let left_out = front.stars.len().saturating_sub(MOST_TORSION_STARS);
    let ends = (left_out > 0).then(|| {
        phrase!(
            "The firing orders of the first {} stars are evaluated; {} more are omitted.",
            MOST_TORSION_STARS,
            left_out
        )
    });
    blocks.extend(ends.map(Block::Note));
    blocks
}

fn of_star(number: usize, star: &StarTorsion, torsion: &Torsion) -> Vec<Block> {
    let Some(first) = star.best.first() else {
        return vec![Block::Paragraph(phrase!(
            "Star {} does not fire evenly, and its firing orders are not evaluated.",
            number
        ))];
    };
    let strongest = first.strongest.first().map(|&place| residual::modulus_of(&first.sums[place]));
    let said = match (strongest, star.all) {
        (None, _) => phrase!("**Star {}** has no minor order.", number),
        (Some(length), 1) => phrase!(
            "**Star {}** has one firing order, {}: its strongest minor order is {}, with a sum of {}.",
            number,
            first.name(),
            names(first, torsion),
            length
        ),
        (Some(length), all) => phrase!(
            "**Star {}** has {} firing orders. {} keeps the strongest minor order smallest: {}, with a sum of {}.",
            number,
            all,
            first.name(),
            names(first, torsion),
            length
        ),
    };
    let mut blocks = vec![Block::Paragraph(said), table(star, torsion).into()];
    if star.best.len() > MOST_LISTED {
        blocks.push(Block::Note(phrase!(
            "{} more firing orders are not dominated either.",
            star.best.len() - MOST_LISTED
        )));
    }
    blocks
}

/// The orders at which the sum is longest, up to the middle of a period.
fn names(ranked: &RankedOrder, torsion: &Torsion) -> String {
    typeset::listed(ranked.strongest.iter().map(|&place| torsion.orders[place]))
}

/// Firing orders × minor orders.
fn table(star: &StarTorsion, torsion: &Torsion) -> Table {
    let heading = |order: &crate::engine::CycleOrder| {
        let mirrored = torsion.repeats_after.halves() - order.halves();
        let mirrored = crate::engine::CycleOrder::of_halves(mirrored).filter(|mirrored| mirrored != order);
        match mirrored {
            Some(mirrored) => phrase!("Orders {}", format!("{order}, {mirrored}")),
            None => phrase!("Order {}", order.to_string()),
        }
    };
    let with_equal = star.best.iter().any(|ranked| ranked.equal > 1);
    let orders = torsion.orders.iter().map(heading);
    let header = [Text::from("Firing order")].into_iter().chain(orders);
    let mut table = Table::new(header.chain(with_equal.then(|| "Equal orders".into())));
    for ranked in star.best.iter().take(MOST_LISTED) {
        let sums = ranked.sums.iter().map(|sum| Amount::of(sum).into());
        let cells = [Text::label(ranked.name())].into_iter().chain(sums);
        table.push(cells.chain(with_equal.then(|| ranked.equal.into())).collect());
    }
    table
}
