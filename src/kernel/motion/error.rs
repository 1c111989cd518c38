//! Which slider-cranks are refused, and what would be right?

use num_rational::BigRational;

/// A slider-crank that cannot turn, or whose harmonics would take too long.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
pub enum NoFullTurn {
    /// The rod ratio is negative.
    #[error("the rod ratio r/l is {0}: it has to be at least 0 (0 stands for an infinitely long rod)")]
    NegativeRatio(BigRational),
    /// The sum λ + |δ| is 1 or more: the rod does not reach past the crank.
    #[error("r/l + |e|/l is {0}, so the crank cannot make a full turn: it has to be less than 1")]
    RodTooShort(BigRational),
    /// With an offset, the sum λ + |δ| is nearer to 1 than a millionth: the cost grows like `1/√(1 − λ − |δ|)`.
    #[error("with a pin offset r/l + |e|/l may be at most 0.999999, and it is {0}")]
    TooNearOne(BigRational),
}
