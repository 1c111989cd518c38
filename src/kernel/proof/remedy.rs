//! What does a remedy claim? The engine, the weights, and the corrected sums with their evidence.

use num_rational::BigRational;
use num_traits::Zero;
use serde::{Deserialize, Serialize};

use super::certificate::Certificate;
use super::coefficient::Coefficient;
use super::decimals::{Decimal, length_in_range};
use super::engine::{Masses, RodStatement, is_once, once};
use super::format::Format;
use super::fraction;
use super::quantity::{Quantity, Sense};
use super::vector::Vector;

/// A remedy as data: the JSON document of `remedy --json`.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct RemedyDocument {
    /// `crankstar remedy 2`.
    pub format: Format,
    /// Title of the engine: free text.
    pub title: String,
    /// Whose masses the sums are about: all of the corrected engine.
    pub masses: Masses,
    /// The orders that are claimed to vanish, rising.
    pub orders: Vec<u32>,
    /// The quantities that are claimed to vanish: force and moment.
    pub quantities: Vec<Quantity>,
    /// Position of the plane that moments are taken about.
    #[serde(with = "fraction")]
    pub reference_plane: BigRational,
    /// The cylinders.
    pub cylinders: Vec<RodCylinder>,
    /// The masses of the engine that turn.
    pub turning_masses: Vec<TurningClaim>,
    /// The weights of the remedy.
    pub weights: Vec<WeightClaim>,
    /// The orders and senses that are too little for a weight, and need not vanish.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub left_out: Vec<LeftOutClaim>,
    /// The sums of the corrected engine, by order, quantity, sense and coefficient.
    pub sums: Vec<CorrectedClaim>,
}

/// A cylinder with its rod.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct RodCylinder {
    /// Crank-throw angle β in turns.
    #[serde(with = "fraction")]
    pub throw: BigRational,
    /// Bank angle α in turns.
    #[serde(with = "fraction")]
    pub bank: BigRational,
    /// Position z.
    #[serde(with = "fraction")]
    pub position: BigRational,
    /// Reciprocating mass times crank radius, in multiples of m r.
    #[serde(with = "fraction")]
    pub weight: BigRational,
    /// Its rod.
    pub rod: RodStatement,
    /// How many times its crankshaft turns while the reference one turns once: a whole number from 1 on, omitted where it is 1.
    #[serde(default = "once", skip_serializing_if = "is_once")]
    pub speed: u32,
    /// Mass at the knuckle pin of its link times the crank radius, in multiples of m r; omitted where it is 0.
    #[serde(with = "fraction", default = "BigRational::zero", skip_serializing_if = "BigRational::is_zero")]
    pub knuckle_weight: BigRational,
}

/// A mass that turns at a multiple of the crank speed.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct TurningClaim {
    /// The multiple.
    pub order: u32,
    /// With the crank or against it.
    pub sense: Sense,
    /// Position z.
    #[serde(with = "fraction")]
    pub position: BigRational,
    /// Its direction at θ = 0, in turns.
    #[serde(with = "fraction")]
    pub angle: BigRational,
    /// Mass times radius, in multiples of m r.
    #[serde(with = "fraction")]
    pub mass_radius: BigRational,
    /// The rod whose coefficient c_k of this order the mass-radius is multiplied by; omitted for 1.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub coefficient_of: Option<RodStatement>,
}

/// A weight of the remedy: `Σ coefficient · Σ weight e^{2πi·angle}`, its mass-radius in multiples of m r.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct WeightClaim {
    /// Which multiple of the crank speed it turns at.
    pub order: u32,
    /// With the crank or against it.
    pub sense: Sense,
    /// Position z.
    #[serde(with = "fraction")]
    pub position: BigRational,
    /// Its parts, by coefficient.
    pub parts: Vec<WeightPart>,
}

/// The part of a weight with one coefficient.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct WeightPart {
    /// The coefficient.
    pub coefficient: Coefficient,
    /// The sum that it is multiplied by, collected.
    pub terms: Vec<Vector>,
    /// The length of this sum, to a few units in the last place.
    #[serde(serialize_with = "length_in_range")]
    pub modulus: Decimal,
    /// Its direction in degrees, in `(−180, 180]`, as accurate.
    pub angle_deg: Decimal,
}

/// An order and sense that is left as it is.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct LeftOutClaim {
    /// The order k.
    pub order: u32,
    /// Direct or reverse.
    pub sense: Sense,
}

/// One sum of the corrected engine, which is zero except where its order and sense are left out.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct CorrectedClaim {
    /// Force or moment.
    pub quantity: Quantity,
    /// The order k.
    pub order: u32,
    /// Direct or reverse.
    pub sense: Sense,
    /// What the sum is multiplied by.
    pub coefficient: Coefficient,
    /// The sum, in multiples of m r, collected.
    pub terms: Vec<Vector>,
    /// The evidence that it is zero, or that it is not.
    pub certificate: Certificate,
}
