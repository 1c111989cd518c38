//! Does a load vanish at every order? Decided exactly, from one sum a crank angle.
//!
//! Order k of the force has the vectors `Σ w e^{iα} e^{±ik(β−α)}` (theory, section 3). Let the pistons with one and the same
//! `β − α` be a group. The functions `e^{ikφ}` of k are linearly independent for different φ, so that the sums of all k vanish if and only if
//! `Σ w e^{iα}` of each group does; if only the even k are asked for, those with the same `2(β−α)` are a group. The moment has weights with
//! arms, the torque the weights w r without `e^{iα}`.
//!
//! A rod and its mirror image, δ and −δ, have coefficients that differ by (−1)^k (see [`order::Factor::of_force`]), which is half a turn of β − α. Order 1,
//! which has the crank's own 1 beside the rod, and the orders of turning masses are decided one by one.
//!
//! Cranks that turn at different speeds are decided separately: pistons of one speed are a group, and order 1 is the first of each crank.
//!
//! A link on a master rod moves in part as the master does, with `β − α₀` of the master's cylinder, and has a motion of its own, which it
//! shares with the links of its kind; the mass at its knuckle pin moves as the master. A mass that is complex, turned by γ, turns `e^{iα}`. A link
//! with a corrected knuckle angle has κ cos ε of the master's motion, two vectors, and a motion of its own of every order, where −ε is half a turn
//! of β − α.

use std::collections::BTreeMap;

use crate::engine::{Engine, Law, Ray};
use crate::exact::{PhasorSum, Term, Turn};
use crate::order::{self, mass_radius};
use crate::proof::{Quantity, Sense};

/// How fast a crank turns, the law of a motion, and where the piston is in its stroke.
type Moving = (u32, Law, Turn);

/// Whether a load vanishes at every order, proved; it may vanish without a proof only where rods or the speeds of crankshafts differ.
pub fn vanishes_at_every_order(engine: &Engine, quantity: Quantity) -> bool {
    let alone = match quantity {
        Quantity::Axial(_) if !engine.has_judged_torque() => false,
        // An endless rod has the second order of its crank alone.
        Quantity::Axial(_) => speeds(engine).all(|speed| order::torque(engine, 2 * speed).vanishes()),
        Quantity::Planar(planar) => {
            let shafts = engine.crankshaft().balancers.iter().map(|shaft| shaft.order);
            let vanishes = |order, sense| order::all_masses(engine, planar, order, sense).vanishes();
            speeds(engine).chain(shafts).all(|k| vanishes(k, Sense::Direct) && vanishes(k, Sense::Reverse))
        }
    };
    alone && sums_of_alike(engine, quantity).iter().all(PhasorSum::vanishes)
}

/// How many times the reference turns, and each crankshaft: what is decided by itself of a crank is its own first order.
pub fn speeds(engine: &Engine) -> impl Iterator<Item = u32> {
    let cranks = engine.geared_cranks().iter().map(|crank| crank.speed);
    [1].into_iter().chain(cranks.filter(|speed| *speed != 1))
}

/// The sums of the groups of pistons that have orders above 1 of the force, above 2 of the torque: those orders vanish where these do.
pub fn sums_of_alike(engine: &Engine, quantity: Quantity) -> Vec<PhasorSum> {
    let mut groups: BTreeMap<Moving, Vec<Term>> = BTreeMap::new();
    for (cylinder, mechanism) in engine.moved() {
        let (speed, own) = (engine.speed_of(cylinder), &cylinder.throw - &cylinder.bank);
        match quantity {
            Quantity::Axial(_) => {
                let weight = mass_radius(engine, cylinder) * &cylinder.crank_radius;
                for Ray { law, .. } in Ray::of(mechanism).into_iter().filter(|ray| !ray.law.is_endless()) {
                    let term = Term { angle: Turn::zero(), weight: weight.clone() };
                    groups.entry((speed, law, own.clone())).or_default().push(term);
                }
            }
            Quantity::Planar(planar) => {
                let lever = order::lever(engine, planar, &cylinder.position);
                for ray in order::rays(engine, cylinder).into_iter().filter(|ray| !ray.law.is_endless()) {
                    let (law, own) = ray.law.unsigned(&own + &ray.ahead);
                    let term = Term { angle: &cylinder.bank + &ray.turned, weight: ray.weight * &lever };
                    groups.entry((speed, law, own)).or_default().push(term);
                }
            }
        }
    }
    groups.into_values().map(PhasorSum::new).collect()
}
