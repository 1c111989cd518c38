//! Why is a certificate not accepted?

use std::fmt;

use num_bigint::BigInt;
use num_rational::BigRational;

/// A step is about one sum or product of fractions that fit into machine words.
pub const MOST_STEPS: u64 = 4_000_000;

/// More corners than this in one certificate are not expanded.
pub(super) const MOST_CORNERS: u64 = 100_000;

/// The order of a root is checked by the prime divisors of the conductor, found by trial division.
pub(super) const LARGEST_CONDUCTOR: u64 = 1_000_000;

/// Why a certificate is not accepted.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Refusal {
    /// The verdict says one thing and the certificate is of the kind for the other.
    WrongKind,
    /// A polygon of fewer than two sides.
    NoPolygon(u64),
    /// A polygon of weight zero, which adds nothing.
    EmptyPolygon,
    /// More corners than can be expanded.
    TooManyCorners,
    /// Polygons that do not add up to the terms; the angle where they differ, what the terms say, what the polygons say.
    PolygonsDiffer(Box<[BigRational; 3]>),
    /// A modulus that is not between 2 and 2⁶⁴.
    ModulusOutOfRange(BigInt),
    /// A conductor that is not between 1 and a million.
    ConductorOutOfRange(BigInt),
    /// A root whose multiplicative order is not the conductor modulo every divisor of the modulus.
    WrongOrder(BigInt),
    /// An angle that the conductor does not make whole.
    AngleNotWhole(BigRational),
    /// A weight that the scale does not make whole, or a scale that is not positive.
    WeightNotWhole(BigRational),
    /// Another residue than the one claimed: the one found.
    WrongResidue(u64),
    /// A residue of zero proves nothing.
    ZeroResidue,
    /// A step (from 1) of a splitting whose class need not vanish by itself; the prime that is missing from its modulus.
    ClassNotForced(usize, u64),
    /// A step of a splitting (from 1) whose class is taken modulo a number that is not positive.
    ModulusNotPositive(usize),
    /// A step of a splitting that compares what is no pair of classes of a prime up to a million.
    NoSuchClasses(usize),
    /// A step of a splitting whose prime divides the conductor twice.
    PrimeSquared(usize, u64),
    /// A splitting that does not end in one vector; how many are left.
    NotOneVector(usize),
    /// A check that would take too long.
    TooManySteps,
}

impl fmt::Display for Refusal {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Refusal::WrongKind => write!(f, "`vanishes` and the kind of the certificate contradict each other"),
            Refusal::NoPolygon(sides) => write!(f, "a polygon has {sides} sides; it needs at least two"),
            Refusal::EmptyPolygon => write!(f, "a polygon has the weight 0"),
            Refusal::TooManyCorners => write!(f, "the polygons have more than {MOST_CORNERS} corners"),
            Refusal::PolygonsDiffer(differ) => {
                let [angle, terms, polygons] = differ.as_ref();
                write!(f, "at angle {angle} the terms collect to {terms}, but the polygons to {polygons}")
            }
            Refusal::ModulusOutOfRange(modulus) => write!(f, "the modulus {modulus} is not from 2 to 2^64 - 1"),
            Refusal::ConductorOutOfRange(conductor) => {
                write!(f, "the conductor {conductor} is not in 1..={LARGEST_CONDUCTOR}")
            }
            Refusal::WrongOrder(root) => {
                write!(
                    f,
                    "the multiplicative order of the root {root} is not the conductor, or not modulo every factor of the modulus"
                )
            }
            Refusal::AngleNotWhole(angle) => write!(f, "the angle {angle} times the conductor is not whole"),
            Refusal::WeightNotWhole(weight) => write!(f, "the weight {weight} times a positive scale is not whole"),
            Refusal::WrongResidue(found) => write!(f, "the residue of the sum is {found}, not the one claimed"),
            Refusal::ZeroResidue => write!(f, "the residue is 0, which proves nothing"),
            Refusal::ClassNotForced(step, prime) => {
                write!(f, "step {step}: {prime} divides the conductor and must divide the modulus of the class")
            }
            Refusal::ModulusNotPositive(step) => write!(f, "step {step}: the modulus of a class is positive"),
            Refusal::NoSuchClasses(step) => {
                write!(f, "step {step}: it needs a prime up to a million and two different classes below that prime")
            }
            Refusal::PrimeSquared(step, prime) => write!(f, "step {step}: {prime} divides the conductor twice"),
            Refusal::NotOneVector(left) => write!(f, "the splitting ends in {left} vectors instead of one"),
            Refusal::TooManySteps => write!(f, "the check would take more than {MOST_STEPS} steps"),
        }
    }
}

impl std::error::Error for Refusal {}
