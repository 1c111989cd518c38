//! Does the shape of what is left follow from the two vectors of an order?

use num_bigint::BigInt;
use num_rational::BigRational;
use serde::{Deserialize, Serialize};

use super::audit::{Audit, Reason, steps_of};
use super::certificate::Certificate;
use super::check::certify;
use super::coefficient::Coefficient;
use super::collected::{Collected, collect, difference_of_squares};
use super::judged::{Judged, JudgedGroup};
use super::motion::Motion;
use super::quantity::Quantity;
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
    /// Planar: each coefficient of `|direct|² − |reverse|²`, a quadratic form in the real numbers that the sums are multiplied by, is zero.
    Pairs(Vec<Certificate>),
    /// Elliptical: an enclosure with this many bits keeps `|direct|² − |reverse|²` away from zero.
    Bits(u32),
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
    pairs: Option<Vec<Certificate>>,
    #[serde(default, skip_serializing_if = "Option::is_none")]
    bits: Option<u32>,
}

impl TryFrom<WrittenShape> for ShapeClaim {
    type Error = &'static str;

    fn try_from(written: WrittenShape) -> Result<Self, Self::Error> {
        let WrittenShape { quantity, order, shape, certificate, pairs, bits } = written;
        let evidence = match (certificate, pairs, bits) {
            (None, None, None) => None,
            (Some(certificate), None, None) => Some(ShapeEvidence::Certificate(certificate)),
            (None, Some(pairs), None) => Some(ShapeEvidence::Pairs(pairs)),
            (None, None, Some(bits)) => Some(ShapeEvidence::Bits(bits)),
            _ => return Err("a shape has one of `certificate`, `pairs` and `bits`"),
        };
        Ok(ShapeClaim { quantity, order, shape, evidence })
    }
}

impl From<ShapeClaim> for WrittenShape {
    fn from(claim: ShapeClaim) -> Self {
        let ShapeClaim { quantity, order, shape, evidence } = claim;
        let mut written = WrittenShape { quantity, order, shape, certificate: None, pairs: None, bits: None };
        match evidence {
            Some(ShapeEvidence::Certificate(certificate)) => written.certificate = Some(certificate),
            Some(ShapeEvidence::Pairs(pairs)) => written.pairs = Some(pairs),
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
        (Shape::Planar, Some(ShapeEvidence::Pairs(pairs)), None) => check_pairs(pairs, judged, audit),
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
        (_, _, None) => Err("planar is shown by `pairs`, elliptical by `bits`, and `not-decided` by nothing".into()),
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

/// One certificate for each coefficient of `|direct|² − |reverse|²` that each is zero.
fn check_pairs(certificates: &[Certificate], judged: &Judged, audit: &Audit) -> Result<(), Reason> {
    let real = real_sums(judged, audit)?;
    let count = real.len() * (real.len() + 1) / 2;
    if certificates.len() != count {
        let numbers = real.len();
        return Err(format!("{} certificates for {count} pairs of {numbers} numbers", certificates.len()).into());
    }
    let mut certificates = certificates.iter();
    for (place, one) in real.iter().enumerate() {
        let of_pairs = real[place + 1..].iter().map(|other| of_pair(one, other, audit));
        let of_itself = difference_of_squares(&one[0], &one[1], audit).map_err(Reason::from);
        for (sum, certificate) in [of_itself].into_iter().chain(of_pairs).zip(certificates.by_ref()) {
            certify(&sum?, true, certificate, audit)?;
        }
    }
    Ok(())
}

/// Not collected: angles and weights.
type Terms = Vec<(BigRational, BigRational)>;

/// What each real number is multiplied by in the direct and in the reverse vector, in the order of their first group; groups that are zero in both omitted.
fn real_sums(judged: &Judged, audit: &Audit) -> Result<Vec<[Collected; 2]>, Reason> {
    let mut real: Vec<(Coefficient, [Terms; 2])> = Vec::new();
    for group in judged.groups.iter().filter(|group| !group.is_zero && group.sums.iter().any(|(_, is_zero)| !is_zero)) {
        for (number, turn) in group.coefficient.real_parts(judged.order) {
            let place = real.iter().position(|(known, _)| *known == number).unwrap_or_else(|| {
                real.push((number, [Vec::new(), Vec::new()]));
                real.len() - 1
            });
            for (sense, turn) in [turn.clone(), -turn].iter().enumerate() {
                let terms = group.sums[sense].0.iter().map(|(angle, weight)| (angle + turn, weight.clone()));
                real[place].1[sense].extend(terms);
            }
        }
    }
    let both = |[direct, reverse]: [Vec<_>; 2]| Ok([collect(direct, audit)?, collect(reverse, audit)?]);
    real.into_iter().map(|(_, sums)| both(sums)).collect()
}

/// `2 Re(D_a D̄_b − R_a R̄_b)` of two numbers.
fn of_pair(one: &[Collected; 2], other: &[Collected; 2], audit: &Audit) -> Result<Collected, Reason> {
    let mut terms = Vec::new();
    for (sense, sign) in [(0, 1), (1, -1)] {
        let sign = BigRational::from_integer(BigInt::from(sign));
        for (s, v) in &one[sense] {
            audit.spend(other[sense].len() as u64 * steps_of(s).max(steps_of(v)))?;
            for (t, w) in &other[sense] {
                let weight = v * w * &sign;
                terms.push((s - t, weight.clone()));
                terms.push((t - s, weight));
            }
        }
    }
    Ok(collect(terms, audit)?)
}
