//! Which orders does a wanted accuracy of the peaks call for? Those that a rigorous bound cannot do without.

use super::{Missing, Spectrum};
use crate::engine::{Engine, NotAnOrder};
use crate::proof::Quantity;

/// Orders that are looked at one by one; the rest is bounded together.
const LOOKED_AT: [u32; 5] = [12, 24, 60, 100, LAST];
const LAST: u32 = 200;
/// The part of the accuracy that the orders above those may take.
pub(super) const FOR_THE_REST: f64 = 0.25;
/// The accuracy of the orders that are shown where none are asked for.
const USUAL: f64 = 1e-3;
/// Orders of a load that are kept at most where none are asked for.
const MOST_USUAL: usize = 16;
/// The orders of the torque that are shown at least.
const FIRST_OF_TORQUE: [u32; 4] = [1, 2, 3, 4];

/// The orders that a wanted accuracy calls for.
#[derive(Clone, Debug, PartialEq)]
pub struct Needed {
    /// The accuracy, as a part of each peak.
    pub accuracy: f64,
    /// Whether the bounds hold it.
    pub reached: bool,
    /// Orders of force and moment to keep, rising.
    pub kept: Vec<u32>,
    /// Orders that do not vanish and are omitted all the same, among those that were looked at.
    pub dropped: Vec<u32>,
    /// The same of the torque, where the file asks for it.
    pub torque_kept: Vec<u32>,
    /// And those omitted.
    pub torque_dropped: Vec<u32>,
    /// Orders up to this one were looked at; all above it are omitted.
    pub looked_at: u32,
    /// What is omitted.
    pub left: LeftOut,
}

/// What is omitted of the loads where only some orders are shown.
#[derive(Clone, Debug, PartialEq)]
pub struct LeftOut {
    /// Of the force; none where nothing is.
    pub force: Option<Bound>,
    /// Of the moment.
    pub moment: Option<Bound>,
    /// Of the inertia torque, where the file asks for it.
    pub torque: Option<Bound>,
}

/// A bound of what is omitted of a load, in its multiples of m r ω².
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Bound {
    /// It is at most this.
    pub most: f64,
    /// The load peaks at least at this.
    pub peak: f64,
}

impl Bound {
    /// The part of the peak; none where it might be all of it.
    pub fn part(&self) -> Option<f64> {
        (self.most < self.peak).then(|| (self.most / self.peak).next_up())
    }
}

/// A load of which some orders are looked at.
pub(super) struct Choice {
    /// What the orders have, those that do not vanish.
    pub lengths: Vec<(u32, f64)>,
    /// What those above and all doubts have.
    pub rest: f64,
    /// No order above those looked at exists: what is kept is all.
    pub is_whole: bool,
    /// The load peaks at least at this.
    pub peak: f64,
}

impl Choice {
    fn new(spectrum: &Spectrum, quantity: Quantity) -> Self {
        let above = spectrum.rest(quantity);
        let rest = above + spectrum.doubt(quantity);
        let peak = spectrum.waveform(quantity).peak_of(quantity);
        let peak = (peak.value - rest).max(0.0);
        Choice { lengths: spectrum.lengths(quantity), rest, is_whole: above == 0.0, peak }
    }

    /// What is omitted where just these orders are kept.
    fn bound(&self, kept: &[u32]) -> Option<Bound> {
        let dropped: Vec<f64> =
            self.lengths.iter().filter(|(order, _)| !kept.contains(order)).map(|(_, length)| *length).collect();
        if self.is_whole && dropped.is_empty() {
            return None;
        }
        let most = dropped.iter().sum::<f64>() + self.rest;
        (most > 0.0).then(|| Bound { most: most.next_up(), peak: self.peak })
    }

    fn length(&self, order: u32) -> f64 {
        self.lengths.iter().find(|(of, _)| *of == order).map_or(0.0, |(_, length)| *length)
    }
}

/// The loads of an engine, enough orders of each for an accuracy, if there are.
struct Choices {
    /// Force and moment.
    swings: [Choice; 2],
    torque: Option<Choice>,
    looked_at: u32,
}

impl Choices {
    fn new(engine: &Engine, accuracy: f64, at_least: u32) -> Result<Self, Missing> {
        let with_torque = engine.effects().torque;
        let mut spectrum = Spectrum::new(engine)?;
        let mut found = None;
        let mut ladder: Vec<u32> = LOOKED_AT.into_iter().filter(|&highest| highest >= at_least).collect();
        if ladder.is_empty() {
            ladder.push(at_least);
        }
        for highest in ladder {
            spectrum.raise(highest, with_torque);
            let of = |quantity| {
                let mut choice = Choice::new(&spectrum, quantity);
                if super::vanishes_at_every_order(engine, quantity) {
                    choice.rest = 0.0;
                }
                choice
            };
            let choices = Choices {
                swings: [of(Quantity::FORCE), of(Quantity::MOMENT)],
                torque: with_torque.then(|| of(Quantity::TORQUE)),
                looked_at: highest,
            };
            let few = |choice: &Choice| choice.rest <= FOR_THE_REST * accuracy * choice.peak;
            let enough = choices.swings.iter().chain(&choices.torque).all(few);
            // Where the orders fall so slowly that the last of these would not do, more of them tell nothing.
            let quantities = [Quantity::FORCE, Quantity::MOMENT, Quantity::TORQUE];
            let hopeless =
                quantities.into_iter().zip(choices.swings.iter().chain(&choices.torque)).any(|(quantity, choice)| {
                    !choice.lengths.is_empty()
                        && spectrum.rest_above(quantity, LAST) > accuracy * (choice.peak + 2.0 * choice.rest)
                });
            found = Some(choices);
            if enough || hopeless {
                break;
            }
        }
        found.ok_or(Missing::Order(NotAnOrder(at_least)))
    }

