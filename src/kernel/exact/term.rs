//! What is one rotating vector? A rational weight at a rational angle.

use num_rational::BigRational;

use super::turn::Turn;

/// One rotating vector: `weight · e^{2πi·angle}`.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Term {
    /// Direction of the vector.
    pub angle: Turn,
    /// Length of the vector, of either sign, without unit.
    pub weight: BigRational,
}
