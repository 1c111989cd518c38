//! Which orders does a wanted accuracy of the peak call for? Those that a rigorous bound cannot do without.
//!
//! The coefficients of the root of the motion have one sign at the dead point where they all add up, so that
//! `Σ_{k≥1} |c_k − [k=1]| = (λ+|δ|)/√(1−(λ+|δ|)²)`, the acceleration there. What the first K leave of that bounds all
//! the orders above K, whatever the star of the engine.

use std::collections::BTreeMap;

use num_bigint::BigInt;
use num_rational::BigRational;
use num_traits::{One, Signed, ToPrimitive, Zero};

use super::{Loads, Missing, OrderLoads, Swing, loads};
use crate::layout::{Effects, Layout, Rod};
use crate::motion::SliderCrank;
use crate::order;
use crate::verdict;

/// Orders that are looked at one by one; the rest is bounded together.
const LOOKED_AT: [u32; 3] = [24, 60, 100];
/// Roundings of the floats of a bound, relative to the sum that it is the rest of.
const ROUNDING: f64 = 1e-13;

/// The orders that a wanted accuracy calls for.
#[derive(Clone, Debug, PartialEq)]
pub struct Needed {
    /// Orders to keep, rising.
    pub kept: Vec<u32>,
    /// Orders that do not vanish and are left out all the same, among those that were looked at.
    pub dropped: Vec<u32>,
    /// Orders up to this one were looked at; all above it are left out.
    pub looked_at: u32,
    /// What is left out is at most this part of the peak force; none where no order has a force; infinite where orders above
    /// those that were looked at may have more than these.
    pub force_bound: Option<f64>,
    /// The same of the moment.
    pub moment_bound: Option<f64>,
}

/// Finds the orders that keep the peaks of force and moment to this relative accuracy.
///
/// # Errors
/// What the layout lacks for numbers.
pub fn needed_orders(layout: &Layout, accuracy: f64) -> Result<Needed, Missing> {
    // The torque has no part in the choice.
    let layout = &Layout { effects: Effects::default(), ..layout.clone() };
    let mut found = None;
    for highest in LOOKED_AT {
        let orders: Vec<u32> = (1..=highest).collect();
        let all = loads(layout, &orders)?;
        let mut rest = rest(layout, highest)?;
        // The exact sums repeat after a period: what is proved to vanish for a whole one vanishes for ever, if no balancer shaft
        // hides an order of the pistons.
        if layout.crankshaft.balancers.is_empty() && BigInt::from(highest) > verdict::period(layout) {
            let swings: [fn(&OrderLoads) -> &Swing; 2] = [|loads| &loads.force, |loads| &loads.moment];
            for (rest, swing) in rest.iter_mut().zip(swings) {
                if all.orders.iter().all(|loads| swing(loads).vanishes()) {
                    *rest = 0.0;
                }
            }
        }
        let (needed, holds) = choose(&all, rest, accuracy, highest);
        found = Some(needed);
        if holds {
            break;
        }
    }
    found.ok_or(Missing::Rods)
}

/// Bounds of force and moment of all orders above the highest, in multiples of m r ω².
fn rest(layout: &Layout, highest: u32) -> Result<[f64; 2], Missing> {
    let mut bounds = faster_shafts(layout, highest).map(|size| size.to_f64().unwrap_or(f64::INFINITY));
    let mut known: BTreeMap<&Rod, f64> = BTreeMap::new();
    for (cylinder, rod) in layout.cylinders.iter().zip(&layout.mechanism.rods) {
        let left = match known.get(rod) {
            Some(left) => *left,
            None => *known.entry(rod).or_insert(rest_of_one(rod, highest)?),
        };
        let size = |number: BigRational| number.abs().to_f64().unwrap_or(f64::INFINITY);
        let weight = order::mass_radius(layout, cylinder);
        bounds[1] += left * size(&weight * layout.arm(cylinder));
        bounds[0] += left * size(weight);
    }
    Ok(bounds)
}

/// The largest force of the shafts that turn faster than this order, and its moment about the reference plane, in
/// multiples of m r ω²: what they add where higher orders are left out.
fn faster_shafts(layout: &Layout, highest: u32) -> [BigRational; 2] {
    let half = BigRational::new(1.into(), 2.into());
    let shafts = order::turning_masses(layout).into_iter().filter(|mass| mass.order > highest);
    shafts.fold([BigRational::zero(), BigRational::zero()], |[force, moment], shaft| {
        let size = shaft.weight() * &half;
        let arm = (&shaft.position - &layout.reference_plane).abs();
        [force + &size, moment + size * arm]
    })
}

/// What the orders above the highest of one cylinder add up to at most, in multiples of its m r ω².
fn rest_of_one(rod: &Rod, highest: u32) -> Result<f64, Missing> {
    let crank = SliderCrank::new(rod.ratio.clone(), rod.offset.clone());
    let crank = crank.map_err(|error| Missing::Motion(error.to_string()))?;
    let one = BigRational::one();
    let reach = &rod.ratio + rod.offset.abs();
    // Exact as long as it can cancel: near the end of reach a float would not tell the gap.
    let squared = &reach * &reach / ((&one - &reach) * (&one + &reach));
    let whole = squared.to_f64().unwrap_or(f64::INFINITY).sqrt();
    let known = (1..=highest).map(|order| {
        let c = crank.coefficient(order);
        // c_1 has the crank's own 1, exactly, in its real part.
        if order == 1 { c.im.to_float().abs() } else { c.to_complex().norm() }
    });
    Ok((whole - known.sum::<f64>()).max(0.0) + ROUNDING * whole)
}

/// Leaves out the shortest vectors as long as the bound allows; the flag says whether it holds at all.
fn choose(all: &Loads, rest: [f64; 2], accuracy: f64, highest: u32) -> (Needed, bool) {
    let peaks = [all.force.peak().value - rest[0], all.moment.peak().value - rest[1]];
    let largest = |loads: &OrderLoads| [loads.force.largest(), loads.moment.largest()];
    let is_left = |swing: &Swing| !swing.vanishes();
    let mut left: Vec<&OrderLoads> =
        all.orders.iter().filter(|loads| is_left(&loads.force) || is_left(&loads.moment)).collect();
    // In parts of the peaks, the larger of force and moment decides.
    let share = |sizes: [f64; 2]| {
        let parts =
            sizes.into_iter().zip(peaks).map(|(size, peak)| if size > 0.0 { size / peak.max(0.0) } else { 0.0 });
        parts.fold(0.0, f64::max)
    };
    left.sort_by(|a, b| share(largest(a)).total_cmp(&share(largest(b))));
    let exists =
        [!all.force.harmonics().is_empty() || rest[0] > 0.0, !all.moment.harmonics().is_empty() || rest[1] > 0.0];
    let mut sums = rest;
    let holds = share(sums) <= accuracy;
    let mut dropped = Vec::new();
    for loads in &left {
        let more = largest(loads);
        let with = [sums[0] + more[0], sums[1] + more[1]];
        if share(with) > accuracy {
            break;
        }
        sums = with;
        dropped.push(loads.order);
    }
    let mut kept: Vec<u32> = left.iter().map(|loads| loads.order).filter(|order| !dropped.contains(order)).collect();
    kept.sort_unstable();
    dropped.sort_unstable();
    let bound = |place: usize| exists[place].then(|| sums[place] / peaks[place].max(0.0));
    let needed = Needed { kept, dropped, looked_at: highest, force_bound: bound(0), moment_bound: bound(1) };
    (needed, holds)
}
