//! Does an order vanish in which several mechanisms have a part? Its sums, each before a number of its own, are decided together.
//!
//! The whole is zero where each sum is. Where one alone is left it is not, since its number is not zero. Where several are left
//! only their numbers could make them cancel: an enclosure proves that they do not, or tells how short the rest is; and so where the one that
//! is left is multiplied by a number that may be zero.

use num_rational::BigRational;

use super::balance::{Verdict, compared};
use crate::motion::Enclosure;
use crate::numbers;
use crate::order::{self, Coefficients, Factor};
use crate::proof::{Certificate, Shape, ShapeEvidence};

/// What the checker is told to enclose with: more than the coefficients here are known to.
const CLAIMED_BITS: u32 = 128;

/// Whether a vector vanishes that is made of several sums.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Outcome {
    /// Zero, proved: each of its sums is.
    Zero,
    /// Not zero, proved: one sum is left, and what it is multiplied by is not zero.
    NotZero,
    /// Not zero, proved by an enclosure of the whole.
    NotZeroByEnclosure {
        /// How many bits the checker is to enclose it with.
        bits: u32,
    },
    /// Only what the sums are multiplied by could make them cancel, and they do so to this length, in the unit of the vector.
    NotDecided {
        /// The vector is not longer than this.
        below: BigRational,
    },
    /// It depends on the rods, of which nothing is known.
    Open,
}

impl Outcome {
    /// Of one sum, which is multiplied by a number that is not zero.
    pub(super) fn of_one(verdict: &Verdict) -> Self {
        if verdict.vanishes() { Outcome::Zero } else { Outcome::NotZero }
    }

    /// Whether it is zero: none where that is not decided.
    pub fn vanishes(&self) -> Option<bool> {
        match self {
            Outcome::Zero => Some(true),
            Outcome::NotZero | Outcome::NotZeroByEnclosure { .. } => Some(false),
            Outcome::NotDecided { .. } | Outcome::Open => None,
        }
    }
}

/// Whether two are zero together: not where one is not, undecided where that is left open.
pub fn both_vanish(one: Option<bool>, other: Option<bool>) -> Option<bool> {
    match [one, other] {
        [Some(false), _] | [_, Some(false)] => Some(false),
        [Some(true), Some(true)] => Some(true),
        [None, _] | [_, None] => None,
    }
}

/// A sum with what it is multiplied by, and whether that is other than zero.
#[derive(Clone, Copy)]
pub(super) struct Part<'a> {
    pub factor: &'a Factor,
    pub exists: bool,
    pub verdict: &'a Verdict,
}

/// An order of the force or the moment, all its sums together.
#[derive(Clone, Debug)]
pub struct WholeOrder {
    /// Whether the vectors vanish, direct first.
    pub outcomes: [Outcome; 2],
    /// What is left.
    pub shape: Shape,
    /// The evidence that tells planar from elliptical, where neither vanishes.
    pub evidence: Option<ShapeEvidence>,
}

impl WholeOrder {
    /// Judges both vectors, whose parts are in the same order.
    pub(super) fn new([direct, reverse]: [&[Part]; 2], order: u32, known: &Coefficients) -> Self {
        let outcomes = [outcome(direct, order, known), outcome(reverse, order, known)];
        let (shape, evidence) = match outcomes.each_ref().map(Outcome::vanishes) {
            [Some(true), Some(true)] => (Shape::Balanced, None),
            [Some(false), Some(true)] => (Shape::Rotating, None),
            [Some(true), Some(false)] => (Shape::CounterRotating, None),
            [None, _] | [_, None] => (Shape::NotDecided, None),
            [Some(false), Some(false)] => match line_or_ellipse([direct, reverse], order, known) {
                Some((shape, evidence)) => (shape, Some(evidence)),
                None => (Shape::NotDecided, None),
            },
        };
        WholeOrder { outcomes, shape, evidence }
    }

    /// An order that no source has.
    pub(super) fn of_none() -> Self {
        WholeOrder { outcomes: [Outcome::Zero, Outcome::Zero], shape: Shape::DoesNotExist, evidence: None }
    }

