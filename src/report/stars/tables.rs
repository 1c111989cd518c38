//! The tables of the page of stars.

use num_rational::BigRational;

use super::study::{BestStar, CYLINDERS, of_six};
use crate::page::number::{Amount, grouped};
use crate::page::{Number, Table, Text, phrase};
use crate::report::texts::stars as text;
use crate::stars::{self, Count, Fate, Pins, PrimePower};

/// Whether stars of this many throws lose these orders.
fn cell(throws: u32, orders: &[u32]) -> Text {
    match stars::fate(Pins::once(throws), orders) {
        Fate::Lost(_) => "yes".into(),
        Fate::Never(why) => phrase!("no: {}", why.prime),
        Fate::Open => "not given".into(),
    }
}

/// Every order that exists, up to a whole period.
pub(super) fn every(throws: u32) -> Vec<u32> {
    [1].into_iter().chain((2..=2 * throws).step_by(2)).collect()
}

/// Which moments can vanish, by number of cylinders.
pub(super) fn fates(counts: &[(u32, Option<Count>)]) -> Table {
    Table::of(counts)
        .column("Cylinders", |(throws, _)| *throws)
        .column("Factors", |(throws, _)| powers(*throws))
        .column("Order 1", |(throws, _)| cell(*throws, &[1]))
        .column("Orders 1, 2", |(throws, _)| cell(*throws, &[1, 2]))
        .column("Orders 1, 2, 4", |(throws, _)| cell(*throws, &[1, 2, 4]))
        .column("Every order", |(throws, _)| cell(*throws, &every(*throws)))
        .column("Stars without order 1", |(_, count)| how_many(count.as_ref()))
        .done()
}

fn how_many(count: Option<&Count>) -> Text {
    count.map_or_else(|| "not known".into(), |count| grouped(&count.stars.to_string()).into())
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

/// The best star of each number; its layout file, where there is a page with files beside it.
pub(super) fn best(best: &[BestStar], has_files: bool) -> Table {
    Table::of(best)
        .column("Cylinders", |best| best.cylinders)
        .column("Least moment of order 1", |best| Amount::of(&best.moments[0]))
        .column("Stars that have it", |best| {
            best.stars.as_ref().map_or_else(|| "not known".into(), |stars| Text::from(grouped(stars)))
        })
        .column("Least of order 2 beside it", |best| Amount::of(&best.moments[1]))
        .column("A star", |best| best.star.throws().iter().map(u32::to_string).collect::<Vec<_>>().join(", "))
        .column_if(has_files, "Layout file", |best| Text::link(Text::label(best_name(best)), best_name(best)))
        .done()
}

pub(super) fn best_name(best: &BestStar) -> String {
    format!("best-{}.toml", best.cylinders)
}

/// Four-stroke engines with an even number of cylinders: stars without a moment of any order, odd ones too.
pub(super) fn four_stroke() -> Table {
    Table::of((4..=16).step_by(2).map(|cylinders| (cylinders, Pins::inline(cylinders, true))))
        .column("Cylinders, four-stroke", |(cylinders, _)| *cylinders)
        .column("Directions", |(_, pins)| pins.directions)
        .column(text::own_mirror_images(), |(_, pins)| {
            let orders: Vec<u32> = (1..=pins.directions).collect();
            how_many(stars::count(*pins, &orders).as_ref())
        })
        .done()
}

/// What stays of a V on shared pins, at every bank angle.
pub(super) fn vees(best: &[BestStar]) -> Table {
    Table::of(best.iter().filter(|best| best.cylinders <= 8))
        .column("V on shared pins", |best| format!("V{}", 2 * best.cylinders))
        .column("Pins", |best| best.cylinders)
        .column(text::turning_couple(), |best| Amount::of(&best.moments[0]))
        .done()
}

/// Six cylinders with another gap in the middle.
pub(super) fn spaced() -> Table {
    let gaps: [(i64, i64); 5] = [(1, 1), (3, 2), (2, 1), (5, 2), (3, 1)];
    Table::of(gaps.map(|(numer, denom)| BigRational::new(numer.into(), denom.into())))
        .column("Gap in the middle, in spacings", Number::exact)
        .column("Stars of six without order 1", of_six)
        .done()
}
