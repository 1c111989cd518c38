//! How is it told which firing orders of a star twist the shaft least? A table a star, the best order first.

use crate::page::number::Amount;
use crate::page::{Block, Number, Table, Text, phrase};
use crate::report::texts::search as text;
use crate::report::{residual, typeset};
use crate::search::{Front, MOST_TORSION_STARS, RankedOrder, StarTorsion, Torsion};

/// More firing orders of a star than this are not listed.
const MOST_LISTED: usize = 12;

/// The firing orders of the first stars of a front.
pub fn search_torsion(front: &Front, torsion: &Torsion) -> Vec<Block> {
    let mut blocks = vec![Block::Heading(1, "Firing orders by torsional vibration".into())];
    let shape: Vec<Text> = torsion.shape.iter().map(|deflection| Number::exact(deflection).into()).collect();
    blocks.push(text::deflections(Text::joined(shape, ", "), torsion.repeats_after.to_string()).into());
    for (index, star) in torsion.stars.iter().enumerate() {
        blocks.extend(of_star(index + 1, star, torsion));
    }
    blocks.push(Block::List(vec![text::phase_sums(), text::named_star_alone()]));
    let left_out = front.stars.len().saturating_sub(MOST_TORSION_STARS);
    blocks.extend((left_out > 0).then(|| Block::Note(text::stars_left_out(MOST_TORSION_STARS, left_out))));
    blocks
}

fn of_star(number: usize, star: &StarTorsion, torsion: &Torsion) -> Vec<Block> {
    let Some(first) = star.best.first() else {
        return vec![text::not_even(number).into()];
    };
    let strongest = first.strongest.first().map(|&place| residual::modulus_of(&first.sums[place]));
    let said = match (strongest, star.all) {
        (None, _) => text::no_minor_order(number),
        (Some(length), 1) => text::one_firing_order(number, first.name(), names(first, torsion), length),
        (Some(length), all) => text::weakest_minor_order(number, all, first.name(), names(first, torsion), length),
    };
    let mut blocks = vec![Block::Paragraph(said), table(star, torsion).into()];
    if star.best.len() > MOST_LISTED {
        blocks.push(Block::Note(text::more_firing_orders(star.best.len() - MOST_LISTED)));
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
