//! What has an engine in the planes of a remedy already, and what becomes of it?

use num_rational::BigRational;
use num_traits::{Signed, Zero};

use super::comparable_engine::ComparableEngine;
use super::error::RemedyError;
use super::weight::Weight;
use crate::engine::{Balancer, Engine, LengthUnit, throws};
use crate::exact::Term;
use crate::file::{parse_length, parse_number, shown_position};
use crate::order::{self, OrderSum, Source, TurningMass};
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

impl Built {
    /// Whether something is there in the engine as it is.
    pub fn is_resized(&self) -> bool {
        !self.replaced.counterweights.is_empty() || !self.replaced.balancers.is_empty()
    }
}

/// Weights of an engine by their indices.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Replaced {
    /// Counterweights.
    pub counterweights: Vec<usize>,
    /// Balancer shafts.
    pub balancers: Vec<usize>,
}

/// The weights of an engine that turn so and that a remedy resizes, each with its position.
fn turning_so(engine: &Engine, order: u32, sense: Sense) -> Vec<TurningMass> {
    let is_of_a_remedy = |source: Source| match source {
        // Those of other crankshafts are none of the reference one.
        Source::Counterweight(index) => {
            (order, sense) == (1, Sense::Direct) && engine.crankshaft().counterweights[index].crank == 0
        }
        Source::Balancer(index) => is_resized(&engine.crankshaft().balancers[index]),
        _ => false,
    };
    let turning = order::turning_masses(engine).into_iter();
    let so = turning.filter(|mass| (mass.order, mass.sense) == (order, sense) && mass.factor.exists(order));
    so.filter(|mass| is_of_a_remedy(mass.source)).collect()
}

/// Whether a remedy resizes a shaft: what is asked of the crankshaft is done by its counterweights, and one that turns as it does stays as it
/// is, on its own axis. But against the part that an offset makes of order 1, a coefficient, a remedy has such a shaft itself.
fn is_resized(shaft: &Balancer) -> bool {
    (shaft.order, shaft.sense) != (1, Sense::Direct) || shaft.coefficient_of.is_some()
}

