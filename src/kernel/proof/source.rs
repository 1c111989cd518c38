//! Which masses make an order, and what are their terms multiplied by?

use std::collections::BTreeMap;

use num_bigint::BigInt;
use num_rational::BigRational;
use num_traits::{One, Zero};

use super::audit::steps_of_longest;
use super::coefficient::{Coefficient, Factor};
use super::document::Document;
use super::engine::{Cylinder, Masses, RodStatement, TurningMassClaim};
use super::link::LinkClaim;
use super::quantity::{Quantity, Sense};
use super::roll;
use super::vector::Vector;
use super::verdict::phase;

/// What makes a force: a cylinder, with what its vector is multiplied by; the mass at the knuckle pin of its link, as far as it moves
/// as the master's piston does; or a mass that turns, with what its vector is multiplied by.
pub(super) enum Source<'a> {
    Cylinder(&'a Cylinder, Vec<Vector>),
    Knuckle(&'a Cylinder, &'a LinkClaim),
    /// The torque on the crank of a cylinder.
    Torque(&'a Cylinder),
    Turning(&'a TurningMassClaim, Vec<Vector>),
}

/// The sources of an order whose terms are multiplied by one coefficient.
pub(super) struct Group<'a> {
    pub coefficient: Coefficient,
    /// Whether the coefficient is zero: the sum counts for nothing.
    pub is_zero: bool,
    pub sources: Vec<Source<'a>>,
}

impl Masses {
    fn reciprocate(self) -> bool {
        matches!(self, Masses::Reciprocating | Masses::All)
    }

    pub(super) fn turn(self) -> bool {
        matches!(self, Masses::Rotating | Masses::Counterweights | Masses::All)
    }
}

impl Document {
    /// The sources of one order of a quantity by their coefficients, in the order of the first source of each: cylinders
    /// whose crankshaft has part in it, then turning masses of either sense. One group without sources where there is none.
    pub(super) fn groups(&self, quantity: Quantity, order: u32) -> Vec<Group<'_>> {
        let mut groups = Groups::default();
        let do_rods_differ = self.do_rods_differ();
        let cylinders = self.cylinders.iter().filter(|_| self.masses.reciprocate());
        for (cylinder, own) in cylinders.filter_map(|cylinder| Some((cylinder, cylinder.own_order(order)?))) {
            let (has_force, has_torque) = match quantity {
                Quantity::Planar(_) => (true, false),
                Quantity::TORQUE => (false, true),
                Quantity::ROLL => (!roll::arms(cylinder).is_empty(), true),
            };
            if has_force {
                for force in Factor::of_force(&cylinder.rod, own, do_rods_differ) {
                    groups.add(
                        force.coefficient.geared(cylinder.speed),
                        force.is_zero,
                        Source::Cylinder(cylinder, force.parts),
                    );
                }
            }
            if has_torque {
                let torque = Factor::of_torque(&cylinder.rod, own);
                groups.add(torque.coefficient.geared(cylinder.speed), torque.is_zero, Source::Torque(cylinder));
            }
        }
        // The roll moment of an engine with links is not judged.
        let shakes = quantity.planar().is_some() && self.masses.reciprocate();
        for (cylinder, link) in self.knuckles().filter(|_| shakes) {
            let factor = Factor::of_rod(&link.master_rod(), order);
            groups.add(factor.coefficient, factor.is_zero, Source::Knuckle(cylinder, link));
        }
        let is_there = |mass: &TurningMassClaim| match quantity {
            Quantity::Planar(_) => true,
            Quantity::ROLL => !mass.axis.is_empty(),
            Quantity::TORQUE => false,
        };
        let turning = self.turning_masses.iter().filter(|mass| self.masses.turn() && mass.order == order);
        for mass in turning.filter(|mass| is_there(mass)) {
            for factor in Factor::of_shaft(mass.coefficient_of.as_ref(), order, do_rods_differ) {
                groups.add(factor.coefficient, factor.is_zero, Source::Turning(mass, factor.parts));
            }
        }
        groups.or_empty()
    }

    /// Names and terms of a group in one sense (theory, section 3): weights m r, the moment's times the arm, the torque's
    /// times r, and the square, of the torque the cube, of its crankshaft's speed; `2k²` times the mass-radius of a mass that turns. Those of the roll moment: [`roll`].
    pub(super) fn terms(
        &self,
        group: &Group<'_>,
        quantity: Quantity,
        order: u32,
        sense: Option<Sense>,
    ) -> Vec<(String, Vector)> {
        let lever = |position: &BigRational| match quantity {
            Quantity::MOMENT => position - &self.reference_plane,
            Quantity::FORCE | Quantity::Axial(_) => BigRational::one(),
        };
        let is_roll = quantity == Quantity::ROLL;
        // Only cylinders that have part in the order are among the sources.
        let own = |cylinder: &Cylinder| cylinder.own_order(order).unwrap_or(order);
        let terms = |source: &Source<'_>| match source {
            Source::Cylinder(cylinder, parts) if is_roll => {
                (cylinder.name.clone(), roll::of_force(cylinder, own(cylinder), parts))
            }
            Source::Cylinder(cylinder, parts) => {
                let size = &cylinder.reciprocating_mass * &cylinder.crank_radius * lever(&cylinder.position);
                let (weight, order) = (size * cylinder.power(2), own(cylinder));
                let angle = phase(&cylinder.throw, &cylinder.bank, order, sense);
                let vectors = parts.iter().map(|part| turned(&angle, &weight, part, sense));
                (cylinder.name.clone(), vectors.collect())
            }
            Source::Knuckle(cylinder, link) => {
                // A complex mass on the master's piston pin: it is turned by Δ + ε in either sense.
                let weight = &cylinder.knuckle_weight * &link.knuckle * lever(&cylinder.position);
                let master = &cylinder.bank - &link.angle;
                let angle = phase(&cylinder.throw, &master, order, sense) + &link.angle + &link.correction;
                (knuckle_name(cylinder), vec![Vector { angle, weight }])
            }
            Source::Torque(cylinder) if is_roll => (cylinder.name.clone(), roll::of_torque(cylinder, own(cylinder))),
            Source::Torque(cylinder) => {
                let size = &cylinder.reciprocating_mass * &cylinder.crank_radius * &cylinder.crank_radius;
                let weight = size * cylinder.power(3);
                let angle = phase(&cylinder.throw, &cylinder.bank, own(cylinder), None);
                (cylinder.name.clone(), vec![Vector { angle, weight }])
            }
            Source::Turning(mass, parts) if is_roll => (mass.name.clone(), roll::of_turning(mass, parts)),
            Source::Turning(mass, parts) => {
                let twice_the_square = BigRational::from_integer(BigInt::from(order) * order * 2);
                let weight = twice_the_square * &mass.mass_radius * lever(&mass.position);
                let vectors = parts.iter().filter(|_| Some(mass.sense) == sense);
                (mass.name.clone(), vectors.map(|part| turned(&mass.angle, &weight, part, sense)).collect())
            }
        };
        let named = |source| {
            let (name, terms): (String, Vec<Vector>) = terms(source);
            terms.into_iter().map(move |term| (name.clone(), term))
        };
        group.sources.iter().flat_map(named).collect()
    }

    /// Whether the pistons have rods of several kinds.
    fn do_rods_differ(&self) -> bool {
        self.masses.reciprocate() && differ(self.cylinders.iter().map(|cylinder| &cylinder.rod))
    }

    /// The cylinders with a mass at the knuckle pin of their link.
    pub(super) fn knuckles(&self) -> impl Iterator<Item = (&Cylinder, &LinkClaim)> {
        let heavy = self.cylinders.iter().filter(|cylinder| !cylinder.knuckle_weight.is_zero());
        heavy.filter_map(|cylinder| Some((cylinder, cylinder.rod.link()?)))
    }

    /// The steps that the terms of an order cost in all, be they zero or not.
    pub(super) fn steps_of_terms(&self, order: u32) -> u64 {
        let of_cylinder = |one: &Cylinder| {
            let of_link = one.rod.link().map_or(0, |link| link.steps(order));
            let numbers = [&one.reciprocating_mass, &one.knuckle_weight, &one.crank_radius, &one.position];
            steps_of_longest(numbers).saturating_add(of_link)
        };
        let cylinders = self.cylinders.iter().map(of_cylinder);
        let turning = self.turning_masses.iter().map(|one| steps_of_longest([&one.mass_radius, &one.position]));
        cylinders.chain(turning).fold(0, u64::saturating_add)
    }
}

