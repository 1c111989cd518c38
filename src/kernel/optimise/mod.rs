//! Which counterweights are best: the least load of the main bearings for each mass of the crankshaft?
//!
//! The places of the counterweights are those of the engine: their planes and the radius of their centres of gravity.
//! Chosen are their mass-radii `U_i`, complex: how large, and in which direction, so that both the balance factor of each
//! weight and its skew are free. A larger radius makes the same `U_i` of less mass, so that the radius is never a choice.
//!
//! **What is convex, and what is not.** For one mass of the crankshaft, the largest of `|R_j(θ)|` over bearings j and crank
//! angles θ is a convex function of the `U_i`: each R_j(θ) is affine in them (theory, section 8). Masses `m_i ≥ |U_i|/r_i` are
//! second-order cones, force and couple are linear. So each point of the front is the least there is, not a local one, and
//! the multipliers of the cones prove it ([`Optimum::least`]). The crank angles are samples: those where the peak of a
//! solution stands higher are added until the two agree. Rounding to whole units of mass-radius (a gram-millimetre for a car
//! engine) is not convex and costs some hundred-thousandths of the peak; two weights are then solved anew, exactly, so that force and
//! couple vanish in the field of the throws' directions and not in decimals.

mod best;
mod bound;
mod design;
mod direction;
mod error;
mod exact;
mod felt;
mod file;
mod first;
mod front;
mod place;
mod problem;
mod sample;
mod solve;

use std::str::FromStr;

use num_rational::BigRational;
use num_traits::{Signed, Zero};

use crate::file::parse_number;

pub use best::Optimum;
pub use design::{Design, PlacedWeight, measure};
pub use error::OptimiseError;
pub use first::Residual;
pub use front::{Front, Uniform, front};
pub use place::{Place, places, uniform};

/// What is asked of the counterweights.
#[derive(Clone, Debug)]
pub struct Request {
    /// What may be left of the first-order couple that turns with the crank. Its force is always removed.
    pub couple: Couple,
    /// How many points of the front, 1 or more; one alone is that with the least load.
    pub points: usize,
    /// The orders of the bearing loads.
    pub orders: Vec<u32>,
}

/// What may be left of the first-order couple that turns with the crank.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Couple {
    /// Nothing, exactly.
    Zero,
    /// At most this many newton-metres.
    AtMost(BigRational),
}

impl FromStr for Couple {
    type Err = OptimiseError;

    /// `zero`, or newton-metres: `50`, `50 N·m`.
    fn from_str(text: &str) -> Result<Self, OptimiseError> {
        let text = text.trim();
        if text == "zero" {
            return Ok(Couple::Zero);
        }
        let unit = ["N·m", "N m", "Nm"].into_iter().find(|unit| text.ends_with(unit));
        let number = unit.map_or(text, |unit| text[..text.len() - unit.len()].trim_end());
        match parse_number(number) {
            Ok(most) if most.is_positive() => Ok(Couple::AtMost(most)),
            Ok(most) if most.is_zero() => Ok(Couple::Zero),
            Ok(_) | Err(_) => Err(OptimiseError::Couple(text.chars().take(40).collect())),
        }
    }
}
