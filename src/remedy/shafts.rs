//! Which balancer shafts are needed? One for each order and sense that is left, and no fewer can do.
//!
//! A shaft at +k or −k times the crank speed adds to the vector P_k⁺ or P_k⁻ alone, and to no other. So each that does
//! not vanish needs a shaft of its own; and one shaft is enough, as two weights on it make any force and any moment.

use num_rational::BigRational;

use super::comparable_engine::ComparableEngine;
use super::counterweights::{one_plane, two_planes};
use super::weight::Weight;
use crate::numbers;
use crate::order::{self, MassGroup, OrderSum};
use crate::proof::Sense;

/// What a shaft takes away.
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
    /// What it takes away.
    pub kind: Kind,
    /// Its weights.
    pub weights: Vec<Weight>,
    /// Whether it makes a Lanchester pair with the shaft that turns the other way: one weight each, of the same length.
    pub lanchester: bool,
}

/// The shaft of an order and sense whose force and moment about position 0 are these; `None` where both vanish.
pub fn shaft(
    order: u32,
    sense: Sense,
    force: &OrderSum,
    moment: &OrderSum,
    planes: &[BigRational; 2],
) -> Option<Shaft> {
    let (kind, weights) = match (force.vanishes(), moment.vanishes()) {
        (true, true) => return None,
        (true, false) => (Kind::Couple, two_planes(order, sense, force, moment, planes)),
        (false, _) => match one_plane(order, sense, force, moment) {
            Some(weight) => (Kind::Force, vec![weight]),
            None => (Kind::ForceAndMoment, two_planes(order, sense, force, moment, planes)),
        },
    };
    Some(Shaft { order, sense, kind, weights, lanchester: false })
}

/// The least set of shafts that takes away every vector of these orders but the direct ones of order 1, which
/// counterweights on the crankshaft take away.
pub fn shafts(subject: &ComparableEngine, orders: &[u32], planes: &[BigRational; 2]) -> Vec<Shaft> {
    let mut shafts = Vec::new();
    for &order in orders {
        let of_sense = |sense| {
            let (force, moment) = (subject.force(order, sense), subject.moment(order, sense));
            shaft(order, sense, &force, &moment, planes)
        };
        let direct = if order == 1 { None } else { of_sense(Sense::Direct) };
        let mut pair: Vec<Shaft> = direct.into_iter().chain(of_sense(Sense::Reverse)).collect();
        if let [a, b] = pair.as_mut_slice()
            && same_length(a, b)
        {
            (a.lanchester, b.lanchester) = (true, true);
        }
        shafts.append(&mut pair);
    }
    shafts
}

/// A shaft whose weights make less than this part of the load is left out.
pub const LEAST: f64 = 1e-6;

/// Whether the force of each weight of a shaft is below [`LEAST`] of the load: of what pistons, rods, pins and webs make at
/// order 1, end to end. Where c_k is not known it counts 1.
pub fn is_slight(subject: &ComparableEngine, shaft: &Shaft) -> bool {
    let engine = subject.engine();
    let pistons = engine.cylinders().iter().map(|cylinder| numbers::float(&order::mass_radius(engine, cylinder)));
    let turning = order::turning_masses(engine).into_iter().filter(|mass| match mass.source.group() {
        MassGroup::Rotating | MassGroup::Crankshaft => true,
        MassGroup::Reciprocating | MassGroup::Counterweights | MassGroup::Balancers => false,
    });
    let load = pistons.sum::<f64>() + turning.map(|mass| numbers::float(&mass.mass_radius).abs()).sum::<f64>();
    let square = f64::from(shaft.order) * f64::from(shaft.order);
    let force = |weight: &Weight| {
        let bare = || weight.vector.parts().values().map(|sum| numbers::evaluate(sum).norm()).sum();
        square * weight.decimals(subject).map_or_else(bare, |[size, _]| size)
    };
    shaft.weights.iter().all(|weight| force(weight) < LEAST * load)
}

fn same_length(a: &Shaft, b: &Shaft) -> bool {
    let ([one], [other]) = (a.weights.as_slice(), b.weights.as_slice()) else { return false };
    one.vector.is_as_long_as(&other.vector, a.order)
}
