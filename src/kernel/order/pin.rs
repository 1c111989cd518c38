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
//!
//! The rod of a crank that turns against the reference is the mirror image, in the axis of its cylinder, of that of the equivalent crank
//! ([`crate::engine::GearedCrank`]): the side force changes its sign, so that the two lines change places.

use num_rational::BigRational;
use num_traits::Zero;

use super::contribution::{Contribution, Sources, geared};
use super::crank::crank_of;
use super::factor::Factor;
use super::masses::MassGroup;
use super::phase::phase;
use super::source::Source;
use super::turning::mass_radius;
use crate::engine::{Cylinder, Engine, Mechanism, Rod};
use crate::exact::{Term, Turn};
use crate::motion::LinkMass;
use crate::proof::{Masses, Sense};

/// What the rods of an engine that names them hand on to their crankpins in one order and sense: inertia of the piston with its
/// side force, and the rotating part of the rod; several terms per cylinder. A link loads the crankpin of its master rod by decimals alone,
/// [`Factor::OnPin`], with its piston and with the mass at its knuckle pin.
///
/// They are those of one crankshaft, by its index: 0 where there is one alone.
pub fn pin_contributions(engine: &Engine, crank: usize, order: u32, sense: Sense) -> Vec<Contribution> {
    let cylinders = engine.cylinders().iter().enumerate().filter(|(_, cylinder)| cylinder.crank == crank);
    let of_cylinders = cylinders.flat_map(|(index, cylinder)| of_cylinder(engine, (index, cylinder), order, sense));
    // What the masses at knuckle pins do is all in the numbers of their links.
    let of_rods = |source| matches!(source, Source::BigEnd(_));
    of_cylinders.chain(turning(engine, crank, (order, sense), of_rods)).collect()
}

/// What a cylinder hands on: a link by its master rod, which is on the same crankpin.
fn of_cylinder(engine: &Engine, (index, of): (usize, &Cylinder), order: u32, sense: Sense) -> Vec<Contribution> {
    let Some(own) = engine.own_order(of, order) else { return Vec::new() };
    let (at, weight) = (phase(of, own, Some(sense)), mass_radius(engine, of));
    let one = |source, factor, term| Contribution { source, position: of.position.clone(), factor, term };
    match &of.mechanism {
        None => Vec::new(),
        Some(Mechanism::SliderCrank(rod)) => {
            let (speed, with_its_crank) = (engine.speed_of(of), sense == engine.sense_of(of));
            let weight = geared(weight, speed, 2);
            let of_force = Factor::parts_of_force(engine, of.mechanism.as_ref(), own);
            let parts = of_piston(of_force, rod, own, (sense, with_its_crank)).into_iter();
            let term = |part, turned: Turn| Term { angle: &at + &turned, weight: &weight * part };
            let of_part = |(factor, part, turned): (Factor, _, _)| (factor.geared(speed), term(part, turned));
            parts.map(of_part).map(|(factor, term)| one(Source::Piston(index), factor, term)).collect()
        }
        Some(Mechanism::Link(link)) => {
            let masses = [
                (Source::Piston(index), LinkMass::Piston, weight),
                (Source::Knuckle(index), LinkMass::Knuckle, &of.knuckle_mass * &of.crank_radius),
            ];
            let weighing = masses.into_iter().filter(|(_, _, weight)| !weight.is_zero());
            let on_pin = |mass| Factor::OnPin(link.clone(), mass, sense);
            let term = |weight| Term { angle: at.clone(), weight };
            weighing.map(|(source, mass, weight)| one(source, on_pin(mass), term(weight))).collect()
        }
    }
}

/// What the bearings of a crankshaft have to carry in one order and sense: the loads of its crankpins, and its own masses.
pub fn shaft_contributions(engine: &Engine, crank: usize, order: u32, sense: Sense) -> Vec<Contribution> {
    let own = |source: Source| match source.group() {
        MassGroup::Crankshaft | MassGroup::Counterweights => true,
        // A balancer shaft is in bearings of its own; the others load the pins.
        MassGroup::Reciprocating | MassGroup::Rotating | MassGroup::Balancers => false,
    };
    let mut all = pin_contributions(engine, crank, order, sense);
    all.extend(turning(engine, crank, (order, sense), own));
    all
}

/// Whether some piston has an offset and a rod of finite length, or a link, so that its crankpin may feel a constant force.
pub fn has_constant_pin_loads(engine: &Engine) -> bool {
    let mut mechanisms = engine.mechanisms().into_iter();
    mechanisms.any(|mechanism| mechanism.rod().is_none_or(|rod| crank_of(rod).has_side_part(0)))
}

fn turning(
    engine: &Engine,
    crank: usize,
    (order, sense): (u32, Sense),
    is_meant: impl Fn(Source) -> bool,
) -> Vec<Contribution> {
    let sources = Sources::new(engine, Masses::All).of_crankshaft(crank);
    sources.of_turning(order, sense).filter(|one| is_meant(one.source)).collect()
}

/// What the vector of a piston in the star of the force is multiplied by, from what its force is: numbers of the motion, each with its part
/// and the angle it is turned by; `turns` says whether it turns as the crank of the piston does.
fn of_piston(
    of_force: Vec<(Factor, Term)>,
    rod: &Rod,
    order: u32,
    (sense, turns): (Sense, bool),
) -> Vec<(Factor, BigRational, Turn)> {
    let whole = |number: i64| BigRational::from_integer(number.into());
    let mut parts = Vec::new();
    for (factor, Term { angle, weight }) in of_force.into_iter().filter(|(factor, _)| factor.exists(order)) {
        let k = i64::from(order);
        let part = BigRational::new(if turns { k - 1 } else { k + 1 }.into(), k.into());
        let angle = if sense == Sense::Direct { angle } else { -&angle };
        parts.push((factor, part * weight, angle));
    }
    if order == 1 {
        parts.push((Factor::One, whole(if turns { 1 } else { -1 }), Turn::zero()));
    }
    let crank = crank_of(rod);
    if crank.has_side_part(order) {
        // −u_k = −i (−i)^k E and u_k* = −i i^k E; of a crank that turns against the reference their opposites.
        let of_order = if sense == Sense::Direct { -i64::from(order) } else { i64::from(order) };
        let quarters = if turns == (sense == Sense::Direct) { of_order - 1 } else { of_order + 1 };
        match crank.rational_side_part(order) {
            Some(number) => parts.push((Factor::One, number, Turn::fraction(quarters.rem_euclid(4), 4))),
            None => {
                let (factor, sign) = Factor::of_side(rod, order);
                parts.push((factor, if turns { -sign } else { sign }, Turn::zero()));
            }
        }
    }
    parts.retain(|(_, part, _)| !part.is_zero());
    parts
}
