//! What is said of a sum in one unknown over the whole circle? An identity modulo a prime, or arcs.

use num_bigint::BigInt;
use num_rational::BigRational;
use serde::{Deserialize, Serialize};

use super::certificate::Certificate;
use super::fraction;
use super::vector::Vector;

/// With `u = phi·φ + delta·δ` the sum is a polynomial P in `x = e^{iu}`: it and its mirror image `P* = x^d conj(P)` have no common
/// factor modulo a prime, as `U P + V P* ≡ 1`.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct CoprimeClaim {
    /// How many times φ enters u.
    #[serde(with = "fraction")]
    pub phi: BigRational,
    /// How many times δ enters u.
    #[serde(with = "fraction")]
    pub delta: BigRational,
    /// A common denominator of the angles.
    pub conductor: u64,
    /// A prime that is 1 modulo the conductor.
    pub prime: u64,
    /// A number whose order modulo the prime is the conductor.
    pub root: u64,
    /// A common denominator of the weights.
    #[serde(with = "fraction")]
    pub scale: BigInt,
    /// The coefficients of U modulo the prime, from the constant one on.
    pub u: Vec<u64>,
    /// Those of V.
    pub v: Vec<u64>,
}

/// With `u = phi·φ + delta·δ`: the whole circle, cut into arcs of u.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct CircleClaim {
    /// How many times φ enters u.
    #[serde(with = "fraction")]
    pub phi: BigRational,
    /// How many times δ enters u.
    #[serde(with = "fraction")]
    pub delta: BigRational,
    /// Where the arcs are not about the sum itself: the factor that they are about.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub divided: Option<DividedClaim>,
    /// Bits of the enclosures that show what the arcs claim.
    pub bits: u32,
    /// Where an arc is `monotone` or a `crossing`: evidence that the sum, turned back by half of its degree, stays on one line.
    pub mirrored: Vec<Certificate>,
    /// Where the first arc begins, in turns.
    #[serde(with = "fraction")]
    pub from: BigRational,
    /// Each begins where the one before ends; the last ends a turn after the first begins.
    pub arcs: Vec<ArcClaim>,
}

/// The sum is `Q F_1 F_2² F_3³ …`, Q vanishes nowhere on the circle, and the arcs are about `F_1 F_2 F_3 …`.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct DividedClaim {
    /// The coefficients of Q, from the constant one on.
    pub without: Vec<Vec<Vector>>,
    /// Evidence that Q vanishes for no angle.
    pub coprime: CoprimeClaim,
    /// Those of each F, the leading one 1.
    pub powers: Vec<Vec<Vec<Vector>>>,
    /// Evidence that each coefficient of the sum, from the constant one on, less that of the product is zero.
    pub equalities: Vec<Certificate>,
}

/// How often the sum vanishes on an arc, its ends among it.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(tag = "kind", rename_all = "kebab-case", deny_unknown_fields)]
pub enum ArcClaim {
    /// Never: a line keeps it away from 0.
    Free {
        /// Where the arc ends.
        #[serde(with = "fraction")]
        to: BigRational,
    },
    /// Never: on its line it moves one way, and both ends are on one side of 0.
    Monotone {
        /// Where the arc ends.
        #[serde(with = "fraction")]
        to: BigRational,
    },
    /// Once: on its line it moves one way, and the ends are on both sides of 0. No rational turn is a zero there.
    Crossing {
        /// Where the arc ends.
        #[serde(with = "fraction")]
        to: BigRational,
    },
    /// At one rational turn alone.
    Rational {
        /// Where the arc ends.
        #[serde(with = "fraction")]
        to: BigRational,
        /// The turn.
        #[serde(with = "fraction")]
        at: BigRational,
        /// Evidence that the sum, and its first derivatives by u, vanish there; the next one keeps away from 0 on the arc.
        certificates: Vec<Certificate>,
    },
    /// No claim.
    Open {
        /// Where the arc ends.
        #[serde(with = "fraction")]
        to: BigRational,
    },
}

impl ArcClaim {
    /// Where it ends.
    pub fn to(&self) -> &BigRational {
        match self {
            ArcClaim::Free { to }
            | ArcClaim::Monotone { to }
            | ArcClaim::Crossing { to }
            | ArcClaim::Rational { to, .. }
            | ArcClaim::Open { to } => to,
        }
    }
}

impl CircleClaim {
    /// The rational turns at which something stands.
    pub(super) fn rational(&self) -> Vec<&BigRational> {
        let turns = self.arcs.iter().filter_map(|arc| match arc {
            ArcClaim::Rational { at, .. } => Some(at),
            ArcClaim::Free { .. } | ArcClaim::Monotone { .. } | ArcClaim::Crossing { .. } | ArcClaim::Open { .. } => {
                None
            }
        });
        turns.collect()
    }

    /// Whether no arc is open.
    pub(super) fn is_complete(&self) -> bool {
        self.arcs.iter().all(|arc| match arc {
            ArcClaim::Free { .. }
            | ArcClaim::Monotone { .. }
            | ArcClaim::Crossing { .. }
            | ArcClaim::Rational { .. } => true,
            ArcClaim::Open { .. } => false,
        })
    }
}
