//! What does a certificate say? Data only: whoever reads it needs no part of this program.

use num_bigint::BigInt;
use num_rational::BigRational;
use serde::{Deserialize, Serialize};

use super::fraction;

/// Evidence that a sum `S = Σ weight · e^{2πi·angle}` is zero, or that it is not.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(tag = "kind", rename_all = "lowercase", deny_unknown_fields)]
pub enum Certificate {
    /// `S = 0`: the corners of these regular polygons, collected, are the collected terms.
    Polygons {
        /// The polygons; none where the terms collect to nothing.
        polygons: Vec<Polygon>,
    },
    /// `S ≠ 0`: its image modulo a number, mostly a prime, is not zero.
    Residue(Residue),
    /// `S ≠ 0`: each step keeps a part that would be zero if the whole were, and one vector is left.
    Splitting {
        /// The steps, to be taken in order.
        steps: Vec<Step>,
    },
}

impl Certificate {
    /// Which verdict the certificate is evidence for.
    pub fn claims_zero(&self) -> bool {
        match self {
            Certificate::Polygons { .. } => true,
            Certificate::Residue(_) | Certificate::Splitting { .. } => false,
        }
    }
}

/// A regular polygon: corners at `rotation + j/sides`, each of the same weight.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Polygon {
    /// How many sides, from 2 on: 2 is an opposed pair.
    pub sides: u64,
    /// Angle of one corner, in turns.
    #[serde(with = "fraction")]
    pub rotation: BigRational,
    /// The weight of every corner.
    #[serde(with = "fraction")]
    pub weight: BigRational,
}

/// `Σ (weight·scale) · root^(angle·conductor) ≡ residue (mod prime)`, and not 0.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Residue {
    /// A common denominator of the angles.
    #[serde(with = "fraction")]
    pub conductor: BigInt,
    /// The modulus: a prime that is 1 modulo the conductor, or a product of such.
    #[serde(with = "fraction")]
    pub prime: BigInt,
    /// A number of multiplicative order `conductor` modulo each prime that divides the modulus.
    #[serde(with = "fraction")]
    pub root: BigInt,
    /// A common denominator of the weights.
    #[serde(with = "fraction")]
    pub scale: BigInt,
    /// What the sum is by the modulus: not 0.
    #[serde(with = "fraction")]
    pub residue: BigInt,
}

/// One step of a splitting, from a sum of `n` collected terms to a part of it.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "lowercase", deny_unknown_fields)]
pub enum Step {
    /// Keep the terms whose angle differs from `angle` by a multiple of `1/modulus`, and turn them by `−angle`.
    ///
    /// Sound where every prime up to `n` that divides the common denominator of the angles divides `modulus`.
    Class {
        /// Angle of one term of the class, in turns.
        #[serde(with = "fraction")]
        angle: BigRational,
        /// What the class is taken modulo.
        #[serde(with = "fraction")]
        modulus: BigInt,
    },
    /// Write each angle as `u/prime + x`, the denominator of `x` prime to `prime`; keep the terms of class `first` less
    /// those of class `second`, at their angles `x`.
    ///
    /// Sound where `prime²` does not divide the common denominator of the angles.
    Compare {
        /// The prime, up to a million.
        prime: u64,
        /// A class `u`.
        first: u64,
        /// Another class `u`.
        second: u64,
    },
}
