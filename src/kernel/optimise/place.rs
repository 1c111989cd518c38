//! Where may counterweights stand? Where those of the engine do.

use num_rational::BigRational;
use num_traits::Zero;

use crate::engine::{Counterweight, Engine, throws};
use crate::exact::Turn;

/// A plane of the crankshaft with room for a counterweight.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Place {
    /// Position along the crankshaft, in the unit of the engine's positions.
    pub position: BigRational,
    /// Distance of a weight's centre of gravity from the axis, in metres.
    pub radius: BigRational,
    /// The throw that it belongs to, by its index.
    pub throw: Option<usize>,
    /// Which crankshaft it is on, where several are geared together; else 0.
    pub crank: usize,
}

impl Place {
    /// A weight without mass at it. A file knows by the throw which of several crankshafts a weight is on.
    pub(super) fn empty(&self) -> Counterweight {
        Counterweight {
            throw: self.throw.filter(|_| self.crank > 0),
            angle: Turn::zero(),
            mass: BigRational::zero(),
            radius: self.radius.clone(),
            position: self.position.clone(),
            crank: self.crank,
        }
    }
}

/// The places of the engine's counterweights, one per position of a crankshaft, in the order of the file; what they weigh does not matter.
pub fn places(engine: &Engine) -> Vec<Place> {
    let mut places: Vec<Place> = Vec::new();
    for weight in &engine.crankshaft().counterweights {
        if places.iter().all(|place| (&place.position, place.crank) != (&weight.position, weight.crank)) {
            let Counterweight { throw, radius, position, crank, .. } = weight.clone();
            places.push(Place { position, radius, throw, crank });
        }
    }
    places
}

/// The engine with counterweights opposite to each throw, of one balance factor for all: those of a throw share it evenly.
///
/// `None` where a throw has no place for one, or the engine gives no masses.
pub fn uniform(engine: &Engine, factor: &BigRational) -> Option<Engine> {
    let (places, mut weights) = (places(engine), Vec::new());
    for (index, throw) in throws(engine).iter().enumerate() {
        let own: Vec<&Place> = places.iter().filter(|place| place.throw == Some(index)).collect();
        if own.is_empty() {
            return None;
        }
        let each = engine.throw_mass_radii()?.get(index)? * factor / BigRational::from_integer(own.len().into());
        weights.extend(own.into_iter().map(|place| Counterweight {
            throw: place.throw,
            angle: throw.angle.opposite(),
            mass: &each / &place.radius,
            radius: place.radius.clone(),
            position: place.position.clone(),
            crank: throw.crank,
        }));
    }
    engine.with_counterweights(weights).ok()
}
