//! What does a document of firing stars say?

use num_rational::BigRational;
use serde::{Deserialize, Serialize};

use super::certificate::Certificate;
use super::decimals::{Decimal, length_in_range};
use super::engine::RodStatement;
use super::format::Format;
use super::fraction;
use super::vector::Vector;

/// The firing stars of one engine, each with its certificate: the JSON document of `firing --format json`.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct FiringDocument {
    /// `crankstar firing 1`.
    pub format: Format,
    /// Title of the layout: free text.
    pub title: String,
    /// How often a cylinder fires.
    pub cycle: CycleClaim,
    /// The cylinders with the moments of their firing.
    pub cylinders: Vec<FiringCylinder>,
    /// The orders that were asked for, rising.
    #[serde(with = "orders")]
    pub orders: Vec<BigRational>,
    /// One verdict per order and class of cylinders, in this order.
    pub verdicts: Vec<FiringClaim>,
    /// The stars of one period, where the statement on every order was asked for.
    pub pattern: Option<PatternClaim>,
}

/// How often a cylinder fires.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum CycleClaim {
    /// Once in a revolution.
    TwoStroke,
    /// Once in two revolutions.
    FourStroke,
}

/// A cylinder as the firing stars see it.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct FiringCylinder {
    /// What the cylinder is called.
    pub name: String,
    /// Crank-throw angle β, in turns.
    #[serde(with = "fraction")]
    pub throw: BigRational,
    /// Angle α of the cylinder axis, in turns.
    #[serde(with = "fraction")]
    pub bank: BigRational,
    /// Crank angle of the cycle at which it fires, in turns.
    #[serde(with = "fraction")]
    pub firing_angle: BigRational,
    /// Crank radius, in multiples of a common radius.
    #[serde(with = "fraction")]
    pub crank_radius: BigRational,
    /// Deflection in a mode of torsional vibration; 1 for all cylinders of a rigid crankshaft.
    #[serde(with = "fraction")]
    pub deflection: BigRational,
    /// Its rod.
    pub rod: RodStatement,
}

/// The verdict on one star.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct FiringClaim {
    /// The order κ, in multiples of the crank speed.
    #[serde(with = "fraction")]
    pub order: BigRational,
    /// Whose vectors they are, by name, where not all cylinders make the same torque from the same pressure.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub of: Vec<String>,
    /// Whether the sum is zero.
    pub vanishes: bool,
    /// The sum, one term per cylinder.
    pub terms: Vec<Vector>,
    /// `|S|`, to a few units in the last place.
    #[serde(serialize_with = "length_in_range")]
    pub modulus: Decimal,
    /// The direction of S in degrees, in `(−180, 180]`; none where S is zero.
    pub angle_deg: Option<Decimal>,
    /// The evidence.
    pub certificate: Certificate,
}

/// The stars of one period: those of every order.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct PatternClaim {
    /// After how many orders of the cycle the stars repeat.
    pub period: u32,
    /// One verdict per order up to the period and class of cylinders; the terms are those of the cylinders.
    pub verdicts: Vec<PatternVerdict>,
}

/// The verdict on one star of the period.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct PatternVerdict {
    /// The order κ.
    #[serde(with = "fraction")]
    pub order: BigRational,
    /// Whether the sum is zero.
    pub vanishes: bool,
    /// The evidence.
    pub certificate: Certificate,
}

/// Orders travel as strings: `"1/2"`.
mod orders {
    use num_rational::BigRational;
    use serde::{Deserialize, Deserializer, Serialize, Serializer};

    use super::super::fraction;

    #[derive(Serialize, Deserialize)]
    struct One(#[serde(with = "fraction")] BigRational);

    pub fn serialize<S: Serializer>(orders: &[BigRational], serializer: S) -> Result<S::Ok, S::Error> {
        serializer.collect_seq(orders.iter().map(|order| One(order.clone())))
    }

    pub fn deserialize<'de, D: Deserializer<'de>>(deserializer: D) -> Result<Vec<BigRational>, D::Error> {
        Ok(Vec::<One>::deserialize(deserializer)?.into_iter().map(|One(order)| order).collect())
    }
}
