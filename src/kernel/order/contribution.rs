//! Which term does each source add to an order, and what is it multiplied by?

use num_rational::BigRational;
use num_traits::One;

use super::factor::Factor;
use super::link;
use super::masses::MassGroup;
use super::phase::{phase, phase_of};
use super::source::Source;
use super::sum::OrderSum;
use super::turning::{TurningMass, mass_radius, turning_masses};
use crate::engine::{Cylinder, Engine};
use crate::exact::{PhasorSum, Term, Turn, fraction};
use crate::proof::{Masses, Planar, Quantity, Sense};

/// The term that a source adds to an order.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Contribution {
    /// Whose it is.
    pub source: Source,
    /// Where the force acts along the crankshaft.
    pub position: BigRational,
    /// What the term is multiplied by.
    pub factor: Factor,
    /// The term, in multiples of m r.
    pub term: Term,
}

impl Contribution {
    /// The term of a quantity: of the moment that of the force times the arm.
    pub(super) fn term_of(&self, engine: &Engine, quantity: Quantity) -> Term {
        match quantity {
            Quantity::FORCE | Quantity::Axial(_) => self.term.clone(),
            Quantity::MOMENT => self.weighed(|position| lever(engine, Planar::Moment, position)).1,
        }
    }

    /// The term with its factor, the force weighed by its position: 1 for the force, the arm for the moment, the part that a
    /// bearing carries.
    pub fn weighed(&self, weighing: impl Fn(&BigRational) -> BigRational) -> (Factor, Term) {
        let weight = fraction::times(&self.term.weight, &weighing(&self.position));
        (self.factor.clone(), Term { angle: self.term.angle.clone(), weight })
    }
}

/// The sources of an engine that sums are about: all, or those of some masses.
#[derive(Clone, Debug)]
pub struct Sources<'a> {
    engine: &'a Engine,
    masses: Masses,
    turning: Vec<TurningMass>,
    /// The crankshaft that they are on, where they are those of one.
    crank: Option<usize>,
}

impl<'a> Sources<'a> {
    /// The sources of these masses.
    pub fn new(engine: &'a Engine, masses: Masses) -> Self {
        let turning = match masses {
            Masses::Reciprocating => Vec::new(),
            Masses::Rotating | Masses::Counterweights | Masses::All => turning_masses(engine),
        };
        let turning = turning.into_iter().filter(|mass| mass.source.group().is_among(masses)).collect();
        Sources { engine, masses, turning, crank: None }
    }

