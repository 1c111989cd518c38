//! What is in the planes of a remedy when it is built? What the file has there, resized, and what is new.
//!
//! The weights of a remedy are what is added to an engine. Where the engine has weights on the same shaft in the same plane they
//! are resized, so that no weight is added beside another that it cancels again.

use num_rational::BigRational;
use num_traits::{Signed, Zero};

use super::comparable_engine::ComparableEngine;
use super::weight::Weight;
use super::{Remedy, Shaft};
use crate::engine::Engine;
use crate::exact::Term;
use crate::order::{self, MassGroup, OrderSum, Source, TurningMass};
use crate::proof::Sense;

/// A plane of a shaft, or of the crankshaft, in which a remedy has weights.
#[derive(Clone, Debug, PartialEq)]
pub struct Built {
    /// What is there in the engine as it is, by index among its counterweights and its balancer shafts.
    pub replaced: Replaced,
    /// Its mass-radius in the engine as it is; zero where nothing is there.
    pub was: Weight,
    /// That in the corrected engine; zero where the weight is taken away.
    pub becomes: Weight,
}

/// Weights of an engine by their indices.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Replaced {
    /// Counterweights.
    pub counterweights: Vec<usize>,
    /// Balancer shafts.
    pub balancers: Vec<usize>,
}

impl Built {
    /// Whether something is there in the engine as it is.
    pub fn is_resized(&self) -> bool {
        !self.replaced.counterweights.is_empty() || !self.replaced.balancers.is_empty()
    }
}

impl Remedy {
    /// What is in each plane in which the remedy has weights, each plane once.
    pub fn built(&self) -> Vec<Built> {
        let mut planes: Vec<Built> = Vec::new();
        for weight in self.weights() {
            match planes.iter_mut().find(|plane| is_with(&plane.becomes, &weight)) {
                Some(plane) => plane.becomes.vector = plane.becomes.vector.plus(&weight.vector),
                None => {
                    let (replaced, there) = there(&self.subject, weight.order, weight.sense, &weight.position);
                    let becomes = Weight { vector: there.plus(&weight.vector), ..weight.clone() };
                    planes.push(Built { replaced, was: Weight { vector: there, ..weight }, becomes });
                }
            }
        }
        planes
    }

    /// The plane of a weight of the remedy.
    pub fn built_of(&self, weight: &Weight) -> Option<Built> {
        self.built().into_iter().find(|plane| is_with(&plane.becomes, weight))
    }

    /// A weight of the remedy as it is built: itself, or what one that is there becomes; none where that is taken away.
    pub fn as_built(&self, weight: &Weight) -> Option<Weight> {
        match self.built_of(weight).filter(Built::is_resized) {
            None => Some(weight.clone()),
            Some(plane) => (!plane.becomes.vector.vanishes()).then_some(plane.becomes),
        }
    }

    /// The planes in which weights of the engine are resized.
    pub fn resized(&self) -> Vec<Built> {
        self.built().into_iter().filter(Built::is_resized).collect()
    }
}

/// Whether two weights are on one shaft in one plane.
fn is_with(one: &Weight, other: &Weight) -> bool {
    (one.order, one.sense, &one.position) == (other.order, other.sense, &other.position)
}

/// The weights of an engine that turn so, each with its position: what is asked of the crankshaft is done by its counterweights, and by
/// shafts that turn as it does.
fn turning_so(engine: &Engine, order: u32, sense: Sense) -> Vec<TurningMass> {
    let is_of_a_remedy = |source: Source| match (source, source.group()) {
        // Those of other crankshafts are none of the reference one.
        (Source::Counterweight(index), _) => {
            (order, sense) == (1, Sense::Direct) && engine.crankshaft().counterweights[index].crank == 0
        }
        (_, group) => group == MassGroup::Balancers,
    };
    let turning = order::turning_masses(engine).into_iter();
    let so = turning.filter(|mass| (mass.order, mass.sense) == (order, sense) && mass.factor.exists(order));
    so.filter(|mass| is_of_a_remedy(mass.source)).collect()
}

/// The weights on a shaft in one plane that have no mass yet: a file keeps a place by them, and what is found takes it.
fn without_mass(engine: &Engine, order: u32, sense: Sense, position: &BigRational) -> Replaced {
    let crankshaft = engine.crankshaft();
    let counterweights = (crankshaft.counterweights.iter().enumerate())
        .filter(|_| (order, sense) == (1, Sense::Direct))
        .filter(|(_, weight)| weight.crank == 0 && weight.position == *position && weight.mass_radius().is_zero());
    let balancers = (crankshaft.balancers.iter().enumerate())
        .filter(|(_, shaft)| (shaft.order, shaft.sense, &shaft.position) == (order, sense, position))
        .filter(|(_, shaft)| shaft.mass_radius.is_zero());
    Replaced {
        counterweights: counterweights.map(|(index, _)| index).collect(),
        balancers: balancers.map(|(index, _)| index).collect(),
    }
}

/// What is on a shaft in one plane, and its mass-radius in multiples of m r.
pub(super) fn there(
    subject: &ComparableEngine,
    order: u32,
    sense: Sense,
    position: &BigRational,
) -> (Replaced, OrderSum) {
    let mut replaced = without_mass(subject.engine(), order, sense, position);
    let mut terms = Vec::new();
    let turning = turning_so(subject.engine(), order, sense).into_iter();
    for mass in turning.filter(|mass| mass.position == *position) {
        if let Source::Counterweight(index) = mass.source {
            replaced.counterweights.push(index);
        }
        if let Source::Balancer(index) = mass.source {
            replaced.balancers.push(index);
        }
        terms.push((mass.factor, Term { angle: mass.angle, weight: mass.mass_radius }));
    }
    (replaced, OrderSum::new(terms))
}

/// The planes in which the engine has weights that turn so, rising.
pub(super) fn planes(subject: &ComparableEngine, order: u32, sense: Sense) -> Vec<BigRational> {
    let turning = turning_so(subject.engine(), order, sense);
    let mut planes: Vec<BigRational> = turning.into_iter().map(|mass| mass.position).collect();
    planes.sort();
    planes.dedup();
    planes
}

/// The planes of weights that are there, in which others than the weights found do the same; none where nothing is there to resize, or
/// what is found is in these planes already.
pub(super) fn resizing(found: &Shaft, there: &[BigRational], usual: &[BigRational; 2]) -> Option<[BigRational; 2]> {
    let (first, last) = (there.first()?, there.last()?);
    if found.weights.iter().all(|weight| there.contains(&weight.position)) {
        return None;
    }
    if first != last {
        return Some([last.clone(), first.clone()]);
    }
    // Beside the only plane that of the usual ones which stands farther off.
    let off = |plane: &BigRational| (plane - first).abs();
    let [one, other] = usual;
    Some([first.clone(), if off(one) >= off(other) { one.clone() } else { other.clone() }])
}

/// Less what is on the crankshaft in their planes.
pub(super) fn in_place_of_what_is_there(subject: &ComparableEngine, weights: Vec<Weight>) -> Vec<Weight> {
    let less = |weight: Weight| {
        let (_, there) = there(subject, weight.order, weight.sense, &weight.position);
        Weight { vector: weight.vector.minus(&there), ..weight }
    };
    weights.into_iter().map(less).filter(|weight| !weight.vector.vanishes()).collect()
}
