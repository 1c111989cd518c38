//! Who makes a force of this order, and which term is it in its sum?

use num_rational::BigRational;
use num_traits::One;

use super::factor::Factor;
use super::masses::MassGroup;
use super::phase::phase;
use super::sum::OrderSum;
use super::turning::{mass_radius, turning_masses};
use crate::engine::{Cylinder, Engine};
use crate::exact::{PhasorSum, Term};
use crate::proof::{Quantity, Sense};

/// What makes a force; by its index in the layout.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Source {
    /// The reciprocating mass of a cylinder.
    Piston(usize),
    /// The rotating mass of a cylinder's rod.
    BigEnd(usize),
    /// The pin of a throw.
    Pin(usize),
    /// Both webs of a throw.
    Webs(usize),
    /// A counterweight.
    Counterweight(usize),
    /// A balancer shaft.
    Balancer(usize),
}

impl Source {
    /// The group that it belongs to.
    pub fn group(self) -> MassGroup {
        match self {
            Source::Piston(_) => MassGroup::Reciprocating,
            Source::BigEnd(_) => MassGroup::Rotating,
            Source::Pin(_) | Source::Webs(_) => MassGroup::Crankshaft,
            Source::Counterweight(_) => MassGroup::Counterweights,
            Source::Balancer(_) => MassGroup::Balancers,
        }
    }

    /// What it is called: a cylinder by its name, what turns by its number from 1.
    pub fn name(self, engine: &Engine) -> String {
        match self {
            Source::Piston(index) => engine.cylinders()[index].name.clone(),
            Source::BigEnd(index) => format!("big end of cylinder {}", engine.cylinders()[index].name),
            Source::Pin(index) => format!("pin {}", index + 1),
            Source::Webs(index) => format!("webs of throw {}", index + 1),
            Source::Counterweight(index) => format!("counterweight {}", index + 1),
            Source::Balancer(index) => format!("balancer shaft {}", index + 1),
        }
    }
}

/// The term that a source adds to the force of an order.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Contribution {
    /// Whose it is.
    pub source: Source,
    /// Where the force acts along the crankshaft.
    pub position: BigRational,
    /// What the term stands before.
    pub factor: Factor,
    /// The term, in multiples of m r.
    pub term: Term,
}

impl Contribution {
    /// The term with its factor, the force weighed by its position: 1 for the force, the arm for the moment, the part that a
    /// bearing carries.
    pub fn weighed(&self, weighing: impl Fn(&BigRational) -> BigRational) -> (Factor, Term) {
        let weight = &self.term.weight * weighing(&self.position);
        (self.factor.clone(), Term { angle: self.term.angle.clone(), weight })
    }
}

/// The term of a piston in the star of an order: direct, reverse, or the torque's (none), in multiples of m r.
pub(super) fn piston_term(engine: &Engine, cylinder: &Cylinder, order: u32, sense: Option<Sense>) -> Term {
    let weight = mass_radius(engine, cylinder);
    let weight = match sense {
        Some(_) => weight * Factor::of_force(cylinder.mechanism.as_ref(), order).1,
        None => weight,
    };
    Term { angle: phase(cylinder, order, sense), weight }
}

/// What every mass of an engine adds to the force of one order and sense: a term per cylinder, where the order exists for
/// its rod, then those of the masses that turn at this order.
pub fn contributions(engine: &Engine, order: u32, sense: Sense) -> Vec<Contribution> {
    let piston = |(index, cylinder): (usize, &Cylinder)| {
        let (factor, _) = Factor::of_force(cylinder.mechanism.as_ref(), order);
        let term = piston_term(engine, cylinder, order, Some(sense));
        factor.exists(Quantity::Force, order).then(|| Contribution {
            source: Source::Piston(index),
            position: cylinder.position.clone(),
            factor,
            term,
        })
    };
    let pistons = engine.cylinders().iter().enumerate().filter_map(piston);
    let turning = turning_masses(engine).into_iter().filter(|mass| (mass.order, mass.sense) == (order, sense));
    let turning = turning.map(|mass| Contribution {
        source: mass.source,
        factor: Factor::One,
        term: Term { weight: mass.weight(), angle: mass.angle },
        position: mass.position,
    });
    pistons.chain(turning).collect()
}

/// What a force at this position counts for: 1 in the force, its arm about the reference plane in the moment.
///
/// # Panics
/// For the torque, which no position enters.
pub fn lever(engine: &Engine, quantity: Quantity, position: &BigRational) -> BigRational {
    match quantity {
        Quantity::Force => BigRational::one(),
        Quantity::Moment => position - engine.reference_plane(),
        Quantity::Torque => unreachable!("the torque has sums of its own"),
    }
}

/// One order and sense of the force or the moment of all masses.
pub fn all_masses(engine: &Engine, quantity: Quantity, order: u32, sense: Sense) -> OrderSum {
    let contributions = contributions(engine, order, sense);
    OrderSum::new(contributions.iter().map(|one| one.weighed(|position| lever(engine, quantity, position))))
}

/// The groups of masses that an engine has: the reciprocating ones, and those that weigh something.
pub fn groups_of(engine: &Engine) -> Vec<MassGroup> {
    let mut groups: Vec<MassGroup> = turning_masses(engine).into_iter().map(|mass| mass.source.group()).collect();
    groups.push(MassGroup::Reciprocating);
    groups.sort_unstable();
    groups.dedup();
    groups
}

/// The vector star of the pistons: the sum of one quantity, order and sense, one term per cylinder.
///
/// Masses and crank radii are in multiples of the layout's; its coefficient c_k and the factor ½ω² are left out.
pub fn star(engine: &Engine, quantity: Quantity, order: u32, sense: Option<Sense>) -> PhasorSum {
    let term = |cylinder: &Cylinder| {
        let by = match quantity {
            Quantity::Force | Quantity::Moment => lever(engine, quantity, &cylinder.position),
            Quantity::Torque => cylinder.crank_radius.clone(),
        };
        let Term { angle, weight } = piston_term(engine, cylinder, order, sense);
        Term { angle, weight: weight * by }
    };
    PhasorSum::new(engine.cylinders().iter().map(term).collect())
}
