//! Which slider-cranks are refused, and what would be right?

use std::fmt;

use num_rational::BigRational;

/// A slider-crank that cannot turn, or whose harmonics would take too long.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum NoFullTurn {
    /// The rod ratio is negative.
    NegativeRatio(BigRational),
    /// The sum λ + |δ| is 1 or more: the rod does not reach past the crank.
    RodTooShort(BigRational),
    /// With an offset, the sum λ + |δ| is nearer to 1 than a millionth: the cost grows like `1/√(1 − λ − |δ|)`.
    TooNearOne(BigRational),
}

impl fmt::Display for NoFullTurn {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            NoFullTurn::NegativeRatio(ratio) => {
                write!(f, "the rod ratio r/l is {ratio}: it has to be at least 0 (0 stands for an infinitely long rod)")
            }
            NoFullTurn::RodTooShort(sum) => {
                write!(f, "r/l + |e|/l is {sum}, so the crank cannot make a full turn: it has to be less than 1")
            }
            NoFullTurn::TooNearOne(sum) => {
                write!(f, "with a pin offset r/l + |e|/l may be at most 0.999999, and it is {sum}")
            }
        }
    }
}

impl std::error::Error for NoFullTurn {}
