//! Does the shape of what is left follow from the two vectors of an order?

use num_bigint::BigInt;
use num_rational::BigRational;
use serde::{Deserialize, Serialize};

use super::audit::{Audit, Reason};
use super::certificate::Certificate;
use super::check::certify;
use super::collected::{Collected, collect, difference_of_squares};
use super::engine::Quantity;
use super::judged::{Judged, JudgedGroup};
use super::rod::Motion;
use super::whole_sum::{are_nearly_equally_long, are_unequally_long};

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
    /// The sums that the order is made of do not tell.
    NotDecided,
    /// No source has the order, or all of its numbers are zero.
    DoesNotExist,
}

/// The shape of what is left of one order, with the evidence that tells planar from elliptical.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(try_from = "WrittenShape", into = "WrittenShape")]
pub struct ShapeClaim {
    /// Force or moment.
    pub quantity: Quantity,
    /// The order k.
    pub order: u32,
    /// The shape.
    pub shape: Shape,
    /// Where neither vector vanishes: how they compare.
    pub evidence: Option<ShapeEvidence>,
}

/// How the lengths of two vectors that do not vanish are compared.
#[derive(Clone, Debug, PartialEq)]
pub enum ShapeEvidence {
    /// One sum each before the same coefficient: `|direct|² − |reverse|²` is zero (planar) or is not (elliptical).
    Certificate(Certificate),
    /// Planar: the direct sums are the mirror images of the reverse ones.
    Mirror(MirrorClaim),
    /// Elliptical: an enclosure with so many bits keeps `|direct|² − |reverse|²` away from zero.
    Bits(u32),
}

/// That `direct = sign · conj(reverse)`, coefficient by coefficient.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct MirrorClaim {
    /// 1, or −1.
    pub sign: i8,
    /// That `direct − sign · conj(reverse)` is zero, for each coefficient that is not zero.
    pub certificates: Vec<Certificate>,
}

/// A shape as a document writes it: its evidence under the key that says which it is.
#[derive(Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
struct WrittenShape {
    quantity: Quantity,
    order: u32,
    shape: Shape,
    #[serde(default, skip_serializing_if = "Option::is_none")]
    certificate: Option<Certificate>,
    #[serde(default, skip_serializing_if = "Option::is_none")]
    mirror: Option<MirrorClaim>,
    #[serde(default, skip_serializing_if = "Option::is_none")]
    bits: Option<u32>,
}

impl TryFrom<WrittenShape> for ShapeClaim {
    type Error = &'static str;

    fn try_from(written: WrittenShape) -> Result<Self, Self::Error> {
        let WrittenShape { quantity, order, shape, certificate, mirror, bits } = written;
        let evidence = match (certificate, mirror, bits) {
            (None, None, None) => None,
            (Some(certificate), None, None) => Some(ShapeEvidence::Certificate(certificate)),
            (None, Some(mirror), None) => Some(ShapeEvidence::Mirror(mirror)),
            (None, None, Some(bits)) => Some(ShapeEvidence::Bits(bits)),
            _ => return Err("a shape has one of `certificate`, `mirror` and `bits`"),
        };
        Ok(ShapeClaim { quantity, order, shape, evidence })
    }
}

impl From<ShapeClaim> for WrittenShape {
    fn from(claim: ShapeClaim) -> Self {
        let ShapeClaim { quantity, order, shape, evidence } = claim;
        let mut written = WrittenShape { quantity, order, shape, certificate: None, mirror: None, bits: None };
        match evidence {
            Some(ShapeEvidence::Certificate(certificate)) => written.certificate = Some(certificate),
            Some(ShapeEvidence::Mirror(mirror)) => written.mirror = Some(mirror),
            Some(ShapeEvidence::Bits(bits)) => written.bits = Some(bits),
            None => (),
        }
        written
    }
}

/// Checks a shape against both vectors of its order.
pub(super) fn check_shape(claim: &ShapeClaim, judged: &Judged, motion: &Motion<'_>) -> Result<(), Reason> {
    let right = match judged.wholes[..] {
        _ if !judged.exists() => Some(Shape::DoesNotExist),
        [Some(true), Some(true)] => Some(Shape::Balanced),
        [Some(false), Some(true)] => Some(Shape::Rotating),
        [Some(true), Some(false)] => Some(Shape::CounterRotating),
        [Some(false), Some(false)] => None,
        _ => Some(Shape::NotDecided),
    };
    match (right, &claim.evidence) {
        (Some(right), _) if claim.shape != right => Err("the shape contradicts the verdicts".into()),
        (Some(_), None) => Ok(()),
        (Some(_), Some(_)) => Err("no moduli are compared, so no certificate belongs here".into()),
        (None, evidence) => compare(claim.shape, evidence.as_ref(), judged, motion),
    }
}

