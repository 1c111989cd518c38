//! The tables of the page of stars.

use num_rational::BigRational;

use super::study::{BestStar, CYLINDERS, of_six};
use super::words::grouped;
use crate::exact::PhasorSum;
use crate::page::{Number, Table, Text, phrase};
use crate::report::residual;
use crate::stars::{self, Count, Fate, Pins, PrimePower};

/// Whether stars of so many throws lose these orders.
fn cell(throws: u32, orders: &[u32]) -> Text {
    match stars::fate(Pins::once(throws), orders) {
        Fate::Lost(_) => "yes".into(),
        Fate::Never(why) => phrase!("no: {}", why.prime),
        Fate::Open => "not told".into(),
    }
}

/// Every order that exists, up to a whole period.
pub(super) fn every(throws: u32) -> Vec<u32> {
    [1].into_iter().chain((2..=2 * throws).step_by(2)).collect()
}

/// What each number of cylinders can lose.
pub(super) fn fates(counts: &[(u32, Option<Count>)]) -> Table {
    let mut table = Table::new([
        "Cylinders",
        "",
        "Order 1",
        "Orders 1, 2",
        "Orders 1, 2, 4",
        "Every order",
        "Stars without order 1",
    ]);
    for (throws, count) in counts {
        let throws = *throws;
        let stars =
            count.as_ref().map_or_else(|| "not known".into(), |count| Text::from(grouped(&count.stars.to_string())));
        let mut row = vec![throws.into(), powers(throws)];
        row.extend([&[1][..], &[1, 2], &[1, 2, 4], &every(throws)].map(|orders| cell(throws, orders)));
        row.push(stars);
        table.push(row);
    }
    table
}

/// `2²·3`.
fn powers(number: u32) -> Text {
    let written = |PrimePower { prime, exponent }: PrimePower| match exponent {
        1 => prime.to_string(),
        _ => format!("{prime}^{{{exponent}}}"),
    };
    let powers = stars::prime_powers(number).into_iter().map(written).collect::<Vec<_>>();
    Text::formula(powers.join(" \\cdot "))
}

/// The first number of cylinders of the page that loses these orders.
pub(super) fn first(orders: impl Fn(u32) -> Vec<u32>) -> Text {
    let is_lost = |throws: &u32| matches!(stars::fate(Pins::once(*throws), &orders(*throws)), Fate::Lost(_));
    CYLINDERS.into_iter().find(is_lost).map_or_else(|| "none".into(), Text::from)
}

/// The best star of each number.
pub(super) fn best(best: &[BestStar]) -> Table {
    let mut table =
        Table::new(["Cylinders", "Least moment of order 1", "Stars that have it", "Least of order 2 beside it"]);
    for BestStar { cylinders, moments, stars } in best {
        let stars = stars.as_ref().map_or_else(|| "not known".into(), |stars| Text::from(grouped(stars)));
        table.push(vec![(*cylinders).into(), length(&moments[0]), stars, length(&moments[1])]);
    }
    table
}

fn length(sum: &PhasorSum) -> Text {
    if sum.vanishes() { Text::zero() } else { residual::modulus_of(sum).into() }
}

/// Four-stroke engines with an even number of cylinders: stars without a moment of any order, odd ones too.
pub(super) fn four_stroke() -> Table {
    let mut table = Table::new(["Cylinders, four-stroke", "Directions", "Stars that are their own mirror image"]);
    for cylinders in (4..=16).step_by(2) {
        let pins = Pins::inline(cylinders, true);
        let orders: Vec<u32> = (1..=pins.directions).collect();
        let count = stars::count(pins, &orders);
        let stars = count.map_or_else(|| "not known".into(), |count| Text::from(grouped(&count.stars.to_string())));
        table.push(vec![cylinders.into(), pins.directions.into(), stars]);
    }
    table
}

/// What stays of a V on shared pins, at every bank angle.
pub(super) fn vees(best: &[BestStar]) -> Table {
    let mut table = Table::new(["V on shared pins", "Pins", "Least couple of order 1 that turns with the crank"]);
    for BestStar { cylinders: pins, moments, .. } in best.iter().filter(|best| best.cylinders <= 8) {
        let twice = moments[0].scaled(&BigRational::from_integer(2.into()));
        table.push(vec![format!("V{}", 2 * pins).into(), (*pins).into(), length(&twice)]);
    }
    table
}

/// Six cylinders with another gap in the middle.
pub(super) fn spaced() -> Table {
    let mut table = Table::new(["Gap in the middle, in spacings", "Stars of six without order 1"]);
    for [numer, denom] in [[1, 1], [3, 2], [2, 1], [5, 2], [3, 1]] {
        let middle = BigRational::new(numer.into(), denom.into());
        table.push(vec![Number::exact(&middle).into(), of_six(&middle).into()]);
    }
    table
}
