//! Which theorems on stars does an engine fall under? A sentence each, after its own proofs.

use num_rational::BigRational;
use num_traits::{Signed, ToPrimitive};

use super::super::{rising, typeset};
use super::tables::every;
use super::words::least_moment;
use crate::engine::Engine;
use crate::page::Text;
use crate::report::texts::stars as text;
use crate::stars::{self, Fate, Obstruction, Pins, Star};

/// What theorems say of equal cylinders one spacing apart, in line or in two banks on shared pins.
pub(in crate::report) fn cited(engine: &Engine) -> Vec<Text> {
    let Some(Crank { pins, banks, star }) = Crank::of(engine) else { return Vec::new() };
    let throws = star.directions();
    match (pins.each, stars::fate(Pins::once(throws), &[1])) {
        (1, Fate::Never(Obstruction { prime, .. })) if throws > 2 => vec![never(throws, banks, prime)],
        (1, Fate::Lost(_)) if banks == 1 && !engine.has_offset() && star.loses(1) => lost(&star),
        (2, _) if throws > 1 && (1..=throws).all(|order| star.loses(order)) => vec![text::mirror_image(page())],
        _ => Vec::new(),
    }
}

fn page() -> Text {
    Text::code("crankstar stars")
}

/// The pins of an engine, in evenly spread directions.
struct Crank {
    pins: Pins,
    /// How many cylinders are on each pin.
    banks: usize,
    star: Star,
}

impl Crank {
    /// None of unequal cylinders, of uneven spacing or directions, or where not every pin has a cylinder of each bank.
    fn of(engine: &Engine) -> Option<Self> {
        let cylinders = engine.cylinders();
        let first = cylinders.first()?;
        let is_equal = cylinders.iter().all(|other| {
            (&other.reciprocating_mass, &other.crank_radius, &other.mechanism)
                == (&first.reciprocating_mass, &first.crank_radius, &first.mechanism)
        });
        if !is_equal || !engine.geared_cranks().is_empty() || !engine.has_one_vector_per_order() {
            return None;
        }
        let pins = rising(cylinders.iter().map(|cylinder| (&cylinder.position, &cylinder.throw)));
        let in_banks = cylinders.len() / pins.len();
        let banks = rising(cylinders.iter().map(|cylinder| &cylinder.bank));
        let is_full = banks.len() == in_banks && in_banks <= 2 && cylinders.len() == pins.len() * in_banks;
        let spacing = pins.get(1)?.0 - pins[0].0;
        let is_spaced = spacing.is_positive() && pins.windows(2).all(|pair| pair[1].0 - pair[0].0 == spacing);
        let turns: Vec<BigRational> = pins.iter().map(|(_, throw)| (*throw - pins[0].1).turns().clone()).collect();
        let directions = rising(turns.clone());
        let count = u32::try_from(directions.len()).ok()?;
        let steps = turns.iter().map(|turn| {
            let steps = turn * BigRational::from_integer(count.into());
            steps.is_integer().then(|| steps.to_integer().to_u32()).flatten()
        });
        let steps = steps.collect::<Option<Vec<u32>>>()?;
        let each = pins.len() / directions.len();
        let is_even = (0..count).all(|direction| steps.iter().filter(|step| **step == direction).count() == each);
        (is_full && is_even && is_spaced).then(|| Crank {
            pins: Pins { directions: count, each: each as u32 },
            banks: in_banks,
            star: Star::new(count, &steps),
        })
    }
}

/// That the moment of order 1 is left by every star.
fn never(throws: u32, banks: usize, prime: u32) -> Text {
    match banks {
        1 => text::no_star(throws, prime, page()),
        _ => text::no_pin_sequence(throws, prime, page()),
    }
}

/// That no star loses more, that none leaves less, that none of fewer throws loses as much: of a star that loses order 1.
fn lost(star: &Star) -> Vec<Text> {
    let throws = star.directions();
    let left = star.first_left();
    let before: Vec<u32> = every(throws).into_iter().filter(|order| left.is_none_or(|left| *order < left)).collect();
    let never = |count: u32| {
        let orders = if left.is_some() { before.clone() } else { every(count) };
        matches!(stars::fate(Pins::once(count), &orders), Fate::Never(_))
    };
    let is_first = (2..throws).all(never);
    let fewest = is_first.then(|| match left {
        None => text::fewest_for_every_order(throws - 1, page()),
        Some(_) => text::fewest_for_orders(throws - 1, typeset::listed(&before), page()),
    });
    let more = left.map(|left| stars::fate(Pins::once(throws), &[&before[..], &[left]].concat()));
    let most = match more {
        Some(Fate::Never(why)) => Some(text::not_together(throws, typeset::listed(&why.orders), why.prime, page())),
        _ => None,
    };
    let bounds = stars::least(Pins::once(throws), &left.into_iter().collect::<Vec<_>>());
    let least =
        bounds.iter().find(|bound| least_moment(bound).is_some_and(|sum| star.moment(bound.order).is_as_long_as(&sum)));
    let least = least.map(|bound| text::least_left(throws, bound.order, page()));
    [fewest, most, least].into_iter().flatten().collect()
}
