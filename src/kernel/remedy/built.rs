//! What is in the planes of a remedy when it is built? What the file has there, resized, and what is new.
//!
//! The weights of a remedy are what is added to an engine. Where the engine has weights on the same shaft in the same plane they
//! are resized, so that no weight is added beside another that it cancels again.

use super::Remedy;
use super::comparable_engine::ComparableEngine;
use super::planes::{Replaced, there};
use super::shafts::Shaft;
use super::weight::Weight;

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

impl Remedy {
    /// The plane of a weight of the remedy.
    fn built_of(&self, weight: &Weight) -> Option<&Built> {
        self.built.iter().find(|plane| is_with(&plane.becomes, weight))
    }

    /// A weight of the remedy as it is built: itself, or what one that is there becomes; none where that is taken away. What a balance
    /// factor asks for takes the place of what is there, and what cancels the rest in the same plane is told by itself.
    pub fn as_built(&self, weight: &Weight) -> Option<Weight> {
        let Some(plane) = self.built_of(weight).filter(|plane| plane.is_resized()) else { return Some(weight.clone()) };
        let shown = match self.bays.iter().find(|bay| is_with(bay, weight)) {
            Some(bay) if bay == weight => Weight { vector: plane.was.vector.plus(&bay.vector), ..plane.was.clone() },
            Some(_) => weight.clone(),
            None => plane.becomes.clone(),
        };
        (!shown.vector.vanishes()).then_some(shown)
    }

    /// Whether any of these weights is there when the remedy is built: those of a shaft that is not needed are taken away.
    pub fn stays(&self, weights: &[Weight]) -> bool {
        weights.iter().any(|weight| self.as_built(weight).is_some())
    }

    /// The balancer shafts that the remedy leaves the engine with at its orders.
    pub fn shafts_built(&self) -> impl Iterator<Item = &Shaft> {
        self.shafts.iter().filter(|shaft| self.stays(&shaft.weights))
    }

    /// Whether the engine has a weight where this one belongs, which is resized.
    pub fn resizes(&self, weight: &Weight) -> bool {
        self.built_of(weight).is_some_and(Built::is_resized)
    }

    /// Whether counterweights of the engine are resized, or taken away.
    pub fn changes_counterweights(&self) -> bool {
        let of_the_file = |plane: &Built| plane.becomes.is_on_the_crank() && !plane.replaced.counterweights.is_empty();
        self.built.iter().any(of_the_file)
    }

    /// The planes in which weights of the engine are resized.
    pub fn resized(&self) -> impl Iterator<Item = &Built> {
        self.built.iter().filter(|plane| plane.is_resized())
    }
}

/// Whether two weights are on one shaft in one plane.
fn is_with(one: &Weight, other: &Weight) -> bool {
    (one.order, one.sense, &one.position) == (other.order, other.sense, &other.position)
}
