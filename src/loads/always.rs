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

use num_rational::BigRational;
use num_traits::{Signed, Zero};

use crate::engine::{Cylinder, Engine, Link, Mechanism, Rod};
use crate::exact::{PhasorSum, Term, Turn};
use crate::order::{self, mass_radius};
use crate::proof::{Planar, Quantity, Sense};

/// How fast a crank turns, its rod, and where its piston is in its stroke.
type Moving = (u32, Mechanism, Turn);

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
    alone && groups(engine, quantity).values().all(PhasorSum::vanishes)
}

/// How many times the reference turns, and each crankshaft: what is decided by itself of a crank is its own first order.
fn speeds(engine: &Engine) -> impl Iterator<Item = u32> {
    let cranks = engine.geared_cranks().iter().map(|crank| crank.speed);
    [1].into_iter().chain(cranks.filter(|speed| *speed != 1))
}

/// The sums of the groups of pistons that have orders above 1 of the force, above 2 of the torque.
fn groups(engine: &Engine, quantity: Quantity) -> BTreeMap<Moving, PhasorSum> {
    let mut groups: BTreeMap<Moving, Vec<Term>> = BTreeMap::new();
    for (cylinder, mechanism) in engine.moved() {
        let rod = match mechanism {
            Mechanism::SliderCrank(rod) => rod,
            Mechanism::Link(link) => {
                let parts = quantity.planar().map(|planar| of_link(engine, planar, cylinder, link));
                for ((rod, own), term) in parts.into_iter().flatten() {
                    groups.entry((engine.speed_of(cylinder), rod, own)).or_default().push(term);
                }
                continue;
            }
        };
        let own = &cylinder.throw - &cylinder.bank;
        let weight = mass_radius(engine, cylinder);
        let ((rod, own), term) = match quantity {
            _ if rod.ratio.is_zero() => continue,
            Quantity::Axial(_) => {
                ((mechanism.clone(), own), Term { angle: Turn::zero(), weight: weight * &cylinder.crank_radius })
            }
            Quantity::Planar(planar) => {
                let own = match (rod.offset.is_zero(), rod.offset.is_negative()) {
                    (true, _) => own.times(2),
                    (_, true) => own.opposite(),
                    (_, false) => own,
                };
                let rod = Rod { ratio: rod.ratio.clone(), offset: rod.offset.abs() };
                let weight = weight * order::lever(engine, planar, &cylinder.position);
                ((Mechanism::SliderCrank(rod), own), Term { angle: cylinder.bank.clone(), weight })
            }
        };
        groups.entry((engine.speed_of(cylinder), rod, own)).or_default().push(term);
    }
    groups.into_iter().map(|(group, terms)| (group, PhasorSum::new(terms))).collect()
}

/// The terms of the force, or of the moment, of a link on a master rod.
fn of_link(engine: &Engine, quantity: Planar, cylinder: &Cylinder, link: &Link) -> Vec<((Mechanism, Turn), Term)> {
    let lever = order::lever(engine, quantity, &cylinder.position);
    let (own, knuckle) = (&cylinder.throw - &cylinder.bank, &cylinder.knuckle_mass * &cylinder.crank_radius);
    let piston = mass_radius(engine, cylinder);
    let master = (Mechanism::SliderCrank(link.master_rod()), (&own + &link.angle).times(2));
    // The knuckle pin stands, seen from the crankpin, by ε ahead of the direction of its cylinder.
    let [ahead, behind] = [&cylinder.bank + &link.correction, &cylinder.bank - &link.correction];
    let half = &piston * &link.knuckle / BigRational::from_integer(2.into());
    let of_pin = [(&ahead, half.clone()), (&behind, half), (&ahead, knuckle * &link.knuckle)];
    let with_the_master = of_pin.into_iter().filter(|_| !link.master.is_zero());
    let with_the_master = with_the_master.map(|(angle, weight)| (master.clone(), angle.clone(), weight));
    let kind = of_kind(link, own);
    let own = (!link.ratio.is_zero()).then(|| (kind, cylinder.bank.clone(), piston));
    let moving = with_the_master.chain(own);
    moving.map(|(group, angle, weight)| (group, Term { angle, weight: weight * &lever })).collect()
}

/// The motion of its own of a link, and by how much its crank is ahead of its cylinder where that counts.
fn of_kind(link: &Link, own: Turn) -> (Mechanism, Turn) {
    let unsigned = link.correction.clone().min(-&link.correction);
    let own = match (link.is_corrected(), unsigned == link.correction) {
        (false, _) => own.times(2),
        (true, true) => own,
        (true, false) => own.opposite(),
    };
    (Mechanism::Link(Link { correction: unsigned, ..link.clone() }), own)
}
