//! Which masses make an order, and what do their terms stand before?

use std::collections::BTreeMap;

use num_bigint::BigInt;
use num_rational::BigRational;
use num_traits::One;

use super::coefficient::{Coefficient, Factor};
use super::document::Document;
use super::engine::{Cylinder, Masses, Quantity, Sense, TurningMassClaim};
use super::verdict::{Vector, phase};

/// What makes a force: a cylinder or a mass that turns, with the sign of its term.
pub(super) enum Source<'a> {
    Cylinder(&'a Cylinder, BigRational),
    Turning(&'a TurningMassClaim, BigRational),
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
            let factor = match quantity {
                Quantity::Force | Quantity::Moment => Factor::of_force(&cylinder.rod, order),
                Quantity::Torque => Factor::of_torque(&cylinder.rod, order),
            };
            groups.add(factor.coefficient, factor.is_zero, Source::Cylinder(cylinder, factor.sign));
        }
        let is_there = self.masses.turn() && quantity != Quantity::Torque;
        let turning = self.turning_masses.iter().filter(|mass| is_there && mass.order == order);
        for mass in turning {
            let factor = Factor::of_shaft(mass.coefficient_of.as_ref(), order);
            groups.add(factor.coefficient, factor.is_zero, Source::Turning(mass, factor.sign));
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
        let term = |source: &Source<'_>| match source {
            Source::Cylinder(cylinder, sign) => {
                let radius = &cylinder.crank_radius;
                let by = match quantity {
                    Quantity::Torque => radius.clone(),
                    Quantity::Force | Quantity::Moment => lever(&cylinder.position),
                };
                let weight = &cylinder.reciprocating_mass * radius * by * sign;
                let angle = phase(&cylinder.throw, &cylinder.bank, order, sense);
                Some((cylinder.name.clone(), Vector { angle, weight }))
            }
            Source::Turning(mass, sign) => {
                let twice_the_square = BigRational::from_integer(BigInt::from(order) * order * 2);
                let weight = twice_the_square * &mass.mass_radius * lever(&mass.position) * sign;
                let vector = Vector { angle: mass.angle.clone(), weight };
                (Some(mass.sense) == sense).then(|| (mass.name.clone(), vector))
            }
        };
        group.sources.iter().filter_map(term).collect()
    }
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
