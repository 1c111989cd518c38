//! Which columns hold what a search found? A row a star of the front; what was looked at; the firing orders that twist the shaft least.

use crate::engine::CycleOrder;
use crate::exact::PhasorSum;
use crate::numbers;
use crate::report::data::{Filling, Name};
use crate::search::{FoundStar, Front, FrontDocument, Moment, RankedOrder, StarDocument, Torsion, document};
use crate::table::{Table, Unit};

/// The tables of a search: the stars, the question with its counts, and the firing orders where they are asked for.
pub fn tables(front: &Front, torsion: Option<&Torsion>) -> Vec<Table> {
    // Names and counts are those of the JSON document.
    let document = document(front);
    let firing_orders = torsion.map(firing_orders);
    [stars(front, &document), question(&document)].into_iter().chain(firing_orders).collect()
}

fn stars(front: &Front, document: &FrontDocument) -> Table {
    let rows = (1..).zip(&document.stars).zip(&front.stars).map(|((number, known), star)| (number, known, star));
    let mut table = Filling::new("search.stars", rows);
    table.whole("star", |(number, ..)| *number);
    table.words("firing_order", |(_, known, _)| known.firing_order.clone());
    table.exact("throws_turns", Unit::NONE, |(_, known, _)| Some(known.throws.join(" ")));
    for (place, first) in front.stars.first().iter().flat_map(|star| star.moments.iter().enumerate()) {
        moments(&mut table, place, first);
        if let Some(sizes) = &front.limits.sizes {
            let size = sizes.newton_metres(first.order);
            table.decimal(("moment_{order}_{unit}", first.order), Unit::NEWTON_METRE, |(.., star)| {
                star.moments.get(place).map(|moment| length(&moment.sum, moment.decimal).decimal * size)
            });
        }
    }
    for (place, (order, _)) in front.stars.first().iter().flat_map(|star| star.minor.iter().enumerate()) {
        let order = order.exact().to_string();
        let patterns = ["phase_sum_{order}", "phase_sum_{order}_exact", "phase_sum_{order}_vanishes"];
        lengths(&mut table, patterns.map(|pattern| (pattern, &order)), Unit::NONE, |(.., star)| {
            star.minor.get(place).map(|(_, sum)| length(sum, numbers::evaluate(sum).norm()))
        });
    }
    let count = |count: Option<u64>| count.and_then(|count| count.try_into().ok());
    table.maybe_whole("neighbours", |(_, known, _)| known.neighbours);
    table.maybe_whole("classes", |(_, known, _)| count(known.classes));
    table.maybe_whole("stars", |(_, known, _)| count(known.stars));
    table.words("layout", |(_, known, _)| Some(known.layout.clone()));
    table.done()
}

/// The moment of an order: its length, exactly, and whether it is zero.
fn moments(table: &mut Filling<(usize, &StarDocument, &FoundStar)>, place: usize, first: &Moment) {
    let order = first.order.to_string();
    let of = |(.., star): &(usize, &StarDocument, &FoundStar)| {
        star.moments.get(place).map(|moment| length(&moment.sum, moment.decimal))
    };
    match first.sense {
        None => {
            let patterns = ["moment_{order}_{unit}", "moment_{order}_exact", "moment_{order}_vanishes"];
            lengths(table, patterns.map(|pattern| (pattern, &order)), Unit::OPEN_SPACING, of);
        }
        Some(sense) => {
            let patterns =
                ["moment_{order}_{sense}_{unit}", "moment_{order}_{sense}_exact", "moment_{order}_{sense}_vanishes"];
            lengths(table, patterns.map(|pattern| (pattern, &order, sense.name())), Unit::OPEN_SPACING, of);
        }
    }
}

/// The length of a sum: 0 where that is proved.
#[derive(Clone)]
struct Length {
    decimal: f64,
    exact: Option<String>,
    vanishes: bool,
}

fn length(sum: &PhasorSum, decimal: f64) -> Length {
    match sum.vanishes() {
        true => Length { decimal: 0.0, exact: Some("0".to_owned()), vanishes: true },
        false => Length { decimal, exact: numbers::modulus(sum).map(|form| form.to_string()), vanishes: false },
    }
}

/// A length, the same exactly, and whether it is zero.
fn lengths<R>(
    table: &mut Filling<R>,
    [size, exact, vanishes]: [impl Into<Name>; 3],
    unit: Unit,
    of: impl Fn(&R) -> Option<Length>,
) {
    table.decimal(size, unit, |row| of(row).map(|length| length.decimal));
    table.exact(exact, Unit::NONE, |row| of(row).and_then(|length| length.exact));
    table.truth(vanishes, |row| of(row).map(|length| length.vanishes));
}

fn question(document: &FrontDocument) -> Table {
    let mut table = Filling::new("search.question", [document]);
    table.words("engine", |asked| Some(asked.engine.clone()));
    table.words("cycle", |asked| Some(asked.cycle.to_owned()));
    table.words("orders", |asked| Some(asked.orders.iter().map(u32::to_string).collect::<Vec<_>>().join(" ")));
    table.truth("by_neighbours", |asked| Some(asked.neighbours));
    table.exact("pin_split_turns", Unit::NONE, |asked| asked.pin_split.clone());
    table.exact("bank_offset_spacings", Unit::NONE, |asked| asked.bank_offset.clone());
    table.exact("mode_shape", Unit::NONE, |asked| Some(asked.mode_shape.join(" ")).filter(|shape| !shape.is_empty()));
    table.exact("all_stars", Unit::NONE, |asked| Some(asked.all_stars.clone()));
    table.maybe_whole("balanced_stars", |asked| asked.balanced_stars.and_then(|count| count.try_into().ok()));
    table.whole("evaluated", |asked| asked.judged as usize);
    table.whole("cut", |asked| asked.cut as usize);
    table.done()
}

/// One minor order of a firing order of a star.
struct Minor<'a> {
    star: usize,
    ranked: &'a RankedOrder,
    order: CycleOrder,
    length: Length,
}

fn firing_orders(torsion: &Torsion) -> Table {
    let rows = torsion.stars.iter().enumerate().flat_map(|(index, star)| {
        star.best.iter().flat_map(move |ranked| {
            let pairs = torsion.orders.iter().zip(&ranked.sums);
            pairs.map(move |(&order, sum)| {
                let length = length(sum, numbers::evaluate(sum).norm());
                Minor { star: index + 1, ranked, order, length }
            })
        })
    });
    let mut table = Filling::new("search.firing_orders", rows);
    table.whole("star", |row| row.star);
    table.words("firing_order", |row| Some(row.ranked.name()));
    table.exact("order", Unit::NONE, |row| Some(row.order.exact().to_string()));
    lengths(&mut table, ["phase_sum", "phase_sum_exact", "phase_sum_vanishes"], Unit::NONE, |row| {
        Some(row.length.clone())
    });
    table.done()
}
