//! Why is a certificate not accepted?

use num_bigint::BigInt;
use num_rational::BigRational;

/// A step is about one sum or product of fractions that fit into machine words.
pub const MOST_STEPS: u64 = 4_000_000;

/// More corners than this in one certificate are not expanded.
pub(super) const MOST_CORNERS: u64 = 100_000;

/// The order of a root is checked by the prime divisors of the conductor, found by trial division.
pub(super) const LARGEST_CONDUCTOR: u64 = 1_000_000;

/// Why a certificate is not accepted.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
pub enum Refusal {
    /// The verdict says one thing and the certificate is of the kind for the other.
    #[error("`vanishes` and the kind of the certificate contradict each other")]
    WrongKind,
    /// A polygon of fewer than two sides.
    #[error("a polygon has {0} sides; it needs at least two")]
    NoPolygon(u64),
    /// A polygon of weight zero, which adds nothing.
    #[error("a polygon has the weight 0")]
    EmptyPolygon,
    /// More corners than can be expanded.
    #[error("the polygons have more than {MOST_CORNERS} corners")]
    TooManyCorners,
    /// Polygons that do not add up to the terms; the angle where they differ, what the terms say, what the polygons say.
    #[error("at angle {} the terms collect to {}, but the polygons to {}", .0[0], .0[1], .0[2])]
    PolygonsDiffer(Box<[BigRational; 3]>),
    /// A modulus that is not between 2 and 2⁶⁴.
    #[error("the modulus {0} is not from 2 to 2^64 - 1")]
    ModulusOutOfRange(BigInt),
    /// A conductor that is not between 1 and a million.
    #[error("the conductor {0} is not in 1..={LARGEST_CONDUCTOR}")]
    ConductorOutOfRange(BigInt),
    /// A root whose multiplicative order is not the conductor modulo every divisor of the modulus.
    #[error("the multiplicative order of the root {0} is not the conductor, or not modulo every factor of the modulus")]
    WrongOrder(BigInt),
    /// An angle that the conductor does not make whole.
    #[error("the angle {0} times the conductor is not whole")]
    AngleNotWhole(BigRational),
    /// A weight that the scale does not make whole, or a scale that is not positive.
    #[error("the weight {0} times a positive scale is not whole")]
    WeightNotWhole(BigRational),
    /// Another residue than the one claimed: the one found.
    #[error("the residue of the sum is {0}, not the one claimed")]
    WrongResidue(u64),
    /// A residue of zero proves nothing.
    #[error("the residue is 0, which proves nothing")]
    ZeroResidue,
    /// A step (from 1) of a splitting whose class need not vanish by itself; the prime that is missing from its modulus.
    #[error("step {0}: {1} divides the conductor and must divide the modulus of the class")]
    ClassNotForced(usize, u64),
    /// A step of a splitting (from 1) whose class is taken modulo a number that is not positive.
    #[error("step {0}: the modulus of a class is positive")]
    ModulusNotPositive(usize),
    /// A step of a splitting that compares what is no pair of classes of a prime up to a million.
    #[error("step {0}: it needs a prime up to a million and two different classes below that prime")]
    NoSuchClasses(usize),
    /// A step of a splitting whose prime divides the conductor twice.
    #[error("step {0}: {1} divides the conductor twice")]
    PrimeSquared(usize, u64),
    /// A splitting that does not end in one vector; how many are left.
    #[error("the splitting ends in {0} vectors instead of one")]
    NotOneVector(usize),
    /// A check that would take too long.
    #[error("the check would take more than {MOST_STEPS} steps")]
    TooManySteps,
}