    /// Whether both vectors are proved to vanish.
    pub fn is_balanced(&self) -> bool {
        matches!(self.shape, Shape::Balanced | Shape::DoesNotExist)
    }

    /// Whether some vector is proved not to vanish.
    pub fn is_left(&self) -> bool {
        self.outcomes.iter().any(|outcome| outcome.vanishes() == Some(false))
    }

    /// Whether it is decided of each vector whether it vanishes.
    pub fn is_decided(&self) -> bool {
        self.outcomes.iter().all(|outcome| outcome.vanishes().is_some())
    }
}

/// The parts that are not zero.
fn left<'a>(parts: &[Part<'a>]) -> Vec<Part<'a>> {
    parts.iter().copied().filter(|part| part.exists && !part.verdict.vanishes()).collect()
}

/// Whether a vector of these parts vanishes.
pub(super) fn outcome(parts: &[Part], order: u32, known: &Coefficients) -> Outcome {
    let left = left(parts);
    match left.as_slice() {
        [] => Outcome::Zero,
        [only] if !only.factor.may_be_zero() => Outcome::NotZero,
        _ => match enclosed(&left, order, known) {
            None => Outcome::Open,
            Some(sum) if !sum.iter().all(Enclosure::contains_zero) => {
                Outcome::NotZeroByEnclosure { bits: CLAIMED_BITS }
            }
            Some([re, im]) => Outcome::NotDecided { below: re.largest() + im.largest() },
        },
    }
}

/// `Σ coefficient · sum`, real and imaginary part; none where a coefficient is not known.
fn enclosed(parts: &[Part], order: u32, known: &Coefficients) -> Option<[Enclosure; 2]> {
    let pair = |part: &Part<'_>| known.in_sense(part.factor, order, part.verdict.sense);
    let coefficients = parts.iter().map(pair).collect::<Option<Vec<_>>>()?;
    Some(numbers::enclose_weighted(coefficients.into_iter().zip(parts.iter().map(|part| &part.verdict.sum))))
}

/// Whether two vectors that do not vanish are equally long, if that can be proved.
fn line_or_ellipse(
    [direct, reverse]: [&[Part]; 2],
    order: u32,
    known: &Coefficients,
) -> Option<(Shape, ShapeEvidence)> {
    let (of_direct, of_reverse) = (left(direct), left(reverse));
    if let ([one], [other]) = (of_direct.as_slice(), of_reverse.as_slice())
        && one.factor == other.factor
    {
        let (shape, certificate) = compared(&one.verdict.sum, &other.verdict.sum);
        return Some((shape, ShapeEvidence::Certificate(certificate)));
    }
    if let Some(certificates) = equally_long([direct, reverse], order) {
        return Some((Shape::Planar, ShapeEvidence::Pairs(certificates)));
    }
    let square = |parts: &[Part]| {
        let [re, im] = enclosed(parts, order, known)?;
        Some(re.product(&re).plus(&im.product(&im)))
    };
    let minus = BigRational::from_integer((-1).into());
    let difference = square(&of_direct)?.plus(&square(&of_reverse)?.times(&minus));
    (!difference.contains_zero()).then_some((Shape::Elliptical, ShapeEvidence::Bits(CLAIMED_BITS)))
}

/// Evidence that both vectors are equally long, whatever the numbers are that their sums are multiplied by.
fn equally_long([direct, reverse]: [&[Part]; 2], order: u32) -> Option<Vec<Certificate>> {
    let pairs = direct.iter().zip(reverse);
    let left = pairs.filter(|(one, other)| one.exists && !(one.verdict.vanishes() && other.verdict.vanishes()));
    let parts = left.map(|(one, other)| (one.factor, [one.verdict.sum.clone(), other.verdict.sum.clone()]));
    let certificates = order::difference_of_squares(parts, order).into_iter().map(|sum| sum.certificate());
    certificates.map(|certificate| certificate.claims_zero().then_some(certificate)).collect()
}
