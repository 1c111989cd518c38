//! Which terms of an order stand before one number?

use super::factor::Factor;
use super::masses::Masses;
use super::source::{Source, lever, piston_term};
use super::turning::{TurningMass, turning_masses};
use crate::engine::Engine;
use crate::exact::{PhasorSum, Term};
use crate::proof::{Quantity, Sense};

/// The sources of an order whose terms stand before one number.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Group {
    /// The number.
    pub factor: Factor,
    /// Whether it is not zero; else the terms add nothing, whatever their sum is.
    pub exists: bool,
    /// The sources: cylinders first, then the masses that turn at this order, in either sense.
    pub sources: Vec<Source>,
}

/// The engine and those of its masses that sums are about.
#[derive(Clone, Debug)]
pub struct Sources<'a> {
    engine: &'a Engine,
    masses: Masses,
    turning: Vec<TurningMass>,
}

impl<'a> Sources<'a> {
    /// The sources of these masses.
    pub fn new(engine: &'a Engine, masses: Masses) -> Self {
        let mut turning = turning_masses(engine);
        turning.retain(|mass| masses.include(mass.source.group()));
        Sources { engine, masses, turning }
    }

    /// The engine.
    pub fn engine(&self) -> &'a Engine {
        self.engine
    }

    /// Whose they are.
    pub fn masses(&self) -> Masses {
        self.masses
    }

    /// The masses among them that turn.
    pub fn turning(&self) -> &[TurningMass] {
        &self.turning
    }

    /// The groups of an order, in the order of their first source; one without sources where nothing has the order.
    pub fn groups(&self, quantity: Quantity, order: u32) -> Vec<Group> {
        let has_pistons = self.masses.include(Source::Piston(0).group());
        let cylinders = self.engine.cylinders().iter().enumerate().filter(|_| has_pistons);
        let pistons = cylinders.map(|(index, cylinder)| {
            let mechanism = cylinder.mechanism.as_ref();
            let factor = match quantity {
                Quantity::Force | Quantity::Moment => Factor::of_force(mechanism, order).0,
                Quantity::Torque => Factor::of_torque(mechanism),
            };
            (factor, Source::Piston(index))
        });
        let turning = self.turning.iter().filter(|mass| mass.order == order && quantity != Quantity::Torque);
        let turning = turning.map(|mass| (Factor::One, mass.source));
        let mut groups: Vec<Group> = Vec::new();
        for (factor, source) in pistons.chain(turning) {
            match groups.iter_mut().find(|group| group.factor == factor) {
                Some(group) => group.sources.push(source),
                None => {
                    let exists = factor.exists(quantity, order);
                    groups.push(Group { factor, exists, sources: vec![source] });
                }
            }
        }
        if groups.is_empty() {
            groups.push(Group { factor: Factor::One, exists: false, sources: Vec::new() });
        }
        groups
    }

    /// The sum of a group, one term per source, and whose terms they are.
    pub fn sum(&self, group: &Group, quantity: Quantity, order: u32, sense: Option<Sense>) -> (Vec<Source>, PhasorSum) {
        let engine = self.engine;
        let term = |source: &Source| match *source {
            Source::Piston(index) => {
                let cylinder = &engine.cylinders()[index];
                let Term { angle, weight } = piston_term(engine, cylinder, order, sense);
                let by = match quantity {
                    Quantity::Force | Quantity::Moment => lever(engine, quantity, &cylinder.position),
                    Quantity::Torque => cylinder.crank_radius.clone(),
                };
                Some((*source, Term { angle, weight: weight * by }))
            }
            turning => {
                let mass = self.turning.iter().find(|mass| mass.source == turning && Some(mass.sense) == sense)?;
                let weight = mass.weight() * lever(engine, quantity, &mass.position);
                Some((*source, Term { angle: mass.angle.clone(), weight }))
            }
        };
        let (sources, terms): (Vec<Source>, Vec<Term>) = group.sources.iter().filter_map(term).unzip();
        (sources, PhasorSum::new(terms))
    }
}
