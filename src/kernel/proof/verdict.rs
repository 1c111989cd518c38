//! Does a verdict hold: are its terms those of the cylinders, its certificate sound, its decimals right?

use num_bigint::BigInt;
use num_rational::BigRational;
use num_traits::One;
use serde::{Deserialize, Serialize};

use super::audit::{Audit, Reason, refuse_if};
use super::certificate::Certificate;
use super::check::certify;
use super::collected::{Collected, collected, turn};
use super::decimals::{Decimal, check_decimals, length_in_range};
use super::quantity::{Quantity, Sense};
use super::vector::Vector;

/// A verdict with its evidence.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct VerdictClaim {
    /// What the verdict is about.
    pub quantity: Quantity,
    /// The order k.
    pub order: u32,
    /// Direct or reverse; none for the torque.
    pub sense: Option<Sense>,
    /// Whose terms they are, by name, where the order has several sums, each before a coefficient of its own.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub of: Vec<String>,
    /// Whether the sum is zero.
    pub vanishes: bool,
    /// The sum, one term per source, before collecting.
    pub terms: Vec<Vector>,
    /// `|S|`, to a few units in the last place.
    #[serde(serialize_with = "length_in_range")]
    pub modulus: Decimal,
    /// The direction of S in degrees, in `(−180, 180]`, as accurate; none where S is zero.
    pub angle_deg: Option<Decimal>,
    /// The evidence.
    pub certificate: Certificate,
}

/// What one verdict is about: its quantity, order, sense, and the sources where not all are meant.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) struct About {
    pub quantity: Quantity,
    pub order: u32,
    pub sense: Option<Sense>,
    pub of: Vec<String>,
}

impl About {
    pub fn place(&self) -> String {
        let sense = self.sense.map(|sense| format!(", {}", sense.name())).unwrap_or_default();
        let of = if self.of.is_empty() { String::new() } else { format!(", of {}", self.of.join(" ")) };
        format!("({}, order {}{sense}{of})", self.quantity.name(), self.order)
    }
}

impl VerdictClaim {
    pub(super) fn said(&self) -> SaidSum<'_> {
        let VerdictClaim { terms, vanishes, modulus, angle_deg, certificate, .. } = self;
        SaidSum { terms, vanishes: *vanishes, modulus: *modulus, angle_deg: *angle_deg, certificate }
    }

    pub(super) fn subject(&self) -> About {
        About { quantity: self.quantity, order: self.order, sense: self.sense, of: self.of.clone() }
    }
}

/// Angle of a cylinder's vector (theory, section 3): direct `kβ − (k−1)α`, reverse `−kβ + (k+1)α`, torque `k(β − α)`.
pub(super) fn phase(throw: &BigRational, bank: &BigRational, order: u32, sense: Option<Sense>) -> BigRational {
    let k = BigRational::from_integer(BigInt::from(order));
    let one = BigRational::one();
    match sense {
        None => &k * (throw - bank),
        Some(Sense::Direct) => &k * throw - (&k - one) * bank,
        Some(Sense::Reverse) => (&k + one) * bank - &k * throw,
    }
}

/// What is said of one sum, of whatever order.
pub(super) struct SaidSum<'a> {
    pub terms: &'a [Vector],
    pub vanishes: bool,
    pub modulus: Decimal,
    pub angle_deg: Option<Decimal>,
    pub certificate: &'a Certificate,
}

impl SaidSum<'_> {
    /// Checks it against the terms that it has to have, by the names of their sources; returns the sum, collected.
    pub fn check(&self, right: &[(String, Vector)], audit: &Audit) -> Result<Collected, Reason> {
        check_terms(self.terms, right)?;
        let sum = collected(self.terms, audit)?;
        certify(&sum, self.vanishes, self.certificate, audit)?;
        check_decimals(&sum, self.vanishes, self.modulus, self.angle_deg, audit)?;
        Ok(sum)
    }
}

fn check_terms(terms: &[Vector], right: &[(String, Vector)]) -> Result<(), Reason> {
    refuse_if(terms.len() != right.len(), format!("{} terms for {} sources", terms.len(), right.len()))?;
    for (term, (name, Vector { angle, weight })) in terms.iter().zip(right) {
        let right = turn(angle);
        if term.angle != right {
            return Err(format!("the angle of {name} is {}, it should be {right}", term.angle).into());
        }
        if term.weight != *weight {
            return Err(format!("the weight of {name} is {}, it should be {weight}", term.weight).into());
        }
    }
    Ok(())
}