/// Whether rods are not all of one kind.
pub(super) fn differ<'a>(mut rods: impl Iterator<Item = &'a RodStatement>) -> bool {
    rods.next().is_some_and(|first| rods.any(|rod| rod != first))
}

/// What the mass at a knuckle pin is called.
pub(super) fn knuckle_name(cylinder: &Cylinder) -> String {
    format!("knuckle of cylinder {}", cylinder.name)
}

/// A vector times a part of it: turned by the angle of the part, the other way in a reverse sum.
pub(super) fn turned(angle: &BigRational, weight: &BigRational, part: &Vector, sense: Option<Sense>) -> Vector {
    let angle = match sense {
        Some(Sense::Reverse) => angle - &part.angle,
        Some(Sense::Direct) | None => angle + &part.angle,
    };
    Vector { angle, weight: weight * &part.weight }
}

#[derive(Default)]
struct Groups<'a> {
    list: Vec<Group<'a>>,
    places: BTreeMap<Coefficient, usize>,
}

impl<'a> Groups<'a> {
    fn add(&mut self, coefficient: Coefficient, is_zero: bool, source: Source<'a>) {
        let next = self.list.len();
        let place = *self.places.entry(coefficient.clone()).or_insert(next);
        if place == next {
            self.list.push(Group { coefficient, is_zero, sources: Vec::new() });
        }
        self.list[place].sources.push(source);
    }

    fn or_empty(self) -> Vec<Group<'a>> {
        match self.list.is_empty() {
            false => self.list,
            true => vec![Group { coefficient: Coefficient::One, is_zero: true, sources: Vec::new() }],
        }
    }
}
