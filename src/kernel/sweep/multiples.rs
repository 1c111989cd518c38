//! What are the multiples of a sweep counted in? In the m and r of its first point, whatever the others have: only so can points be compared.

use num_rational::BigRational;
use num_traits::One;

use super::firing::StarLength;
use super::swept_engine::SweptEngine;
use crate::engine::Engine;
use crate::numbers;

/// The mass and the crank radius that multiples are counted in.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Multiples {
    /// m in kilograms; none where the engine does not say.
    pub mass: Option<BigRational>,
    /// r in metres; none where the engine does not say.
    pub radius: Option<BigRational>,
}

impl Multiples {
    /// Those that an engine by itself is counted in.
    pub(super) fn of(engine: &Engine) -> Self {
        let dimensions = engine.dimensions();
        Multiples {
            mass: dimensions.mass.as_ref().map(|_| engine.unit_mass()),
            radius: dimensions.crank_radius.clone(),
        }
    }

    /// Counts a point in these that is counted in its own.
    pub(super) fn count(&self, point: &mut SweptEngine, own: &Self) {
        let radii = self.radii(own);
        let factor = radii * ratio(&own.mass, &self.mass);
        for order in &mut point.orders {
            order.force.scale(factor);
            order.moment.scale(factor);
        }
        point.newtons = point.newtons.map(|newtons| newtons / factor);
        point.counterweight = point.counterweight.map(|part| part.times(factor));
        point.kilograms = point.kilograms.map(|kilograms| kilograms / factor);
        if let Some(envelope) = &mut point.envelope {
            envelope.length = envelope.length.map(|length| length * radii);
            envelope.breadth *= radii;
            envelope.height *= radii;
            envelope.metres = envelope.metres.map(|metres| metres / radii);
        }
    }

    /// Counts firing stars in these that are counted in their own.
    pub(super) fn count_stars(&self, stars: &mut [StarLength], own: &Self) {
        let radii = self.radii(own);
        for star in stars {
            if let StarLength::Of(amplitude) = star {
                *amplitude = amplitude.times(radii);
            }
        }
    }

    /// How many of these crank radii are one of the others.
    fn radii(&self, own: &Self) -> f64 {
        ratio(&own.radius, &self.radius)
    }
}

/// How many of one unit another is; exactly 1 where both are alike, so that no decimal of theirs is rounded.
fn ratio(own: &Option<BigRational>, unit: &Option<BigRational>) -> f64 {
    let known = own.as_ref().zip(unit.as_ref());
    numbers::float(&known.map_or_else(BigRational::one, |(own, unit)| own / unit))
}
