//! Which balancer shafts are needed? One for each order and sense that is left, and no fewer can do.
//!
//! A shaft at +k or −k times the crank speed adds to the vector P_k⁺ or P_k⁻ alone, and to no other. So each that does
//! not vanish needs a shaft of its own; and one shaft is enough, as two weights on it make any force and any moment.

use num_rational::BigRational;
use num_traits::{Signed, Zero};

use super::comparable_engine::ComparableEngine;
use super::counterweights::{one_plane, two_planes};
use super::planes;
use super::weight::Weight;
use crate::engine::Engine;
use crate::numbers;
use crate::order::{self, OrderSum};
use crate::proof::Sense;

/// What a shaft cancels.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Kind {
    /// A force that acts in one plane: one weight.
    Force,
    /// A couple: two opposite weights.
    Couple,
    /// A force and a moment besides: two weights.
    ForceAndMoment,
}

/// A balancer shaft; the crankshaft itself is the one that turns with the crank at order 1.
#[derive(Clone, Debug, PartialEq)]
pub struct Shaft {
    /// How many times it turns in a revolution of the crankshaft.
    pub order: u32,
    /// With the crank or against it.
    pub sense: Sense,
    /// What it cancels.
    pub kind: Kind,
    /// Its weights.
    pub weights: Vec<Weight>,
    /// Whether it makes a Lanchester pair with the shaft that turns the other way: one weight each, of the same length.
    pub lanchester: bool,
}

/// The shaft of an order and sense whose force and moment about position 0 are these; `None` where both vanish. One weight where it is
/// between the ends of the engine, else two in the planes.
pub fn shaft(
    order: u32,
    sense: Sense,
    force: &OrderSum,
    moment: &OrderSum,
    planes: &[BigRational; 2],
    ends: &[BigRational; 2],
) -> Option<Shaft> {
    let is_inside = |weight: &Weight| (&ends[0]..=&ends[1]).contains(&&weight.position);
    let (kind, weights) = match (force.vanishes(), moment.vanishes()) {
        (true, true) => return None,
        (true, false) => (Kind::Couple, two_planes(order, sense, force, moment, planes)),
        (false, _) => match one_plane(order, sense, force, moment).filter(is_inside) {
            Some(weight) => (Kind::Force, vec![weight]),
            None => (Kind::ForceAndMoment, two_planes(order, sense, force, moment, planes)),
        },
    };
    Some(Shaft { order, sense, kind, weights, lanchester: false })
}

/// The least set of shafts that cancels every vector of these orders but the direct ones of order 1, which
/// counterweights on the crankshaft cancel. Shafts of the engine are resized in their own planes, unless planes were named.
pub fn shafts(subject: &ComparableEngine, orders: &[u32], planes: &[BigRational; 2], planes_named: bool) -> Vec<Shaft> {
    let (mut shafts, ends) = (Vec::new(), planes::ends(subject.engine()));
    for &order in orders {
        let there = |sense| if planes_named { Vec::new() } else { planes::planes(subject, order, sense) };
        let of_sense = |sense| {
            let (force, moment) = (subject.force(order, sense), subject.moment(order, sense));
            let found = shaft(order, sense, &force, &moment, planes, &ends)?;
            let weights = match resizing(&found, &there(sense), planes) {
                Some(own) => two_planes(order, sense, &force, &moment, &own),
                None => found.weights,
            };
            Some(Shaft { weights, ..found })
        };
        let direct = if order == 1 { None } else { of_sense(Sense::Direct) };
        let mut pair: Vec<Shaft> = direct.into_iter().chain(of_sense(Sense::Reverse)).collect();
        if let [a, b] = pair.as_mut_slice()
            && same_length(a, b)
            && Sense::BOTH.into_iter().all(|sense| planes::planes(subject, order, sense).is_empty())
        {
            (a.lanchester, b.lanchester) = (true, true);
        }
        shafts.append(&mut pair);
    }
    shafts
}

/// What is left in an order and makes less than this part of the load is omitted: of the force of all pistons at order 1, end to end,
/// and for the moment of the force of each times its distance from the centre of mass of all.
///
/// The checker has the same limit (`src/kernel/proof/left_out.rs`).
pub const LEAST: f64 = 1e-6;

/// Decimals decide what is omitted, and the checker of the document encloses it: they keep this far from the limit.
const MARGIN: f64 = 0.999;

