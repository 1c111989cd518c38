//! How do parts of a sum stand where they cancel?

use num_rational::BigRational;
use serde::{Deserialize, Serialize};

use super::certificate::Certificate;
use super::fraction;

/// Turns of the parts after the first against the first at which they cancel.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct AlternativeClaim {
    /// One a part after the first.
    pub conditions: Vec<ConditionClaim>,
    /// Evidence that the parts turned so sum to zero.
    pub certificate: Certificate,
}

/// `phi·φ + delta·δ ≡ turn`, modulo a turn.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct ConditionClaim {
    /// How many times φ enters.
    #[serde(with = "fraction")]
    pub phi: BigRational,
    /// How many times δ enters.
    #[serde(with = "fraction")]
    pub delta: BigRational,
    /// What it must be.
    #[serde(with = "fraction")]
    pub turn: BigRational,
}
