//! Which reasons are there for a sum to vanish, or not?

use num_rational::BigRational;

use crate::exact::{Term, Turn};
use crate::numbers::Form;

/// The plainest reason for a verdict.
///
/// The reasons why a sum is not zero are about the vectors that are left where like and opposite directions are collected
/// ([`PhasorSum::on_lines`](crate::exact::PhasorSum::on_lines)): all have positive weights, and no two of them lie on one line.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Reason {
    /// All weights are zero: every arm, or every mass.
    NoWeight,
    /// Zero: a mirror plane across the crankshaft pairs cylinders with opposite arms.
    Mirror,
    /// Zero: like directions collect to nothing.
    Cancels,
    /// Zero: every vector has a partner, equally long and opposite, and the certificate is such pairs.
    OpposedPairs,
    /// Zero: the star, negative vectors turned by half a turn, maps to itself when turned by `1/fold` of a turn.
    Rotation {
        /// How many such turns make a whole one.
        fold: u32,
    },
    /// Zero: regular polygons, as the certificate lists them.
    Polygons,
    /// Not zero: one vector is left.
    OneVector(Term),
    /// Not zero: two vectors are left, and they do not lie on one line.
    TwoVectors([Term; 2]),
    /// Not zero: of three vectors the first is at least as long as the other two together.
    OneTooLong([Term; 3]),
    /// Not zero: three vectors are equally long, and not 120° apart.
    ThreeAlike([Term; 3]),
    /// Not zero: all vectors are within less than a quarter of a turn of this direction.
    OneSide {
        /// The direction.
        middle: Turn,
        /// How far the outermost ones are from it.
        within: Turn,
    },
    /// Not zero: the components along a direction add up to a positive number.
    Component(Component),
    /// Not zero: as the certificate shows.
    Certificate,
}

/// The components of the vectors along a direction, which add up to a positive number.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Component {
    /// The vectors that are left where like and opposite directions are collected.
    pub vectors: Vec<Term>,
    /// The direction.
    pub along: Turn,
    /// Whether the star is its own mirror image in the line of that direction, so that the sum lies on it.
    pub is_mirror_line: bool,
    /// What the components add up to.
    pub size: Size,
}

/// A positive number, and how it is known to be positive.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Size {
    /// A sum of square roots that is seen not to be zero: of one or two terms, or of positive ones.
    Roots(Form),
    /// It lies between these, both positive.
    Between(BigRational, BigRational),
}
