//! What is in the planes of a remedy when it is built? What the file has there, resized, and what is new.
//!
//! The weights of a remedy are what is added to an engine. Where the engine has weights on the same shaft in the same plane they
//! are resized, so that no weight is added beside another that it cancels again.

use super::Remedy;
use super::planes::{Built, is_with};
use super::shafts::Shaft;
use super::weight::Weight;
use crate::engine::ShaftAxis;

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

    /// The axes of what a shaft of the remedy resizes, each once: weights that the file has on several axes are as many shafts.
    pub fn axes(&self, shaft: &Shaft) -> Vec<&ShaftAxis> {
        let there = &self.subject.engine().crankshaft().balancers;
        let replaced =
            shaft.weights.iter().filter_map(|weight| self.built_of(weight)).flat_map(|plane| &plane.replaced.balancers);
        let mut axes: Vec<&ShaftAxis> = Vec::new();
        for axis in replaced.filter_map(|index| there[*index].axis.as_ref()) {
            if !axes.contains(&axis) {
                axes.push(axis);
            }
        }
        axes
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
