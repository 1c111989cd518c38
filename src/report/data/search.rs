//! Which columns hold what a search found? A row a star of the front; what was looked at; the firing orders that twist the shaft least.

use super::cells::{decimals, truths, whole, words};
use crate::engine::CycleOrder;
use crate::exact::PhasorSum;
use crate::numbers;
use crate::proof::Sense;
use crate::search::{FoundStar, Front, FrontDocument, Moment, RankedOrder, Torsion, document};
use crate::table::{Column, Table, Unit, Values};

/// The tables of a search: the stars, the question with its counts, and the firing orders where they are asked for.
pub fn search(front: &Front, torsion: Option<&Torsion>) -> Vec<Table> {
    // Names and counts are those of the JSON document.
    let document = document(front);
    let firing_orders = torsion.map(firing_orders);
    [stars(front, &document), question(&document)].into_iter().chain(firing_orders).collect()
}

fn stars(front: &Front, document: &FrontDocument) -> Table {
    let known = &document.stars;
    let mut table =
        Table::new("stars", "a crank star of the front, the best by the first order first", front.stars.len());
    let mut add = |pattern, unit, about, values| table.push(Column::new(pattern, unit, about, values));
    add("star", Unit::NONE, "its number in the answer", whole(1..=known.len()));
    add(
        "firing_order",
        Unit::NONE,
        "cylinders in firing order, 1-3-4-2; empty where it cannot fire evenly",
        Values::Words(known.iter().map(|star| star.firing_order.clone()).collect()),
    );
    add(
        "throws_turns",
        Unit::NONE,
        "angles of the throws from the free end, in turns, exact, with a space between",
        Values::Exact(known.iter().map(|star| Some(star.throws.join(" "))).collect()),
    );
    for (place, first) in front.stars.first().iter().flat_map(|star| star.moments.iter().enumerate()) {
        moments(front, &mut table, place, first);
    }
    for (place, (order, _)) in front.stars.first().iter().flat_map(|star| star.minor.iter().enumerate()) {
        let order = order.exact().to_string();
        let of = |star: &FoundStar| star.minor.get(place).map(|(_, sum)| length(sum, numbers::evaluate(sum).norm()));
        let lengths: Vec<Option<Length>> = front.stars.iter().map(of).collect();
        let patterns = ["phase_sum_{order}", "phase_sum_{order}_exact", "phase_sum_{order}_vanishes"];
        let about = "length of the phase-vector sum of a minor order that is compared: deflections of the mode at the firing angles";
        add_lengths(&mut table, patterns, &[&order], [Unit::NONE; 3], about, &lengths);
    }
    let mut add = |pattern, about, values| table.push(Column::new(pattern, Unit::NONE, about, values));
    add(
        "neighbours",
        "pairs of neighbours in a bank that fire in succession, the fewest that the star allows; empty without even firing, unless they are compared",
        Values::Integer(known.iter().map(|star| star.neighbours.and_then(|count| count.try_into().ok())).collect()),
    );
    add(
        "classes",
        "stars with exactly these values, up to rotation, mirror and reversal; empty where a theorem gave the star and nobody counted them",
        counted(known.iter().map(|star| star.classes)),
    );
    add(
        "stars",
        "stars with exactly these values and cylinder 1 at 0; empty where a theorem gave the star and nobody counted them",
        counted(known.iter().map(|star| star.stars)),
    );
    add("layout", "the engine as a layout file", words(known.iter().map(|star| star.layout.as_str())));
    table
}

/// Numbers of stars, where they are known.
fn counted(counts: impl Iterator<Item = Option<u64>>) -> Values {
    Values::Integer(counts.map(|count| count.and_then(|count| count.try_into().ok())).collect())
}

