//! Does the shape of what is left follow from the two vectors of an order?

use serde::{Deserialize, Serialize};

use super::audit::{Audit, Reason};
use super::certificate::Certificate;
use super::check::certify;
use super::collected::{Collected, difference_of_squares};
use super::engine::Quantity;

/// What is left of one order of the force or the moment.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Shape {
    /// Both vectors vanish.
    Balanced,
    /// Only the direct vector is left: constant length, turning with the crank.
    Rotating,
    /// Only the reverse vector is left: constant length, turning against the crank.
    CounterRotating,
    /// Vectors of equal length: the resultant swings along a line.
    Planar,
    /// Vectors of different length: the resultant traces an ellipse.
    Elliptical,
}

/// The shape of what is left of one order, with the evidence that tells planar from elliptical.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct ShapeClaim {
    /// Force or moment.
    pub quantity: Quantity,
    /// The order k.
    pub order: u32,
    /// The cylinders that it is about, as in the verdicts.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub of: Vec<String>,
    /// The shape.
    pub shape: Shape,
    /// Where neither vector vanishes: evidence that `|direct|² − |reverse|²` is zero (planar) or is not (elliptical).
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub certificate: Option<Certificate>,
}

/// One vector of an order: its collected terms, proved to be zero or not.
pub(super) type Judged = (Collected, bool);

/// Checks a shape against both vectors of its order, direct first.
pub(super) fn check_shape(claim: &ShapeClaim, [direct, reverse]: [&Judged; 2], audit: &Audit) -> Result<(), Reason> {
    let equally_long = match claim.shape {
        Shape::Balanced | Shape::Rotating | Shape::CounterRotating => None,
        Shape::Planar => Some(true),
        Shape::Elliptical => Some(false),
    };
    let fits = match claim.shape {
        Shape::Balanced => direct.1 && reverse.1,
        Shape::Rotating => !direct.1 && reverse.1,
        Shape::CounterRotating => direct.1 && !reverse.1,
        Shape::Planar | Shape::Elliptical => !direct.1 && !reverse.1,
    };
    if !fits {
        return Err("the shape contradicts the verdicts".into());
    }
    match (equally_long, &claim.certificate) {
        (None, None) => Ok(()),
        (None, Some(_)) => Err("no moduli are compared, so no certificate belongs here".into()),
        (Some(_), None) => Err("a certificate that compares the two moduli is missing".into()),
        (Some(equal), Some(certificate)) => {
            let difference = difference_of_squares(&direct.0, &reverse.0, audit)?;
            Ok(certify(&difference, equal, certificate, audit)?)
        }
    }
}