/// The weights on a shaft in one plane that have no mass yet: a file keeps a place by them, and what is found takes it.
fn without_mass(engine: &Engine, order: u32, sense: Sense, position: &BigRational) -> Replaced {
    let crankshaft = engine.crankshaft();
    let counterweights = (crankshaft.counterweights.iter().enumerate())
        .filter(|_| (order, sense) == (1, Sense::Direct))
        .filter(|(_, weight)| weight.crank == 0 && weight.position == *position && weight.mass_radius().is_zero());
    let balancers = (crankshaft.balancers.iter().enumerate())
        .filter(|(_, shaft)| (shaft.order, shaft.sense, &shaft.position) == (order, sense, position))
        .filter(|(_, shaft)| is_resized(shaft) && shaft.mass_radius.is_zero());
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

/// What is in each plane in which a remedy has these weights, each plane once.
pub(super) fn built(subject: &ComparableEngine, weights: Vec<Weight>) -> Vec<Built> {
    let mut planes: Vec<Built> = Vec::new();
    for weight in weights {
        match planes.iter_mut().find(|plane| is_with(&plane.becomes, &weight)) {
            Some(plane) => plane.becomes.vector = plane.becomes.vector.plus(&weight.vector),
            None => {
                let (replaced, there) = there(subject, weight.order, weight.sense, &weight.position);
                let becomes = Weight { vector: there.plus(&weight.vector), ..weight.clone() };
                planes.push(Built { replaced, was: Weight { vector: there, ..weight }, becomes });
            }
        }
    }
    planes
}

/// Whether two weights are on one shaft in one plane.
pub(super) fn is_with(one: &Weight, other: &Weight) -> bool {
    (one.order, one.sense, &one.position) == (other.order, other.sense, &other.position)
}

/// The planes in which the engine has weights that turn so, rising.
pub(super) fn planes(subject: &ComparableEngine, order: u32, sense: Sense) -> Vec<BigRational> {
    let turning = turning_so(subject.engine(), order, sense);
    let mut planes: Vec<BigRational> = turning.into_iter().map(|mass| mass.position).collect();
    planes.sort();
    planes.dedup();
    planes
}

/// Less what is on the crankshaft in their planes.
///
/// # Errors
/// What is on it in another plane, and would stay.
pub(super) fn in_place_of_what_is_there(
    subject: &ComparableEngine,
    weights: Vec<Weight>,
) -> Result<Vec<Weight>, RemedyError> {
    let takes = |plane: &BigRational| weights.iter().any(|weight| weight.position == *plane);
    if let Some(plane) = planes(subject, 1, Sense::Direct).into_iter().find(|plane| !takes(plane)) {
        return Err(RemedyError::Weighted(shown_position(&plane, subject.engine().length_unit())));
    }
    let less = |weight: Weight| {
        let (_, there) = there(subject, weight.order, weight.sense, &weight.position);
        Weight { vector: weight.vector.minus(&there), ..weight }
    };
    Ok(weights.into_iter().map(less).filter(|weight| !weight.vector.vanishes()).collect())
}

/// The planes of the outermost throws; of the outermost cylinders or weights where those stand together.
pub(super) fn usual_planes(engine: &Engine) -> [BigRational; 2] {
    let throws: Vec<BigRational> = throws(engine).into_iter().map(|throw| throw.position).collect();
    let cylinders: Vec<BigRational> = engine.cylinders().iter().map(|cylinder| cylinder.position.clone()).collect();
    let apart = |[low, high]: &[BigRational; 2]| low != high;
    let found = [throws, cylinders, everywhere(engine)].iter().find_map(|list| outermost(list).filter(apart));
    // Where all is in one plane, no couple is left that planes would be needed for.
    let one = BigRational::from_integer(1.into());
    let [low, high] = found.unwrap_or_else(|| [engine.reference_plane() - &one, engine.reference_plane() + &one]);
    [high, low]
}

/// The ends of the engine along its crankshaft, between which its weights are: those of the shaft where they are known, else the outermost
/// cylinders and weights.
pub(super) fn ends(engine: &Engine) -> [BigRational; 2] {
    let plane = engine.reference_plane();
    let found = engine.shaft_ends().or_else(|| outermost(&everywhere(engine)));
    found.unwrap_or_else(|| [plane.clone(), plane.clone()])
}

/// The places of all cylinders, counterweights and balancer shafts.
fn everywhere(engine: &Engine) -> Vec<BigRational> {
    let crankshaft = engine.crankshaft();
    let cylinders = engine.cylinders().iter().map(|cylinder| &cylinder.position);
    let weights = crankshaft.counterweights.iter().map(|weight| &weight.position);
    let shafts = crankshaft.balancers.iter().map(|shaft| &shaft.position);
    cylinders.chain(weights).chain(shafts).cloned().collect()
}

fn outermost(list: &[BigRational]) -> Option<[BigRational; 2]> {
    Some([list.iter().min()?.clone(), list.iter().max()?.clone()])
}

/// A position that is asked for, in the unit of the engine.
///
/// # Errors
/// What would be right.
pub fn plane_of(engine: &Engine, text: &str) -> Result<BigRational, String> {
    match parse_length(text)? {
        (_, LengthUnit::Metre) if !engine.positions_given() => {
            Err("the cylinders are one spacing apart, and positions count in spacings".to_owned())
        }
        (position, _) => Ok(position),
    }
}

/// A balance factor that is asked for.
///
/// # Errors
/// What would be right.
pub fn factor_of(text: &str) -> Result<BigRational, String> {
    let value = parse_number(text).map_err(|error| error.to_string())?;
    if value.is_negative() { Err("a balance factor is 0 or more".to_owned()) } else { Ok(value) }
}