    fn left_out(&self, kept: &[u32], torque_kept: &[u32]) -> LeftOut {
        let [force, moment] = &self.swings;
        LeftOut {
            force: force.bound(kept),
            moment: moment.bound(kept),
            torque: self.torque.as_ref().and_then(|torque| torque.bound(torque_kept)),
        }
    }
}

/// Of these loads, the orders to keep and to omit: the shortest go as long as the accuracy allows.
fn choose(choices: &[Choice], accuracy: f64) -> [Vec<u32>; 2] {
    let mut orders: Vec<u32> = choices.iter().flat_map(|choice| &choice.lengths).map(|(order, _)| *order).collect();
    orders.sort_unstable();
    orders.dedup();
    // In parts of the peaks, the larger of force and moment decides.
    let share = |sizes: &[f64]| {
        let parts = sizes.iter().zip(choices).map(|(size, choice)| if *size > 0.0 { size / choice.peak } else { 0.0 });
        parts.fold(0.0, f64::max)
    };
    let sizes = |order: u32| choices.iter().map(|choice| choice.length(order)).collect::<Vec<_>>();
    let mut rising = orders.clone();
    rising.sort_by(|a, b| share(&sizes(*a)).total_cmp(&share(&sizes(*b))));
    let mut sums: Vec<f64> = choices.iter().map(|choice| choice.rest).collect();
    let mut dropped = Vec::new();
    for order in rising {
        let with: Vec<f64> = sums.iter().zip(sizes(order)).map(|(sum, size)| sum + size).collect();
        if share(&with) > accuracy {
            break;
        }
        sums = with;
        dropped.push(order);
    }
    dropped.sort_unstable();
    orders.retain(|order| !dropped.contains(order));
    [orders, dropped]
}

/// Finds the orders that keep the peaks of force, moment and, where the file asks for it, torque to this relative accuracy.
///
/// # Errors
/// What the layout lacks for numbers.
pub fn needed_orders(engine: &Engine, accuracy: f64) -> Result<Needed, Missing> {
    let choices = Choices::new(engine, accuracy, 1)?;
    let [kept, dropped] = choose(&choices.swings, accuracy);
    let [torque_kept, torque_dropped] = choose(choices.torque.as_slice(), accuracy);
    let left = choices.left_out(&kept, &torque_kept);
    let holds = |bound: &Option<Bound>| bound.is_none_or(|bound| bound.part().is_some_and(|part| part <= accuracy));
    let reached = [&left.force, &left.moment, &left.torque].into_iter().all(holds);
    Ok(Needed { accuracy, reached, kept, dropped, torque_kept, torque_dropped, looked_at: choices.looked_at, left })
}

/// What is omitted where just these orders are shown.
///
/// # Errors
/// What the layout lacks for numbers.
pub fn left_out(engine: &Engine, orders: &[u32], torque_orders: &[u32]) -> Result<LeftOut, Missing> {
    let highest = orders.iter().chain(torque_orders).copied().max().unwrap_or(1);
    Ok(Choices::new(engine, USUAL, highest)?.left_out(orders, torque_orders))
}

/// The orders to examine where none are asked for: those of the layout file, else the first that exist and, where the engine has
/// numbers, those that a thousandth of its peaks needs.
pub fn usual_orders(engine: &Engine) -> Vec<u32> {
    if engine.orders_given() {
        return engine.orders().to_vec();
    }
    let Ok(choices) = Choices::new(engine, USUAL, 1) else { return engine.orders().to_vec() };
    with_largest(engine.orders().to_vec(), &choices.swings, USUAL)
}

/// The orders of the torque that go with those of force and moment: the first four, these, and those that a thousandth of its peak
/// needs.
pub(super) fn usual_torque_orders(engine: &Engine, orders: &[u32]) -> Result<Vec<u32>, Missing> {
    let choices = Choices::new(engine, USUAL, 1)?;
    let first = FIRST_OF_TORQUE.into_iter().chain(orders.iter().copied()).collect();
    Ok(with_largest(first, choices.torque.as_slice(), USUAL))
}

/// These orders and the largest of those that an accuracy needs.
pub(super) fn with_largest(mut orders: Vec<u32>, choices: &[Choice], accuracy: f64) -> Vec<u32> {
    let [mut kept, _] = choose(choices, accuracy);
    let size = |order: &u32| choices.iter().map(|choice| choice.length(*order) / choice.peak).fold(0.0, f64::max);
    kept.sort_by(|a, b| size(b).total_cmp(&size(a)));
    orders.extend(kept.into_iter().take(MOST_USUAL));
    orders.sort_unstable();
    orders.dedup();
    orders
}