/// The moment of an order: its length, exactly, and whether it is zero.
fn moments(front: &Front, table: &mut Table, place: usize, first: &Moment) {
    let order = first.order.to_string();
    let sense = first.sense.map(|sense| match sense {
        Sense::Direct => "direct",
        Sense::Reverse => "reverse",
    });
    let (patterns, about) = match sense {
        None => (
            ["moment_{order}_{unit}", "moment_{order}_exact", "moment_{order}_vanishes"],
            "moment of this order about the middle, zero to peak",
        ),
        Some(_) => (
            ["moment_{order}_{sense}_{unit}", "moment_{order}_{sense}_exact", "moment_{order}_{sense}_vanishes"],
            "length |P| of the vector of this order that turns with the crank (direct) or against it (reverse); its amplitude is half of it",
        ),
    };
    let holes: Vec<&str> = [order.as_str()].into_iter().chain(sense).collect();
    let of = |star: &FoundStar| star.moments.get(place).map(|moment| length(&moment.sum, moment.decimal));
    let lengths: Vec<Option<Length>> = front.stars.iter().map(of).collect();
    add_lengths(table, patterns, &holes, [Unit::OPEN_SPACING, Unit::NONE, Unit::NONE], about, &lengths);
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

fn add_lengths(
    table: &mut Table,
    patterns: [&'static str; 3],
    holes: &[&str],
    [unit, of_exact, of_truth]: [Unit; 3],
    about: &'static str,
    lengths: &[Option<Length>],
) {
    let all = || lengths.iter().map(Option::as_ref);
    let values = decimals(all().map(|length| length.map(|length| length.decimal)));
    table.push(Column::named(patterns[0], holes, unit, about, values));
    let values = Values::Exact(all().map(|length| length.and_then(|length| length.exact.clone())).collect());
    let about = "the same in closed form, where one is short enough to read";
    table.push(Column::named(patterns[1], holes, of_exact, about, values));
    let values = truths(all().map(|length| length.map(|length| length.vanishes)));
    table.push(Column::named(patterns[2], holes, of_truth, "whether it is proved to be 0", values));
}

fn question(document: &FrontDocument) -> Table {
    let orders = document.orders.iter().map(u32::to_string).collect::<Vec<_>>().join(" ");
    let mut table = Table::new("question", "the question, and how much was looked at: one row", 1);
    let mut add = |pattern, about, values| table.push(Column::new(pattern, Unit::NONE, about, values));
    add("engine", "the engine", words([document.engine.as_str()]));
    add("cycle", "two-stroke or four-stroke", words([document.cycle]));
    add("orders", "the orders whose moments are compared, with a space between", words([orders]));
    add("by_neighbours", "whether neighbours that fire in succession count", truths([Some(document.neighbours)]));
    let exact = |value: &Option<String>| Values::Exact(vec![value.clone()]);
    let about = "how far ahead of the pin of bank 1 that of bank 2 stands, in turns; empty where both are one";
    add("pin_split_turns", about, exact(&document.pin_split));
    let about =
        "how far bank 1 stands towards the free end of bank 2, in spacings of the throws; empty where it does not";
    add("bank_offset_spacings", about, exact(&document.bank_offset));
    let shape = (!document.mode_shape.is_empty()).then(|| document.mode_shape.join(" "));
    let about = "the deflections that weigh the minor orders, with a space between; empty where none are compared";
    add("mode_shape", about, exact(&shape));
    add(
        "all_stars",
        "stars with cylinder 1 at 0 that there are; as text, for there may be more than a whole number holds",
        Values::Exact(vec![Some(document.all_stars.clone())]),
    );
    add("judged", "stars judged one by one", whole([document.judged]));
    add("cut", "beginnings left out with all that could follow", whole([document.cut]));
    table
}

/// One minor order of a firing order of a star.
struct Minor<'a> {
    star: usize,
    ranked: &'a RankedOrder,
    order: CycleOrder,
    length: Option<Length>,
}

fn firing_orders(torsion: &Torsion) -> Table {
    let rows = torsion.stars.iter().enumerate().flat_map(|(index, star)| {
        star.best.iter().flat_map(move |ranked| {
            let pairs = torsion.orders.iter().zip(&ranked.sums);
            pairs.map(move |(&order, sum)| {
                let length = length(sum, numbers::evaluate(sum).norm());
                Minor { star: index + 1, ranked, order, length: Some(length) }
            })
        })
    });
    let rows: Vec<Minor> = rows.collect();
    let about =
        "a minor order of a firing order of one of the first stars that no other firing order beats in all of them";
    let mut table = Table::new("firing_orders", about, rows.len());
    let mut add = |pattern, about, values| table.push(Column::new(pattern, Unit::NONE, about, values));
    add("star", "the number of the star", whole(rows.iter().map(|row| row.star)));
    add("firing_order", "cylinders in firing order, 1-3-4-2", words(rows.iter().map(|row| row.ranked.name())));
    add(
        "order",
        "the minor order, halves too: 3/2",
        Values::Exact(rows.iter().map(|row| Some(row.order.exact().to_string())).collect()),
    );
    let lengths: Vec<Option<Length>> = rows.iter().map(|row| row.length.clone()).collect();
    let patterns = ["phase_sum", "phase_sum_exact", "phase_sum_vanishes"];
    let about = "length of the phase-vector sum: deflections of the mode at the firing angles";
    add_lengths(&mut table, patterns, &[], [Unit::NONE; 3], about, &lengths);
    table
}
