//! Which theorem on stars does an engine fall under? One sentence, after its own proofs.

use num_rational::BigRational;

use crate::engine::Engine;
use crate::exact::Turn;
use crate::page::{Text, phrase};
use crate::stars::{self, Fate, Obstruction, Pins};

/// That no star of this many throws does better, where its moment of order 1 is left by every one of them; of equal cylinders one spacing apart, in line or in
/// two banks on shared pins, each pin in a direction of its own.
pub(in crate::report) fn cited(engine: &Engine) -> Option<Text> {
    let cylinders = engine.cylinders();
    let first = cylinders.first()?;
    let is_equal = cylinders.iter().all(|other| {
        (&other.reciprocating_mass, &other.crank_radius) == (&first.reciprocating_mass, &first.crank_radius)
    });
    if !is_equal || !engine.geared_cranks().is_empty() || engine.has_links() {
        return None;
    }
    let mut pins: Vec<(&BigRational, &Turn)> =
        cylinders.iter().map(|cylinder| (&cylinder.position, &cylinder.throw)).collect();
    pins.sort();
    pins.dedup();
    let throws = u32::try_from(pins.len()).ok()?;
    let in_banks = cylinders.len() / pins.len();
    let mut banks: Vec<&Turn> = cylinders.iter().map(|cylinder| &cylinder.bank).collect();
    banks.sort();
    banks.dedup();
    let is_full = banks.len() == in_banks && in_banks <= 2 && cylinders.len() == pins.len() * in_banks;
    let turned = |throw: &Turn| (throw - pins[0].1).turns() * BigRational::from_integer(throws.into());
    let mut directions: Vec<BigRational> = pins.iter().map(|(_, throw)| turned(throw)).collect();
    directions.sort();
    let is_even =
        (0..).zip(&directions).all(|(step, direction): (i64, _)| *direction == BigRational::from_integer(step.into()));
    let spacing = pins.get(1)?.0 - pins[0].0;
    let is_spaced = pins.windows(2).all(|pair| pair[1].0 - pair[0].0 == spacing);
    let Fate::Never(Obstruction { prime, .. }) = stars::fate(Pins::once(throws), &[1]) else { return None };
    (is_full && is_even && is_spaced && throws > 2).then(|| match in_banks {
        1 => phrase!(
            "**No star of {} throws is free of the first-order couple**, in any order of its throws: {} is a power of the prime {} (page of stars, {}).",
            throws,
            throws,
            prime,
            Text::code("crankstar stars")
        ),
        _ => phrase!(
            "**No order of the {} pins, and no bank angle, removes the rotating first-order couple:** {} is a power of the prime {} (page of stars, {}).",
            throws,
            throws,
            prime,
            Text::code("crankstar stars")
        ),
    })
}