/// The shafts that are needed, and those that are omitted: of each order as many, the smallest first, as make less than [`LEAST`] of the
/// load all together.
pub fn without_slight(subject: &ComparableEngine, shafts: Vec<Shaft>) -> [Vec<Shaft>; 2] {
    let [mut needed, mut left_out]: [Vec<Shaft>; 2] = Default::default();
    let load = load(subject.engine());
    let mut rest = shafts;
    while let Some(order) = rest.first().map(|shaft| shaft.order) {
        let (of_order, others): (Vec<Shaft>, Vec<Shaft>) = rest.into_iter().partition(|shaft| shaft.order == order);
        rest = others;
        let mut rising: Vec<([f64; 2], &Shaft)> =
            of_order.iter().map(|shaft| (part_of_load(subject, shaft, load), shaft)).collect();
        let largest = |[force, moment]: [f64; 2]| force.max(moment);
        rising.sort_by(|(one, _), (other, _)| largest(*one).total_cmp(&largest(*other)));
        let is_slight = |count: &usize| {
            let all_of = |quantity: usize| rising[..*count].iter().map(|(part, _)| part[quantity]).sum::<f64>();
            [0, 1].into_iter().all(|quantity| all_of(quantity) < MARGIN * LEAST)
        };
        let count = (1..=rising.len()).rev().find(is_slight).unwrap_or(0);
        let slight: Vec<Shaft> = rising[..count].iter().map(|(_, shaft)| (*shaft).clone()).collect();
        let (out, kept): (Vec<Shaft>, Vec<Shaft>) = of_order.into_iter().partition(|shaft| slight.contains(shaft));
        left_out.extend(out);
        needed.extend(kept.into_iter().map(|shaft| Shaft { lanchester: shaft.lanchester && count == 0, ..shaft }));
    }
    [needed, left_out]
}

/// The load of force and of moment: of all pistons at order 1, and of each times its distance from the centre of mass of all.
fn load(engine: &Engine) -> [f64; 2] {
    let weights: Vec<(BigRational, &BigRational)> =
        engine.cylinders().iter().map(|one| (order::mass_radius(engine, one), &one.position)).collect();
    let load: BigRational = weights.iter().map(|(weight, _)| weight).sum();
    let first: BigRational = weights.iter().map(|(weight, position)| weight * *position).sum();
    let centre = if load.is_zero() { BigRational::zero() } else { first / &load };
    let of_moment: BigRational = weights.iter().map(|(weight, position)| weight * (*position - &centre).abs()).sum();
    [load, of_moment].map(|load| numbers::float(&load))
}

/// Force and moment that a shaft cancels, in parts of the load. A vector is a force of half its length; a c_k that is not known counts
/// as 2, which none is above.
fn part_of_load(subject: &ComparableEngine, shaft: &Shaft, [of_force, of_moment]: [f64; 2]) -> [f64; 2] {
    let plane = subject.engine().reference_plane();
    let force = |weight: &Weight| weight.adds();
    let moment = |weight: &Weight| weight.adds().scaled(&(&weight.position - plane));
    let part = |of_weight: &dyn Fn(&Weight) -> OrderSum, load: f64| {
        let sum = shaft.weights.iter().map(of_weight).fold(OrderSum::default(), |sum, more| sum.plus(&more));
        let bare = || sum.parts().values().map(|sum| 2.0 * numbers::evaluate(sum).norm()).sum();
        let vector = subject.value(&sum, shaft.order, shaft.sense).map_or_else(bare, |value| value.norm());
        if sum.vanishes() { 0.0 } else { vector / 2.0 / load }
    };
    [part(&force, of_force), part(&moment, of_moment)]
}

fn same_length(a: &Shaft, b: &Shaft) -> bool {
    let ([one], [other]) = (a.weights.as_slice(), b.weights.as_slice()) else { return false };
    one.vector.is_as_long_as(&other.vector, a.order)
}

/// The planes of weights that are there, in which others than the weights found do the same; none where nothing is there to resize, or
/// what is found is in these planes already.
pub(super) fn resizing(found: &Shaft, there: &[BigRational], usual: &[BigRational; 2]) -> Option<[BigRational; 2]> {
    let (first, last) = (there.first()?, there.last()?);
    if found.weights.iter().all(|weight| there.contains(&weight.position)) {
        return None;
    }
    if first != last {
        return Some([last.clone(), first.clone()]);
    }
    // Beside the only plane that of the usual ones which stands farther off.
    let off = |plane: &BigRational| (plane - first).abs();
    let [one, other] = usual;
    Some([first.clone(), if off(one) >= off(other) { one.clone() } else { other.clone() }])
}
