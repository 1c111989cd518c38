//! What is the problem in decimals? Bearing loads, force and couple, affine in the mass-radii of the counterweights.

use num_complex::Complex;
use num_rational::BigRational;
use num_traits::{One, Signed, ToPrimitive};

use super::error::OptimiseError;
use super::felt::Felt;
use super::first::First;
use super::place::Place;
use super::{Couple, Request};
use crate::beam::Beam;
use crate::engine::Engine;
use crate::exact::PhasorSum;
use crate::loads::{self, Arm, Method, bearing_loads};
use crate::order::unit_mass;

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
    /// Direct first order of the shaking force without counterweights, in kilogram-metres: force, and moment about the reference
    /// plane. That of the bearing loads is longer by the side forces of the pistons.
    pub exact: [PhasorSum; 2],
    /// Whether these are exact; with offsets an irrational number in them is rounded.
    pub is_exact: bool,
    /// The same in multiples of m r.
    pub left: [Complex<f64>; 2],
    /// Position of the reference plane.
    pub reference: BigRational,
    /// Distance of each place from the reference plane.
    pub arms: Vec<f64>,
    /// What the couple may be, in multiples of m r times the unit of the positions; none where it has to vanish.
    pub most_couple: Option<f64>,
}

impl Problem {
    pub fn new(engine: &Engine, places: &[Place], wish: &Request) -> Result<Self, OptimiseError> {
        if !engine.geared_cranks().is_empty() {
            return Err(OptimiseError::SeveralCrankshafts);
        }
        match places {
            [] => return Err(OptimiseError::NoPlaces),
            [only] => return Err(OptimiseError::OnePlane(only.position.to_string())),
            _ => {}
        }
        if !wish.orders.contains(&1) {
            return Err(OptimiseError::NoFirstOrder);
        }
        let bare =
            engine.with_counterweights(Vec::new()).map_err(|error| OptimiseError::Unsolved(error.to_string()))?;
        let loads = bearing_loads(&bare, &wish.orders, Method::Continuous)?;
        let (Some(mass), Some(radius)) = (bare.crankshaft_mass(), bare.dimensions().crank_radius.clone()) else {
            return Err(OptimiseError::NoMasses);
        };
        let unit = unit_mass(&bare) * radius;
        let float = |value: &BigRational| value.to_f64().unwrap_or(f64::INFINITY);
        let most_couple = match (&wish.couple, &loads.scale) {
            (Couple::Zero, _) => None,
            (Couple::AtMost(most), _) if !most.is_positive() => None,
            (Couple::AtMost(most), Some(scale)) if Arm::of(engine) == Arm::Metre => Some(float(most) / scale.force()),
            (Couple::AtMost(_), _) => return Err(OptimiseError::NoSpeed),
        };
        let beam = Beam::new(bare.bearings().to_vec())
            .map_err(|mistake| OptimiseError::Missing(loads::Missing::Beam(mistake)))?;
        let mut parts = vec![Vec::new(); bare.bearings().len()];
        for place in places {
            parts
                .iter_mut()
                .zip(&beam.influence(&place.position))
                .for_each(|(of_bearing, share)| of_bearing.push(float(share)));
        }
        let arm = |position: &BigRational| position - bare.reference_plane();
        let first = [First::new(&bare, &|_| BigRational::one(), &unit)?, First::new(&bare, &arm, &unit)?];
        let exact = first.each_ref().map(First::rounded);
        let left = [&exact[0], &exact[1]].map(|sum| crate::numbers::evaluate(sum) / float(&unit));
        Ok(Problem {
            bare_mass: float(&mass),
            weighs: places.iter().map(|place| float(&(&unit / &place.radius))).collect(),
            felt: Felt::new(&bare, loads)?,
            arms: places.iter().map(|place| float(&arm(&place.position))).collect(),
            reference: bare.reference_plane().clone(),
            unit,
            parts,
            is_exact: first.iter().all(First::is_exact),
            exact,
            left,
            most_couple,
        })
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
