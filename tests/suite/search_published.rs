//! Where do the firing orders that makers publish stand among all there are? The table of the README of the search, found again.

use std::fs;

use crankstar::engine::Cycle;
use crankstar::numbers::number;
use crankstar::search::{FoundStar, Front, Options, Problem, Standing, search};
use num_rational::BigRational;

use crate::support::plain_search::Star;

/// Two-stroke engines of the large makers, from memory of their guides.
const PUBLISHED: [&[usize]; 5] = [
    &[1, 4, 3, 2, 5],
    &[1, 5, 3, 4, 2, 6],
    &[1, 7, 2, 5, 4, 3, 6],
    &[1, 8, 3, 4, 7, 2, 5, 6],
    &[1, 6, 7, 3, 5, 8, 2, 4, 9],
];

/// Throws in units of 1/n turn, for a firing order of a two-stroke engine.
fn throws(order: &[usize]) -> Vec<u16> {
    let place = |cylinder: usize| order.iter().position(|&fired| fired == cylinder).expect("each cylinder fires");
    (1..=order.len()).map(|cylinder| ((order.len() - place(cylinder)) % order.len()) as u16).collect()
}

fn front(cylinders: usize, orders: &[u32], neighbours: bool) -> Front {
    let problem = Problem { neighbours, ..Problem::inline(cylinders as u32, Cycle::TwoStroke, orders) };
    search(&problem, &Options::default()).expect("a front")
}

fn dashed(star: &FoundStar) -> String {
    let order = star.firing_order.as_ref().expect("it fires evenly").iter().map(|cylinder| (cylinder + 1).to_string());
    order.collect::<Vec<_>>().join("-")
}

/// `0.449, 4.980, 2`: moments, and neighbours.
fn values(star: &FoundStar) -> Vec<String> {
    let moment = |moment: &crankstar::search::Moment| match moment.sum.vanishes() {
        true => "0".to_owned(),
        false => format!("{:.3}", moment.decimal),
    };
    let neighbours = star.neighbours.expect("it fires evenly").to_string();
    star.moments.iter().map(moment).chain([neighbours]).collect()
}

/// What is compared: squared moments, and neighbours where they count.
fn aims(front: &Front, star: &FoundStar) -> Star {
    let neighbours = front
        .problem
        .neighbours
        .then(|| number(BigRational::from_integer(star.neighbours.expect("it fires evenly").into())));
    let squares = star.moments.iter().map(|moment| moment.sum.squared_modulus());
    Star::new(squares.chain(neighbours).collect(), 1)
}

/// On the front, or the first star of it that is better.
fn standing(front: &Front, order: &[usize]) -> String {
    let own = aims(front, &front.known(&throws(order)).expect("a star"));
    let better = front.stars.iter().find(|star| aims(front, star).beats(&own));
    let on = front.standing(&throws(order)).expect("a star") == Standing::On;
    assert_eq!(on, better.is_none(), "what is not on the front is beaten by a star of it");
    match better {
        None => "yes".to_owned(),
        Some(star) => format!("{}: {}", dashed(star), values(star).join(", ")),
    }
}

fn row(order: &[usize]) -> String {
    let counted = front(order.len(), &[1, 2, 4], true);
    let own = counted.known(&throws(order)).expect("a star");
    assert_eq!(dashed(&own), order.iter().map(usize::to_string).collect::<Vec<_>>().join("-"));
    let two = standing(&front(order.len(), &[1, 2], false), order);
    let three = standing(&front(order.len(), &[1, 2, 4], false), order);
    let cells = [[dashed(&own)].as_slice(), &values(&own), &[two, three, standing(&counted, order)]].concat();
    format!("| {} |\n", cells.join(" | "))
}

#[test]
fn the_table_of_published_two_stroke_orders_is_what_the_search_finds() {
    let table: String = PUBLISHED.iter().map(|order| row(order)).collect();
    let readme =
        fs::read_to_string(concat!(env!("CARGO_MANIFEST_DIR"), "/src/kernel/search/README.md")).expect("a text");
    assert!(readme.contains(&table), "the rows are\n{table}");
}

#[test]
fn three_published_orders_stand_on_the_front_of_a_minor_order_too() {
    for order in &PUBLISHED[..3] {
        let minor_orders = [2].into_iter().filter_map(crankstar::engine::CycleOrder::of_halves).collect();
        let problem = Problem { minor_orders, ..Problem::inline(order.len() as u32, Cycle::TwoStroke, &[1, 2, 4]) };
        let front = search(&problem, &Options::default()).expect("a front");
        assert_eq!(
            front.standing(&throws(order)),
            Ok(Standing::On),
            "what no other beats in less is not beaten in more"
        );
    }
}
