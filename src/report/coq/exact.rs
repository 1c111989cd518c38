//! After which turn of the crank does the shaking force repeat, of the exact motion and all orders together?

use std::collections::BTreeMap;

use num_bigint::BigInt;
use num_integer::Integer;
use num_rational::BigRational;
use num_traits::{One, Zero};

use super::evidence::{Grid, fraction};
use super::not_stated::has_pistons;
use super::theorem::Theorem;
use crate::proof::{Cylinder, Document, Quantity};

/// The least turn after which it does; none where order 1 of the force is left or not asked for, or rods or crank radii differ.
pub(super) fn theorem(document: &Document) -> Option<Theorem> {
    let first = document.cylinders.first().filter(|_| has_pistons(document) && document.turning_masses.is_empty())?;
    let like_first = |other: &Cylinder| (&other.rod, &other.crank_radius) == (&first.rod, &first.crank_radius);
    let mut order_1 =
        document.verdicts.iter().filter(|verdict| (verdict.quantity, verdict.order) == (Quantity::FORCE, 1));
    let is_balanced = order_1.clone().count() == 2 && order_1.all(|verdict| verdict.vanishes && verdict.of.is_empty());
    if !first.rod.is_centric() || !is_balanced || !document.cylinders.iter().all(like_first) {
        return None;
    }
    let masses = document.cylinders.iter().map(|cylinder| (cylinder, &cylinder.reciprocating_mass));
    let vectors = masses.flat_map(|(cylinder, mass)| [(&cylinder.throw, mass), (&cylinder.bank, mass)]);
    let Grid { conductor, scale } = Grid::of_pairs(vectors);
    let conductor = conductor.lcm(&BigInt::from(2));
    // Such turns bring a piston to another one, so that of the half turn there are no more parts than cylinders.
    let turns = (1..=document.cylinders.len()).rev().map(|parts| BigInt::from(2 * parts));
    let turn = turns
        .filter(|parts| conductor.is_multiple_of(parts))
        .map(|parts| BigRational::new(BigInt::one(), parts))
        .find(|turn| places(document, turn) == places(document, &BigRational::zero()))?;
    let (turn, radius) = (fraction(&turn), fraction(&first.crank_radius));
    let mut theorem = Theorem::exact(
        "real_force_repeats".to_owned(),
        &format!(
            "forall m r l omega t : R, omega <> 0 ->\n  \
             exact_force the_engine m r l omega (t + radians {turn} / omega) = exact_force the_engine m r l omega t"
        ),
        &format!(
            "fun m r l omega t w => @force_repeats the_engine {turn} r l (@same_place the_engine {turn} {conductor} {scale} {radius} erefl\n  \
             (force_direct_order_1 C real_circle) (force_reverse_order_1 C real_circle) r l) m omega t w"
        ),
    );
    theorem.text = format!("{HEAD}{}", theorem.text);
    Some(theorem)
}

const HEAD: &str = "\
(* The exact motion, all orders together: the force of pistons on centric rods, at a time t, for any masses, crank radius, rod and speed. *)
From Crankstar.real Require Import Motion Place.
";

/// How far each piston is through its half turn, in which bank, after this turn: the masses there.
fn places(document: &Document, turn: &BigRational) -> BTreeMap<[BigRational; 2], BigRational> {
    let half = BigRational::new(BigInt::one(), BigInt::from(2));
    let within = |angle: BigRational, whole: &BigRational| &angle - (&angle / whole).floor() * whole;
    let mut places = BTreeMap::new();
    for Cylinder { throw, bank, reciprocating_mass, .. } in &document.cylinders {
        let place = [within(throw - bank + turn, &half), within(bank.clone(), &BigRational::one())];
        *places.entry(place).or_insert_with(BigRational::zero) += reciprocating_mass;
    }
    places.retain(|_, mass: &mut BigRational| !mass.is_zero());
    places
}
