//! Does a load vanish at every order? Decided exactly, from one sum a crank angle.
//!
//! Order k of the force has the vectors `Σ w e^{iα} e^{±ik(β−α)}` (theory, section 3). Let the pistons with one and the same
//! `β − α` be a group. The functions `e^{ikφ}` of k are linearly independent for different φ, so that the sums of all k vanish if and only if
//! `Σ w e^{iα}` of each group does; if only the even k are asked for, those with the same `2(β−α)` are a group. The moment has weights with
//! arms, the torque the weights w r without `e^{iα}`.
//!
//! A rod and its mirror image, δ and −δ, have coefficients that differ by (−1)^k (see [`order::Factor::of_force`]), which is half a turn of β − α. Order 1,
//! which has the crank's own 1 beside the rod, and the orders of turning masses are judged one by one.

use std::collections::BTreeMap;

use num_traits::{Signed, Zero};

use crate::engine::{Engine, Mechanism, Rod};
use crate::exact::{PhasorSum, Term, Turn};
use crate::order::{self, mass_radius};
use crate::proof::{Quantity, Sense};

/// Whether a load vanishes at every order, proved; it may vanish without a proof only where rods differ.
pub fn vanishes_at_every_order(engine: &Engine, quantity: Quantity) -> bool {
    let alone = match quantity {
        Quantity::Torque | Quantity::Roll => order::torque(engine, 2).vanishes(),
        Quantity::Force | Quantity::Moment => {
            let shafts = engine.crankshaft().balancers.iter().map(|shaft| shaft.order);
            let vanishes = |order, sense| order::all_masses(engine, quantity, order, sense).vanishes();
            [1].into_iter().chain(shafts).all(|k| vanishes(k, Sense::Direct) && vanishes(k, Sense::Reverse))
        }
    };
    alone && groups(engine, quantity).values().all(PhasorSum::vanishes)
}

/// The sums of the groups of pistons that have orders above 1 of the force, above 2 of the torque.
fn groups(engine: &Engine, quantity: Quantity) -> BTreeMap<(Rod, Turn), PhasorSum> {
    let mut groups: BTreeMap<(Rod, Turn), Vec<Term>> = BTreeMap::new();
    for (cylinder, Mechanism::SliderCrank(rod)) in engine.moved() {
        let own = &cylinder.throw - &cylinder.bank;
        let weight = mass_radius(engine, cylinder);
        let (group, term) = match quantity {
            _ if rod.ratio.is_zero() => continue,
            Quantity::Torque | Quantity::Roll => {
                ((rod.clone(), own), Term { angle: Turn::zero(), weight: weight * &cylinder.crank_radius })
            }
            Quantity::Force | Quantity::Moment => {
                let own = match (rod.offset.is_zero(), rod.offset.is_negative()) {
                    (true, _) => own.times(2),
                    (_, true) => own.opposite(),
                    (_, false) => own,
                };
                let rod = Rod { ratio: rod.ratio.clone(), offset: rod.offset.abs() };
                let weight = weight * order::lever(engine, quantity, &cylinder.position);
                ((rod, own), Term { angle: cylinder.bank.clone(), weight })
            }
        };
        groups.entry(group).or_default().push(term);
    }
    groups.into_iter().map(|(group, terms)| (group, PhasorSum::new(terms))).collect()
}