/// Both vectors are there.
fn compare(shape: Shape, evidence: Option<&ShapeEvidence>, judged: &Judged, motion: &Motion<'_>) -> Result<(), Reason> {
    let audit = motion.audit();
    match (shape, evidence, alone(judged)) {
        (Shape::Balanced | Shape::Rotating | Shape::CounterRotating | Shape::DoesNotExist, ..) => {
            Err("the shape contradicts the verdicts".into())
        }
        (Shape::Planar | Shape::Elliptical, Some(ShapeEvidence::Certificate(certificate)), Some(group)) => {
            let [direct, reverse] = [0, 1].map(|sense| &group.sums[sense].0);
            let difference = difference_of_squares(direct, reverse, audit)?;
            Ok(certify(&difference, shape == Shape::Planar, certificate, audit)?)
        }
        (_, None, Some(_)) => Err("a certificate that compares the two moduli is missing".into()),
        (_, _, Some(_)) => Err("one sum a vector, before the same coefficient: a certificate compares them".into()),
        (Shape::Planar, Some(ShapeEvidence::Mirror(mirror)), None) => check_mirror(mirror, judged, audit),
        (Shape::Elliptical, Some(ShapeEvidence::Bits(bits)), None) if !is_open(judged) => {
            match are_unequally_long(judged, *bits, motion)? {
                true => Ok(()),
                false => Err(format!("equal lengths are not excluded by an enclosure with {bits} bits").into()),
            }
        }
        (Shape::NotDecided, None, None) if is_open(judged) => Ok(()),
        (Shape::NotDecided, None, None) => match are_nearly_equally_long(judged, motion)? {
            true => Ok(()),
            false => Err("the two lengths are not so near to each other that it could be left open".into()),
        },
        (_, _, None) => Err("planar is shown by `mirror`, elliptical by `bits`, and `not-decided` by nothing".into()),
    }
}

/// The one sum that each vector comes to, before the same coefficient.
fn alone(judged: &Judged) -> Option<&JudgedGroup> {
    match (&judged.groups[..], &judged.left(0)[..], &judged.left(1)[..]) {
        ([only], ..) => Some(only),
        (_, [direct], [reverse]) if direct.coefficient == reverse.coefficient => Some(direct),
        _ => None,
    }
}

/// Whether a number of the motion is not known.
fn is_open(judged: &Judged) -> bool {
    let left = [0, 1].map(|sense| judged.left(sense));
    left.iter().flatten().any(|group| group.coefficient.is_open())
}

/// `direct = ± conj(reverse)` where it holds for the sums before each coefficient: those of the reverse vector are the
/// conjugates of those of the direct one.
fn check_mirror(mirror: &MirrorClaim, judged: &Judged, audit: &Audit) -> Result<(), Reason> {
    if ![1, -1].contains(&mirror.sign) {
        return Err("the sign of a mirror is 1 or -1".into());
    }
    let groups: Vec<&JudgedGroup> = judged.groups.iter().filter(|group| !group.is_zero).collect();
    if groups.len() != mirror.certificates.len() {
        return Err(format!("{} certificates for {} coefficients", mirror.certificates.len(), groups.len()).into());
    }
    let by = BigRational::from_integer(BigInt::from(-mirror.sign));
    for (group, certificate) in groups.into_iter().zip(&mirror.certificates) {
        let [direct, reverse] = [0, 1].map(|sense| &group.sums[sense].0);
        certify(&mirrored_away(direct, reverse, &by, audit)?, true, certificate, audit)?;
    }
    Ok(())
}

fn mirrored_away(
    direct: &Collected,
    reverse: &Collected,
    by: &BigRational,
    audit: &Audit,
) -> Result<Collected, Reason> {
    let images = reverse.iter().map(|(angle, weight)| (-angle, weight * by));
    let all = direct.iter().map(|(angle, weight)| (angle.clone(), weight.clone())).chain(images);
    Ok(collect(all, audit)?)
}
