//! Which masses make an order, and what do their terms stand before?

use std::collections::BTreeMap;

use num_bigint::BigInt;
use num_rational::BigRational;
use num_traits::{One, Zero};

use super::coefficient::{Coefficient, Factor};
use super::document::Document;
use super::engine::{Cylinder, Masses, Quantity, RodStatement, Sense, TurningMassClaim};
use super::link::LinkClaim;
use super::verdict::{Vector, phase};

/// What makes a force: a cylinder, with what its vector is multiplied by; the mass at the knuckle pin of its link, as far as it moves
/// as the master's piston does; or a mass that turns.
pub(super) enum Source<'a> {
    Cylinder(&'a Cylinder, Vec<Vector>),
    Knuckle(&'a Cylinder, &'a LinkClaim),
    Turning(&'a TurningMassClaim),
}

/// The sources of an order whose terms stand before one coefficient.
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
    /// The sources of one order of a quantity by their coefficients, in the order of the first source of each: cylinders,
    /// then turning masses of either sense. One group without sources where there is none.
    pub(super) fn groups(&self, quantity: Quantity, order: u32) -> Vec<Group<'_>> {
        let mut groups = Groups::default();
        let cylinders = self.cylinders.iter().filter(|_| self.masses.reciprocate());
        for cylinder in cylinders {
            let factors = match quantity {
                Quantity::Force | Quantity::Moment => Factor::of_force(&cylinder.rod, order),
                Quantity::Torque => vec![Factor::of_torque(&cylinder.rod, order)],
            };
            for factor in factors {
                groups.add(factor.coefficient, factor.is_zero, Source::Cylinder(cylinder, factor.parts));
            }
        }
        let knuckles = self.knuckles().filter(|_| self.masses.reciprocate() && quantity != Quantity::Torque);
        for (cylinder, link) in knuckles {
            let factor = Factor::of_rod(&link.master_rod(), order);
            groups.add(factor.coefficient, factor.is_zero, Source::Knuckle(cylinder, link));
        }
        let is_there = self.masses.turn() && quantity != Quantity::Torque;
        let turning = self.turning_masses.iter().filter(|mass| is_there && mass.order == order);
        for mass in turning {
            groups.add(Coefficient::One, false, Source::Turning(mass));
        }
        groups.or_empty()
    }

    /// Names and terms of a group in one sense (theory, section 3): weights m r, the moment's times the arm, the torque's
    /// times r; `2k²` times the mass-radius of a mass that turns.
    pub(super) fn terms(
        &self,
        group: &Group<'_>,
        quantity: Quantity,
        order: u32,
        sense: Option<Sense>,
    ) -> Vec<(String, Vector)> {
        let lever = |position: &BigRational| match quantity {
            Quantity::Moment => position - &self.reference_plane,
            Quantity::Force | Quantity::Torque => BigRational::one(),
        };
        let terms = |source: &Source<'_>| match source {
            Source::Cylinder(cylinder, parts) => {
                let radius = &cylinder.crank_radius;
                let by = match quantity {
                    Quantity::Torque => radius.clone(),
                    Quantity::Force | Quantity::Moment => lever(&cylinder.position),
                };
                let weight = &cylinder.reciprocating_mass * radius * by;
                let angle = phase(&cylinder.throw, &cylinder.bank, order, sense);
                let part = |part: &Vector| (cylinder.name.clone(), turned(&angle, &weight, part, sense));
                parts.iter().map(part).collect()
            }
            Source::Knuckle(cylinder, link) => {
                // A complex mass on the master's piston pin: it is turned by Δ in either sense.
                let weight = &cylinder.knuckle_weight * &link.knuckle * lever(&cylinder.position);
                let angle = phase(&cylinder.throw, &(&cylinder.bank - &link.angle), order, sense) + &link.angle;
                vec![(knuckle_name(cylinder), Vector { angle, weight })]
            }
            Source::Turning(mass) => {
                let twice_the_square = BigRational::from_integer(BigInt::from(order) * order * 2);
                let weight = twice_the_square * &mass.mass_radius * lever(&mass.position);
                let vector = Vector { angle: mass.angle.clone(), weight };
                (Some(mass.sense) == sense).then(|| (mass.name.clone(), vector)).into_iter().collect()
            }
        };
        group.sources.iter().flat_map(terms).collect()
    }

    /// The cylinders with a mass at the knuckle pin of their link.
    pub(super) fn knuckles(&self) -> impl Iterator<Item = (&Cylinder, &LinkClaim)> {
        self.cylinders.iter().filter(|cylinder| !cylinder.knuckle_weight.is_zero()).filter_map(|cylinder| {
            match &cylinder.rod {
                RodStatement::Link(link) => Some((cylinder, link)),
                RodStatement::Unknown | RodStatement::Known(_) => None,
            }
        })
    }

    /// The steps that the terms of all links cost in an order.
    pub(super) fn steps_of_links(&self, order: u32) -> u64 {
        self.cylinders.iter().fold(0, |steps, cylinder| match &cylinder.rod {
            RodStatement::Link(link) => link.steps(order).saturating_add(steps),
            RodStatement::Unknown | RodStatement::Known(_) => steps,
        })
    }
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
            true => vec![Group { coefficient: Coefficient::One, is_zero: false, sources: Vec::new() }],
        }
    }
}
