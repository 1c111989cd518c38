//! What does a crankshaft with these counterweights weigh, what do its bearings feel, and is it balanced?
//!
//! All of it is read from the engine alone, whoever made it: the search has no part in these figures.

use num_complex::Complex;
use num_rational::BigRational;
use num_traits::{One, ToPrimitive};

use super::error::OptimiseError;
use super::first::{First, Residual, Turning};
use super::place::Place;
use crate::engine::{Counterweight, Engine, throws};
use crate::exact::{PhasorSum, Term};
use crate::journal::{self, bearing_peaks};
use crate::loads::{Arm, Method, Scale, bearing_loads};
use crate::numbers;

/// A crankshaft with its counterweights.
#[derive(Clone, Debug)]
pub struct Design {
    /// Mass of the crankshaft in kilograms, as [`Engine::crankshaft_mass`] counts it.
    pub mass: BigRational,
    /// Largest load of each main bearing, in multiples of m r ω², on a continuous beam: in a revolution, of the masses; where the layout asks
    /// for the gas in a cycle, of gas and masses.
    pub peaks: Vec<f64>,
    /// What these bearings are called: their numbers, beside the names of their crankshafts where there are several.
    pub bearings: Vec<String>,
    /// Indices of the bearings with the largest.
    pub worst: Vec<usize>,
    /// What is at each place.
    pub weights: Vec<PlacedWeight>,
    /// What is left of the first-order force that turns with the crank, in newtons (else multiples of m r ω²); of several crankshafts
    /// the largest.
    pub force: Residual,
    /// What is left of its couple about the reference plane, in newton-metres (else multiples of m r ω² times the unit of the
    /// positions).
    pub couple: Residual,
    /// What turns multiples into newtons.
    pub scale: Option<Scale>,
}

impl Design {
    /// The largest bearing load, in multiples of m r ω².
    pub fn peak(&self) -> f64 {
        self.peaks.iter().copied().fold(0.0, f64::max)
    }
}

/// A counterweight: all that is at one place.
#[derive(Clone, Debug)]
pub struct PlacedWeight {
    /// Where.
    pub place: Place,
    /// `U e^{iγ}` in kilogram-metres.
    pub mass_radius: Complex<f64>,
    /// In kilograms.
    pub mass: BigRational,
    /// Its part of the balance factor of its throw: `U` over the throw's own mass-radius.
    pub factor: Option<f64>,
    /// How far it is turned on from opposite to its throw, in degrees in (−180, 180].
    pub skew: Option<f64>,
}

/// Measures an engine with counterweights at these places, at these orders.
///
/// # Errors
/// What the engine lacks.
pub fn measure(engine: &Engine, places: &[Place], orders: &[u32]) -> Result<Design, OptimiseError> {
    let loads = bearing_loads(engine, orders, Method::Continuous)?;
    let (Some(mass), Some(radius)) = (engine.crankshaft_mass(), &engine.dimensions().crank_radius) else {
        return Err(OptimiseError::NoMasses);
    };
    let unit = engine.unit_mass() * radius;
    let arm = |position: &BigRational| position - engine.reference_plane();
    let newtons = loads.scale.as_ref().map_or(1.0, Scale::force);
    if loads.scale.as_ref().is_some_and(Scale::is_at_rest) {
        return Err(OptimiseError::Still);
    }
    let (peaks, worst) = match engine.effects().gas {
        false => (loads.bearings.iter().map(|bearing| bearing.peak.value).collect(), loads.worst),
        true => {
            let found = bearing_peaks(engine).map_err(|lack| OptimiseError::Gas(lack.to_string()))?;
            let peaks: Vec<f64> = found.iter().map(|[all, _]| all.value / newtons).collect();
            let worst = journal::worst(peaks.iter().copied());
            (peaks, worst)
        }
    };
    let couple_scale = if Arm::of(engine) == Arm::Metre { newtons } else { 1.0 };
    let left = |weighing: &dyn Fn(&BigRational) -> BigRational, scale: f64| {
        let of_shaft = |crank: usize| {
            let first = First::new((engine, crank), weighing, &unit)?;
            Ok(first.left(&unit, scale * Turning::of(engine, crank).force()))
        };
        let shafts = (0..engine.crankshafts()).map(of_shaft);
        let shafts = shafts.collect::<Result<Vec<Residual>, OptimiseError>>()?;
        Ok::<_, OptimiseError>(shafts.into_iter().fold(Residual::Zero, Residual::larger))
    };
    Ok(Design {
        mass,
        peaks,
        bearings: loads.bearings.iter().map(|bearing| bearing.name.clone()).collect(),
        worst,
        weights: places.iter().map(|place| weight(engine, place)).collect(),
        force: left(&|_| BigRational::one(), newtons)?,
        couple: left(&arm, couple_scale)?,
        scale: loads.scale,
    })
}

/// What is at a place.
pub(super) fn weight(engine: &Engine, place: &Place) -> PlacedWeight {
    let is_here = |weight: &&Counterweight| (&weight.position, weight.crank) == (&place.position, place.crank);
    let here = || engine.crankshaft().counterweights.iter().filter(is_here);
    let terms = here().map(|weight| Term { angle: weight.angle.clone(), weight: weight.mass_radius() });
    let mass_radius = numbers::evaluate(&PhasorSum::new(terms.collect()));
    let mass = here().map(|weight| &weight.mass).sum();
    let of_throw = place.throw.and_then(|index| {
        let whole = engine.throw_mass_radii()?.get(index)?.to_f64().filter(|whole| *whole > 0.0)?;
        Some((whole, numbers::direction(&throws(engine).get(index)?.angle.opposite())))
    });
    let turned = |(_, opposite): (f64, Complex<f64>)| (mass_radius * opposite.conj()).arg().to_degrees();
    PlacedWeight {
        factor: of_throw.map(|(whole, _)| mass_radius.norm() / whole),
        skew: of_throw.filter(|_| mass_radius.norm() > 0.0).map(turned),
        place: place.clone(),
        mass_radius,
        mass,
    }
}

/// A weight in words, for the file that holds it.
pub(super) fn note(weight: &PlacedWeight) -> String {
    let owner = weight.place.throw.map_or_else(|| "On its own".to_owned(), |throw| format!("Throw {}", throw + 1));
    let amount = format!("{:.4e} kg m, {:.4} kg", weight.mass_radius.norm(), numbers::float(&weight.mass));
    let share = weight.factor.map(|factor| format!(", balance factor {factor:.4}")).unwrap_or_default();
    let skew =
        weight.skew.map(|skew| format!(", {:.2}° on from opposite to its throw", skew + 0.0)).unwrap_or_default();
    format!("{owner}: {amount}{share}{skew}")
}
