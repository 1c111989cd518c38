//! What is a term of a sum?

use num_rational::BigRational;
use serde::{Deserialize, Serialize};

use super::fraction;

/// One term of a sum: `weight · e^{2πi·angle}`.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Vector {
    /// Direction, in turns.
    #[serde(with = "fraction")]
    pub angle: BigRational,
    /// Length, of either sign.
    #[serde(with = "fraction")]
    pub weight: BigRational,
}