    /// Those that are on one of several crankshafts, by its index, or on the only one. Balancer shafts are counted to one that is alone.
    pub(super) fn of_crankshaft(mut self, crank: usize) -> Self {
        let is_alone = self.engine.crankshafts() == 1;
        self.turning.retain(|mass| is_alone || mass.crank == Some(crank));
        self.crank = Some(crank);
        self
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

    /// What each source adds to the force of one order and sense, be its factor zero or not: a term per cylinder, several where its
    /// rod is a link, then those of the masses at knuckle pins and of the masses that turn so.
    ///
    /// A new kind of source has its terms here.
    pub fn of_force(&self, order: u32, sense: Sense) -> impl Iterator<Item = Contribution> {
        let pistons = self.cylinders_with(order).flat_map(move |(index, cylinder, own)| {
            let weight = geared(mass_radius(self.engine, cylinder), self.engine.speed_of(cylinder), 2);
            let at = phase(cylinder, own, Some(sense));
            let parts = Factor::parts_of_force(self.engine, cylinder.mechanism.as_ref(), own).into_iter();
            parts.map(move |(factor, part)| Contribution {
                source: Source::Piston(index),
                position: cylinder.position.clone(),
                factor: factor.geared(self.engine.speed_of(cylinder)),
                term: turned(&at, &weight, &part, sense),
            })
        });
        pistons.chain(self.of_knuckles(order, sense)).chain(self.of_turning(order, sense))
    }

    /// What the masses at knuckle pins add on the piston pins of their master rods.
    fn of_knuckles(&self, order: u32, sense: Sense) -> impl Iterator<Item = Contribution> {
        let knuckles = self.cylinders().filter_map(|(index, own)| Some((index, own, link::knuckle(own)?)));
        knuckles.map(move |(index, cylinder, (link, weight))| {
            let (factor, _) = Factor::of_rod(Some(&link.master_rod()), order);
            let at = phase_of(&cylinder.throw, &link::master_bank(cylinder, link), order, Some(sense));
            Contribution {
                source: Source::Knuckle(index),
                position: cylinder.position.clone(),
                factor,
                // A complex mass: it is turned the same way in both senses.
                term: Term { angle: &at + &link.knuckle_angle(), weight: weight * &link.knuckle },
            }
        })
    }

    /// What the masses that turn add to it.
    pub fn of_turning(&self, order: u32, sense: Sense) -> impl Iterator<Item = Contribution> {
        let turning = self.turning.iter().filter(move |mass| (mass.order, mass.sense) == (order, sense));
        turning.map(|mass| Contribution {
            source: mass.source,
            position: mass.position.clone(),
            factor: mass.factor.clone(),
            term: Term { angle: mass.angle.clone(), weight: mass.weight() },
        })
    }

    /// What each source adds to the inertia torque of one order, in multiples of m r²; what turns at constant speed adds
    /// nothing. A crank that turns ν times as fast has ν times its torque at the reference one.
    pub fn of_torque(&self, order: u32) -> impl Iterator<Item = Contribution> {
        self.cylinders_with(order).map(move |(index, cylinder, own)| {
            let speed = self.engine.speed_of(cylinder);
            let mass_radius = mass_radius(self.engine, cylinder);
            let weight = geared(fraction::times(&mass_radius, &cylinder.crank_radius), speed, 3);
            Contribution {
                source: Source::Piston(index),
                position: cylinder.position.clone(),
                factor: Factor::of_torque(cylinder.mechanism.as_ref()).geared(speed),
                term: Term { angle: phase(cylinder, own, None), weight },
            }
        })
    }

    /// The terms of a quantity with what they are multiplied by.
    pub fn terms(&self, quantity: Quantity, order: u32, sense: Option<Sense>) -> Vec<(Source, Factor, Term)> {
        let term = |one: Contribution| {
            let term = one.term_of(self.engine, quantity);
            (one.source, one.factor, term)
        };
        match (sense, quantity) {
            (Some(sense), _) => self.of_force(order, sense).map(term).collect(),
            (None, Quantity::ROLL) => self.of_roll(order).into_iter().map(term).collect(),
            (None, _) => self.of_torque(order).map(term).collect(),
        }
    }

    pub(super) fn cylinders(&self) -> impl Iterator<Item = (usize, &'a Cylinder)> {
        let has_pistons = MassGroup::Reciprocating.is_among(self.masses);
        let is_on_it = move |cylinder: &Cylinder| self.crank.is_none_or(|crank| cylinder.crank == crank);
        self.engine.cylinders().iter().enumerate().filter(move |(_, cylinder)| has_pistons && is_on_it(cylinder))
    }

    /// Those whose crank has part in an order, each with the order of its own motion that this is.
    pub(super) fn cylinders_with(&self, order: u32) -> impl Iterator<Item = (usize, &'a Cylinder, u32)> {
        let engine = self.engine;
        self.cylinders()
            .filter_map(move |(index, cylinder)| engine.own_order(cylinder, order).map(|own| (index, cylinder, own)))
    }
}

/// How much larger what a crank does is for its speed: a force for the square of it, a torque at the reference crank for the cube.
pub fn power(speed: u32, exponent: usize) -> BigRational {
    num_traits::pow(BigRational::from_integer(speed.into()), exponent)
}

/// What a crank of this speed does, from what one at the reference speed would do.
pub(super) fn geared(part: BigRational, speed: u32, exponent: usize) -> BigRational {
    if speed == 1 { part } else { part * power(speed, exponent) }
}

/// A part of a vector: turned by its angle in the direct star, the other way in the reverse one.
fn turned(at: &Turn, weight: &BigRational, part: &Term, sense: Sense) -> Term {
    // Every point of a sweep comes here: no angle is copied to be negated.
    let angle = match sense {
        Sense::Direct => at + &part.angle,
        Sense::Reverse => at - &part.angle,
    };
    Term { angle, weight: fraction::times(weight, &part.weight) }
}

/// What every mass of an engine adds to the force of one order and sense, where its factor is not zero.
pub fn contributions(engine: &Engine, order: u32, sense: Sense) -> Vec<Contribution> {
    there(&Sources::new(engine, Masses::All), order, sense)
}

/// What one of several crankshafts, or the only one, adds to it: its pistons and what turns with it.
pub fn crankshaft_contributions(engine: &Engine, crank: usize, order: u32, sense: Sense) -> Vec<Contribution> {
    there(&Sources::new(engine, Masses::All).of_crankshaft(crank), order, sense)
}

fn there(sources: &Sources, order: u32, sense: Sense) -> Vec<Contribution> {
    sources.of_force(order, sense).filter(|one| one.factor.exists(order)).collect()
}

/// What a force at this position counts for: 1 in the force, its arm about the reference plane in the moment.
pub fn lever(engine: &Engine, quantity: Planar, position: &BigRational) -> BigRational {
    match quantity {
        Planar::Force => BigRational::one(),
        Planar::Moment => fraction::minus(position, engine.reference_plane()),
    }
}

/// One order and sense of the force or the moment of all masses.
pub fn all_masses(engine: &Engine, quantity: Planar, order: u32, sense: Sense) -> OrderSum {
    sum_of(&Sources::new(engine, Masses::All), quantity.into(), order, Some(sense))
}

/// The inertia torque of one order: `Σ m r² e^{ik(β−α)}` before t_k of each mechanism, in multiples of m r².
pub fn torque(engine: &Engine, order: u32) -> OrderSum {
    sum_of(&Sources::new(engine, Masses::Reciprocating), Quantity::TORQUE, order, None)
}

fn sum_of(sources: &Sources, quantity: Quantity, order: u32, sense: Option<Sense>) -> OrderSum {
    let terms = sources.terms(quantity, order, sense).into_iter();
    OrderSum::new(terms.filter(|(_, factor, _)| factor.exists(order)).map(|(_, factor, term)| (factor, term)))
}

/// The roll moment of one order of all masses on the frame, in multiples of m r².
pub fn roll(engine: &Engine, order: u32) -> OrderSum {
    sum_of(&Sources::new(engine, Masses::All), Quantity::ROLL, order, None)
}

/// The vector star of the pistons: the sum of one quantity, order and sense, one term per cylinder.
///
/// Masses and crank radii are in multiples of the engine's; its coefficient c_k and the factor ½ω² are omitted.
pub fn star(engine: &Engine, quantity: impl Into<Quantity>, order: u32, sense: Option<Sense>) -> PhasorSum {
    let terms = Sources::new(engine, Masses::Reciprocating).terms(quantity.into(), order, sense);
    PhasorSum::new(terms.into_iter().map(|(_, _, term)| term).collect())
}

/// The groups of masses that an engine has: the reciprocating ones, and those that weigh something.
pub fn groups_of(engine: &Engine) -> Vec<MassGroup> {
    let mut groups: Vec<MassGroup> = turning_masses(engine).into_iter().map(|mass| mass.source.group()).collect();
    groups.push(MassGroup::Reciprocating);
    groups.sort_unstable();
    groups.dedup();
    groups
}

/// The masses of an engine as it is built: all, or the reciprocating ones where it has no others.
pub fn masses_as_built(engine: &Engine) -> Masses {
    if groups_of(engine).len() > 1 { Masses::All } else { Masses::Reciprocating }
}
