//! What is said of a sum in two unknowns, as a triangle or as two classes of parts?

use num_rational::BigRational;
use serde::{Deserialize, Serialize};

use super::alternative::AlternativeClaim;
use super::certificate::Certificate;
use super::circle::CircleClaim;
use super::fraction;

/// Three parts that φ and δ turn against each other by two angles on their own: they cancel where they make a triangle.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct TriangleClaim {
    /// How many triangles have these sides.
    pub shape: TriangleShape,
    /// The triangles that are at rational turns, as far as any is claimed: what turns second and third part against the first.
    pub alternatives: Vec<AlternativeClaim>,
}

/// The sign of `2(ab + bc + ca) − a² − b² − c²`, which is 16 times the squared area, with `a = |S_1|²` and so on.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(tag = "kind", rename_all = "kebab-case", deny_unknown_fields)]
pub enum TriangleShape {
    /// Negative: one part is longer than the two others together.
    Never {
        /// An enclosure with this many bits shows it.
        bits: u32,
    },
    /// Zero: one triangle, which is flat.
    Flat {
        /// The evidence.
        certificate: Certificate,
    },
    /// Positive: two triangles, mirror images of each other.
    Two {
        /// An enclosure with this many bits shows it.
        bits: u32,
    },
}

/// With `u = phi·φ + delta·δ` and `y = e^{iu}` the sum is `A(y) + e^{iv} B(y)` up to a factor on the circle, v how the first part of
/// the second class is turned against that of the first, on its own: it vanishes where `|A|² = |B|²` and `e^{iv} = −A/B`, or A = B = 0.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct ClassesClaim {
    /// How many times φ enters u.
    #[serde(with = "fraction")]
    pub phi: BigRational,
    /// How many times δ enters u.
    #[serde(with = "fraction")]
    pub delta: BigRational,
    /// The places, among the parts that do not vanish, of those in the second class, rising.
    pub second: Vec<usize>,
    /// For every m from 0 on by which two parts of one class differ: evidence that the coefficient of `y^m` in `|A|² − |B|²` is zero,
    /// or that it is not. All are zero: A and B are equally long everywhere. Only that of m = 0 is not: nowhere.
    pub squares: Vec<Certificate>,
    /// Where a coefficient of m > 0 is not zero: where `|A|² − |B|²` vanishes.
    pub circle: Option<CircleClaim>,
    /// One for each `rational` arc of the circle, in their order.
    pub meetings: Vec<MeetingClaim>,
}

/// For which v the sum vanishes at a rational turn of u at which A and B are equally long. (At a `crossing` it is one v: A and B do not
/// both vanish there, for `|A|² − |B|²` would have a double zero.)
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(tag = "kind", rename_all = "kebab-case", deny_unknown_fields)]
pub enum MeetingClaim {
    /// For all: A and B vanish.
    All {
        /// The evidence.
        certificates: Box<[Certificate; 2]>,
    },
    /// For one, which is a rational turn.
    Rational {
        /// Evidence that A does not vanish.
        first: Certificate,
        /// The turn.
        #[serde(with = "fraction")]
        turn: BigRational,
        /// Evidence that the sum vanishes there.
        certificate: Box<Certificate>,
    },
    /// For one.
    Once {
        /// Evidence that A does not vanish.
        first: Certificate,
    },
}

impl ClassesClaim {
    /// Whether no arc is open.
    pub(super) fn is_complete(&self) -> bool {
        self.circle.as_ref().is_none_or(CircleClaim::is_complete)
    }
}
