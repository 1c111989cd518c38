//! Which terms does each cylinder add to an order of the load of its crankpin, and what do the bearings have to carry?
//!
//! The rod pushes the pin with `F (1 − i tan β) e^{iα}`, F the inertia of the piston (theory, section 8): in order k with
//! `½ (c_k − n_k)` before the direct and `½ (c_k + n_k)*` before the reverse vector of the star of the force. With
//! `n_k = (c_k − [k=1])/k + u_k` these are
//!
//! - direct: `c_k (k−1)/k + [k=1] − u_k`,
//! - reverse: `(c_k (k+1)/k − [k=1] + u_k)*`,
//!
//! exact sums before c_k, 1 and u_k. Where u_k is rational but for a quarter turn it is part of the terms before 1. Order 0,
//! which pistons with an offset alone have, is a constant force: `−u_0/2` in both sums.

use num_rational::BigRational;
use num_traits::Zero;

use super::contribution::{Contribution, Sources};
use super::crank::crank_of;
use super::factor::Factor;
use super::masses::MassGroup;
use super::phase::phase;
use super::source::Source;
use super::turning::mass_radius;
use crate::engine::{Engine, Mechanism, Rod};
use crate::exact::{Term, Turn};
use crate::proof::{Masses, Sense};

/// What the rods of an engine that names them hand on to their crankpins in one order and sense: inertia of the piston with its
/// side force, and the rotating part of the rod; several terms per cylinder. A link loads no crankpin but a master rod, which is not
/// computed: nothing is asked of an engine that has one.
pub fn pin_contributions(engine: &Engine, order: u32, sense: Sense) -> Vec<Contribution> {
    let cylinders = engine.cylinders().iter().enumerate();
    let known = cylinders.filter_map(|(index, cylinder)| Some((index, cylinder, cylinder.rod()?)));
    let of_pistons = known.flat_map(|(index, cylinder, rod)| {
        let weight = mass_radius(engine, cylinder);
        of_piston(engine, rod, order, sense).into_iter().map(move |(factor, part, turned)| Contribution {
            source: Source::Piston(index),
            position: cylinder.position.clone(),
            factor,
            term: Term { angle: &phase(cylinder, order, Some(sense)) + &turned, weight: &weight * part },
        })
    });
    of_pistons.chain(turning(engine, order, sense, |group| group == MassGroup::Rotating)).collect()
}

/// What the bearings have to carry in one order and sense: the loads of the crankpins, and the masses of the crankshaft itself.
pub fn shaft_contributions(engine: &Engine, order: u32, sense: Sense) -> Vec<Contribution> {
    let own = |group| match group {
        MassGroup::Crankshaft | MassGroup::Counterweights => true,
        // A balancer shaft is in bearings of its own; the others load the pins.
        MassGroup::Reciprocating | MassGroup::Rotating | MassGroup::Balancers => false,
    };
    let mut all = pin_contributions(engine, order, sense);
    all.extend(turning(engine, order, sense, own));
    all
}

/// Whether some piston has an offset and a rod of finite length, so that its crankpin feels a constant force.
pub fn has_constant_pin_loads(engine: &Engine) -> bool {
    engine.mechanisms().into_iter().filter_map(Mechanism::rod).any(|rod| crank_of(rod).has_side_part(0))
}

fn turning(engine: &Engine, order: u32, sense: Sense, is_meant: impl Fn(MassGroup) -> bool) -> Vec<Contribution> {
    let sources = Sources::new(engine, Masses::All);
    sources.of_turning(order, sense).filter(|one| is_meant(one.source.group())).collect()
}

/// What the vector of a piston in the star of the force stands before: numbers of the motion, each with its part and the angle it
/// is turned by.
fn of_piston(engine: &Engine, rod: &Rod, order: u32, sense: Sense) -> Vec<(Factor, BigRational, Turn)> {
    let whole = |number: i64| BigRational::from_integer(number.into());
    let mut parts = Vec::new();
    let of_force = if order > 0 { Factor::parts_of_rod(engine, Some(rod), order) } else { Vec::new() };
    for (factor, Term { angle, weight }) in of_force.into_iter().filter(|(factor, _)| factor.exists(order)) {
        let k = i64::from(order);
        parts.push(match sense {
            Sense::Direct => (factor, BigRational::new((k - 1).into(), k.into()) * weight, angle),
            Sense::Reverse => (factor, BigRational::new((k + 1).into(), k.into()) * weight, -&angle),
        });
    }
    if order == 1 {
        let part = match sense {
            Sense::Direct => whole(1),
            Sense::Reverse => whole(-1),
        };
        parts.push((Factor::One, part, Turn::zero()));
    }
    let crank = crank_of(rod);
    if crank.has_side_part(order) {
        // −u_k = −i (−i)^k E and u_k* = −i i^k E.
        let quarters = match sense {
            Sense::Direct => -1 - i64::from(order),
            Sense::Reverse => i64::from(order) - 1,
        };
        match crank.rational_side_part(order) {
            Some(number) => parts.push((Factor::One, number, Turn::fraction(quarters.rem_euclid(4), 4))),
            None => {
                let (factor, sign) = Factor::of_side(rod, order);
                let part = match sense {
                    Sense::Direct => -sign,
                    Sense::Reverse => sign,
                };
                parts.push((factor, part, Turn::zero()));
            }
        }
    }
    parts.retain(|(_, part, _)| !part.is_zero());
    parts
}
