//! What is said of a sum in two unknowns over the whole torus? Boxes, and the zeros that are alone in theirs.

use num_rational::BigRational;
use serde::{Deserialize, Serialize};

use super::certificate::Certificate;
use super::fraction;

/// With `s = phi·φ` and `t = delta·δ`: the torus of s and t, cut into boxes.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct BoxesClaim {
    /// How many times φ enters s: by whole multiples of it, without common divisor, s turns the parts against each other.
    #[serde(with = "fraction")]
    pub phi: BigRational,
    /// How many times δ enters t, likewise.
    #[serde(with = "fraction")]
    pub delta: BigRational,
    /// A letter for each box, from the whole torus on: `s` and `t`, it is cut in two across s or t, and its halves follow, the first
    /// with all that it is cut into before the second; `0`, no zero; `1`, it is within the box of a zero; `?`, no claim.
    pub tree: String,
    /// Each zero with a box about it in which it is alone; no two of these boxes meet.
    pub zeros: Vec<BoxZeroClaim>,
}

/// A box with one zero.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct BoxZeroClaim {
    /// The middle of the box along s, in turns from 0 to 1.
    #[serde(with = "fraction")]
    pub s: BigRational,
    /// The same along t.
    #[serde(with = "fraction")]
    pub t: BigRational,
    /// How far it reaches to either side along s and t, in turns.
    #[serde(with = "fraction")]
    pub reach: BigRational,
    /// Where the middle itself is the zero: evidence that the sum vanishes there.
    pub certificate: Option<Certificate>,
}

impl BoxesClaim {
    /// Whether no box is open.
    pub(super) fn is_complete(&self) -> bool {
        !self.tree.contains('?')
    }
}
