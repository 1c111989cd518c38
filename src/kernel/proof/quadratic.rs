//! What is said of a sum in two unknowns as three classes of parts, a quadratic?

use num_rational::BigRational;
use serde::{Deserialize, Serialize};

use super::certificate::Certificate;
use super::circle::CircleClaim;
use super::fraction;
use super::plane::TriangleShape;

/// With `u = phi·φ + delta·δ` and `y = e^{iu}` the sum is `A(y) + B(y) x + C(y) x²` up to a factor on the circle, `x = e^{iv}`, v how the
/// first part of B is turned against that of A, on its own. Where it vanishes so does `(|A|² − |C|²)² − |conj(A) B − C conj(B)|²`.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct QuadraticClaim {
    /// How many times φ enters u.
    #[serde(with = "fraction")]
    pub phi: BigRational,
    /// How many times δ enters u.
    #[serde(with = "fraction")]
    pub delta: BigRational,
    /// The places, among the parts that do not vanish, of those in B, rising.
    pub second: Vec<usize>,
    /// The places of those in C, rising.
    pub third: Vec<usize>,
    /// For every m from 0 on that products of the parts lead to: evidence that the coefficient of `y^m` is zero, or that it is not. Only that
    /// of m = 0 is not: nowhere. All are zero: along a curve, one x for each u at which A and C differ in length; where they do not, none, one or
    /// two as `4|A|² − |B|²` is negative, zero or positive, and all or none where A = C = 0.
    pub coefficients: Vec<Certificate>,
    /// Along a curve, and beside a `twist`: the same for every coefficient of `|A|² − |C|²`. All are zero: A and C are equally long for every u.
    pub lengths: Vec<Certificate>,
    /// Where A and C are equally long for every u, and a coefficient of m > 0 is not zero: `conj(A) B − C conj(B)`, which the circle is about.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub twist: Option<TwistClaim>,
    /// Where a coefficient of m > 0 is not zero: where the polynomial vanishes.
    pub circle: Option<CircleClaim>,
    /// One for each `rational` arc of the circle, in their order. (At a `crossing` there is one x: A and C are not equally long there, for
    /// the polynomial would have a double zero. With a `twist`, as many as its `signs` say.)
    pub roots: Vec<RootsClaim>,
}

/// `E = conj(A) B − C conj(B)`, whose zeros are those of the polynomial where A and C are equally long for every u.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct TwistClaim {
    /// For every m that products of the parts lead to, rising: evidence that the coefficient of `y^m` in E is zero, or that it is not.
    pub coefficients: Vec<Certificate>,
    /// For each `crossing` of the circle, in their order: the sign that `4|A|² − |B|²` has where the arc begins, and on all of it. Positive: two x;
    /// negative: none.
    pub signs: Vec<TriangleShape>,
}

/// For which x on the circle the sum vanishes at a rational turn of u at which the polynomial does.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(tag = "kind", rename_all = "kebab-case", deny_unknown_fields)]
#[allow(clippy::large_enum_variant, reason = "there are few of them")]
pub enum RootsClaim {
    /// For all: A, B and C vanish.
    All {
        /// The evidence.
        certificates: Box<[Certificate; 3]>,
    },
    /// For none: A and C vanish, B does not.
    None {
        /// Evidence on A, B and C.
        certificates: Box<[Certificate; 3]>,
    },
    /// For one.
    One {
        /// Evidence that A and C are not equally long.
        lengths: Certificate,
        /// The x, if it is claimed to be a rational turn.
        at: Vec<RootClaim>,
    },
    /// For none, one or two, as the sign of `4|A|² − |B|²` says.
    Mirror {
        /// Evidence that A and C are equally long.
        lengths: Certificate,
        /// Evidence that A does not vanish.
        first: Certificate,
        /// The sign.
        shape: TriangleShape,
        /// Those x that are claimed to be rational turns.
        at: Vec<RootClaim>,
    },
}

/// A rational turn of x.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct RootClaim {
    /// The turn.
    #[serde(with = "fraction")]
    pub turn: BigRational,
    /// Evidence that the sum vanishes there.
    pub certificate: Certificate,
}

impl QuadraticClaim {
    /// Whether no arc is open.
    pub(super) fn is_complete(&self) -> bool {
        self.circle.as_ref().is_none_or(CircleClaim::is_complete)
    }
}
