//! What is the problem in decimals? Bearing loads, force and couple, affine in the mass-radii of the counterweights.

use num_complex::Complex;
use num_rational::BigRational;
use num_traits::{One, Signed, ToPrimitive};

use super::error::OptimiseError;
use super::felt::Felt;
use super::first::{First, Turning};
use super::place::Place;
use super::{Couple, Request};
use crate::beam::Beam;
use crate::engine::Engine;
use crate::exact::PhasorSum;
use crate::loads::{self, Arm, Method, bearing_loads};

/// The problem. Mass-radii are in multiples of m r, forces of m r ω², masses in kilograms.
pub(super) struct Problem {
    /// Mass of the crankshaft without counterweights.
    pub bare_mass: f64,
    /// m r in kilogram-metres.
    pub unit: BigRational,
    /// Kilograms that a mass-radius of 1 weighs at each place.
    pub weighs: Vec<f64>,
    /// What each bearing feels of the crankshaft without counterweights.
    pub felt: Felt,
    /// The part of a load at each place that each bearing carries: `parts[bearing][place]`.
    pub parts: Vec<Vec<f64>>,
    /// What turns with each crankshaft without counterweights.
    pub shafts: Vec<Shaft>,
    /// Which of them each place is on.
    pub shaft_of: Vec<usize>,
    /// Position of the reference plane.
    pub reference: BigRational,
    /// Distance of each place from the reference plane.
    pub arms: Vec<f64>,
    /// What the couple may be, in multiples of m r times the unit of the positions; none where it has to vanish.
    pub asked_couple: Option<f64>,
    /// The same for the solver, which leaves room for rounding.
    pub most_couple: Option<f64>,
}

/// What turns with a crankshaft without counterweights in order 1 of the shaking force: force, and moment about the reference plane. That
/// of the bearing loads is longer by the side forces of the pistons.
pub(super) struct Shaft {
    /// In kilogram-metres.
    pub exact: [PhasorSum; 2],
    /// Whether these are exact; with offsets an irrational number in them is rounded.
    pub is_exact: bool,
    /// The same in multiples of m r.
    pub left: [Complex<f64>; 2],
    /// How it turns.
    pub turning: Turning,
}

impl Shaft {
    fn new(bare: &Engine, crank: usize, unit: &BigRational) -> Result<Self, OptimiseError> {
        let arm = |position: &BigRational| position - bare.reference_plane();
        let first = [First::new((bare, crank), &|_| BigRational::one(), unit)?, First::new((bare, crank), &arm, unit)?];
        let exact = first.each_ref().map(First::rounded);
        let metres = unit.to_f64().unwrap_or(f64::INFINITY);
        let left = exact.each_ref().map(|sum| crate::numbers::evaluate(sum) / metres);
        Ok(Shaft { is_exact: first.iter().all(First::is_exact), exact, left, turning: Turning::of(bare, crank) })
    }
}

/// Two planes or more of each crankshaft.
fn enough(engine: &Engine, places: &[Place]) -> Result<(), OptimiseError> {
    for crank in 0..engine.crankshafts() {
        let own: Vec<&Place> = places.iter().filter(|place| place.crank == crank).collect();
        match (own.as_slice(), engine.geared_cranks().get(crank)) {
            ([], Some(shaft)) if !places.is_empty() => return Err(OptimiseError::NoPlacesOn(shaft.name.clone())),
            ([], _) => return Err(OptimiseError::NoPlaces),
            ([only], _) => return Err(OptimiseError::OnePlane(only.position.to_string())),
            _ => {}
        }
    }
    Ok(())
}

impl Problem {
    pub fn new(engine: &Engine, places: &[Place], request: &Request) -> Result<Self, OptimiseError> {
        enough(engine, places)?;
        if !request.orders.contains(&1) {
            return Err(OptimiseError::NoFirstOrder);
        }
        let bare =
            engine.with_counterweights(Vec::new()).map_err(|error| OptimiseError::Unsolved(error.to_string()))?;
        let loads = bearing_loads(&bare, &request.orders, Method::Continuous)?;
        let (Some(mass), Some(radius)) = (bare.crankshaft_mass(), bare.dimensions().crank_radius.clone()) else {
            return Err(OptimiseError::NoMasses);
        };
        let unit = bare.unit_mass() * radius;
        let float = |value: &BigRational| value.to_f64().unwrap_or(f64::INFINITY);
        let most_couple = match (&request.couple, &loads.scale) {
            (Couple::Zero, _) => None,
            (Couple::AtMost(most), _) if !most.is_positive() => None,
            (Couple::AtMost(most), Some(scale)) if Arm::of(engine) == Arm::Metre => Some(float(most) / scale.force()),
            (Couple::AtMost(_), _) => return Err(OptimiseError::NoSpeed),
        };
        let beam = Beam::new(bare.bearings().to_vec())
            .map_err(|mistake| OptimiseError::Missing(loads::Missing::Beam(mistake)))?;
        let cranks = 0..bare.crankshafts();
        let shafts = cranks.map(|crank| Shaft::new(&bare, crank, &unit)).collect::<Result<Vec<_>, _>>()?;
        // A crankshaft has its own bearings at the positions of the file.
        let mut parts = vec![vec![0.0; places.len()]; bare.bearings().len() * shafts.len()];
        for (index, place) in places.iter().enumerate() {
            let own = parts.iter_mut().skip(place.crank * bare.bearings().len());
            let force = shafts[place.crank].turning.force();
            own.zip(&beam.influence(&place.position)).for_each(|(parts, share)| parts[index] = float(share) * force);
        }
        let arm = |position: &BigRational| position - bare.reference_plane();
        Ok(Problem {
            bare_mass: float(&mass),
            weighs: places.iter().map(|place| float(&(&unit / &place.radius))).collect(),
            felt: Felt::new(&bare, loads)?,
            arms: places.iter().map(|place| float(&arm(&place.position))).collect(),
            reference: bare.reference_plane().clone(),
            unit,
            parts,
            shafts,
            shaft_of: places.iter().map(|place| place.crank).collect(),
            asked_couple: most_couple,
            most_couple,
        })
    }

    /// Whether what turns with the crankshafts is exact.
    pub fn is_exact(&self) -> bool {
        self.shafts.iter().all(|shaft| shaft.is_exact)
    }

    /// A couple of the engine for each crankshaft, as a mass-radius.
    pub fn of_shafts(&self, couple: f64) -> Vec<f64> {
        self.shafts.iter().map(|shaft| couple / shaft.turning.force()).collect()
    }

    /// The places on a crankshaft.
    pub fn places_on(&self, shaft: usize) -> impl Iterator<Item = usize> + Clone {
        self.shaft_of.iter().enumerate().filter(move |(_, own)| **own == shaft).map(|(place, _)| place)
    }

    /// How many places there are.
    pub fn places(&self) -> usize {
        self.weighs.len()
    }

    /// What the counterweights add to a bearing, seen from the crank, with these mass-radii.
    pub fn added(&self, bearing: usize, weights: &[Complex<f64>]) -> Complex<f64> {
        self.parts[bearing].iter().zip(weights).map(|(part, weight)| weight * part).sum()
    }
}
