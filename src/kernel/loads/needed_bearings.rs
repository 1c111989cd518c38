//! Which orders do the loads of the main bearings call for, and what do the others add at most?
//!
//! The side forces of the pistons have odd orders that the shaking force does not have, so that these are not the orders of force and
//! moment.

use num_rational::BigRational;
use num_traits::Zero;

use super::bearing::{BearingLoads, bearing_loads};
use super::needed::{Bound, Choice, FOR_THE_REST, usual_orders, with_largest};
use super::pin::{LoadOrder, PinLoad, PinLoads, pin_loads};
use super::shares::Method;
use super::{Missing, Scale, Tails};
use crate::engine::Engine;
use crate::motion::SLACK;

/// Orders that are looked at one by one; the rest is bounded together.
const LOOKED_AT: [u32; 3] = [12, 24, 60];
/// The accuracy of the orders that are shown where none are asked for: counterweights leave less than a third of a load, of which it
/// is still a small part.
const USUAL: f64 = 1e-4;

/// The orders of the bearing loads that are shown where none are asked for: those of the layout file, else [`usual_orders`] and those
/// that a ten-thousandth of the largest bearing load needs.
pub fn usual_bearing_orders(engine: &Engine) -> Vec<u32> {
    bearing_orders(engine, &usual_orders(engine))
}

/// The orders of the bearing loads that go with those of force and moment: these and, unless the layout file says which, those that a
/// ten-thousandth of the largest bearing load needs.
pub fn bearing_orders(engine: &Engine, orders: &[u32]) -> Vec<u32> {
    if engine.orders_given() || engine.bearings().is_empty() {
        return orders.to_vec();
    }
    match choices(engine) {
        Ok(choices) => with_largest(orders.to_vec(), &choices, USUAL),
        Err(_) => orders.to_vec(),
    }
}

/// A choice per bearing, in parts of the largest load of all.
fn choices(engine: &Engine) -> Result<Vec<Choice>, Missing> {
    let tails = Tails::new(engine)?;
    let mut found = Vec::new();
    for highest in LOOKED_AT {
        let loads = bearing_loads(engine, &(1..=highest).collect::<Vec<u32>>(), Method::Continuous)?;
        let lengths = |index: usize| {
            let orders = loads.bearings[index].orders.iter().filter(|order| order.order > 0 && !order.swing.vanishes());
            orders.map(|order| (order.order, order.swing.largest() + order.swing.doubt())).collect()
        };
        let rests: Vec<f64> =
            (0..loads.bearings.len()).map(|index| rest(engine, &tails, &loads, index, highest)).collect();
        let most = rests.iter().copied().fold(0.0, f64::max);
        let peak = (largest(&loads) - most).max(0.0);
        let choice = |(index, rest)| Choice { lengths: lengths(index), rest, is_whole: rest == 0.0, peak };
        found = rests.into_iter().enumerate().map(choice).collect();
        if most <= FOR_THE_REST * USUAL * peak {
            break;
        }
    }
    Ok(found)
}

/// What the orders that are not among these add to the load of a bearing at most, whichever it is, and where the largest load of all
/// is at least; none where they add nothing.
///
/// # Errors
/// What the layout lacks for numbers.
pub fn left_out_of_bearings(engine: &Engine, loads: &BearingLoads) -> Result<Option<Bound>, Missing> {
    let kept: Vec<u32> = loads.bearings.iter().flat_map(|bearing| &bearing.orders).map(|order| order.order).collect();
    let highest = kept.iter().copied().max().unwrap_or(0).max(LOOKED_AT[0]);
    let dropped: Vec<u32> = (1..=highest).filter(|order| !kept.contains(order)).collect();
    let tails = Tails::new(engine)?;
    let others = bearing_loads(engine, &dropped, loads.method)?;
    let of_bearing =
        |index: usize| looked_at(&others.bearings[index].orders) + rest(engine, &tails, loads, index, highest);
    let most = (0..loads.bearings.len()).map(of_bearing).fold(0.0, f64::max);
    let bound = Bound { most: (most * SLACK).next_up(), peak: (largest(loads) - most * SLACK).max(0.0) };
    let is_at_rest = loads.scale.as_ref().is_some_and(Scale::is_at_rest);
    Ok((most > 0.0 && !is_at_rest).then_some(bound))
}

/// What the orders that are not among these add to the load of each crankpin at most, by cylinder.
///
/// # Errors
/// What the layout lacks for numbers.
pub fn left_out_of_pins(engine: &Engine, loads: &PinLoads) -> Result<Vec<f64>, Missing> {
    let kept: Vec<u32> = loads.pins.iter().flat_map(|pin| &pin.orders).map(|order| order.order).collect();
    let highest = kept.iter().copied().max().unwrap_or(0).max(LOOKED_AT[0]);
    let dropped: Vec<u32> = (1..=highest).filter(|order| !kept.contains(order)).collect();
    let tails = Tails::new(engine)?;
    let others = pin_loads(engine, &dropped)?;
    let of_pin = |(index, pin): (usize, &PinLoad)| {
        let own: Vec<BigRational> =
            (0..loads.pins.len()).map(|other| BigRational::from_integer(i32::from(other == index).into())).collect();
        let most = looked_at(&pin.orders) + tails.of_pins_above(engine, own.iter(), highest);
        if most > 0.0 { (most * SLACK).next_up() } else { 0.0 }
    };
    Ok(others.pins.iter().enumerate().map(of_pin).collect())
}

/// The largest lengths of these orders together, but for the constant force.
fn looked_at(orders: &[LoadOrder]) -> f64 {
    orders.iter().filter(|order| order.order > 0).map(|order| order.swing.largest() + order.swing.doubt()).sum()
}

/// What the orders of the pistons above this one add to the load of a bearing at most.
fn rest(engine: &Engine, tails: &Tails, loads: &BearingLoads, bearing: usize, order: u32) -> f64 {
    let zero = BigRational::zero();
    let (crank, place) = (loads.bearings[bearing].crank, bearing % engine.bearings().len());
    // Whatever moves a pin has a part of each bearing of its crankshaft; without one it adds nothing to any order.
    let parts = engine.cylinders().iter().map(|cylinder| match loads.parts.get(&cylinder.position) {
        Some(parts) if cylinder.crank == crank => &parts[place],
        Some(_) | None => &zero,
    });
    tails.of_pins_above(engine, parts, order)
}

fn largest(loads: &BearingLoads) -> f64 {
    loads.bearings.iter().map(|bearing| bearing.peak.value).fold(0.0, f64::max)
}
