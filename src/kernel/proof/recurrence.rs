//! Which orders of all vanish, where the rods differ or have offsets, or the pattern is long? Told class by class.
//!
//! From order 2 on a vector of a cylinder is at `k·per_order + fixed`, and all cylinders whose rods have one λ and one |δ|
//! are multiplied by one number, which is not zero where the order exists; an offset below 0 changes the sign in odd orders. So even and odd orders have a sum each
//! for each class of rods, and an order is zero for every λ and δ exactly where these sums are.

use std::collections::BTreeMap;

use num_bigint::BigInt;
use num_rational::BigRational;
use num_traits::Zero;
use serde::{Deserialize, Serialize};

use super::certificate::Certificate;
use super::collected::turn;
use super::fraction;
use super::quantity::{Quantity, Sense};
use super::theorem::OrderClaim;
use super::whole_sum::WholeOutcome;

/// A statement on one vector at every order, class by class.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct RecurrenceClaim {
    /// Force or moment.
    pub quantity: Quantity,
    /// Direct or reverse.
    pub sense: Sense,
    /// Order 1, which has numbers of its own.
    pub first: FirstOrderClaim,
    /// The even orders: one class for each number that they are multiplied by, where it is not zero.
    pub even: Vec<ClassClaim>,
    /// The odd orders from 3 on; none where no rod has an offset.
    pub odd: Vec<ClassClaim>,
}

/// Order 1: its sums, in the order of their first source, and what they come to.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct FirstOrderClaim {
    /// Each sum.
    pub sums: Vec<SumVerdict>,
    /// The whole, where there are several sums.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub outcome: Option<WholeOutcome>,
}

/// Whether a sum is zero; its terms are those of the engine.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct SumVerdict {
    /// Whether it is zero.
    pub vanishes: bool,
    /// The evidence.
    pub certificate: Certificate,
}

/// The cylinders that are multiplied by one number, at all orders of one parity: their sum is the product of the factors.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct ClassClaim {
    /// The names of the cylinders.
    pub of: Vec<String>,
    /// The sum is zero at an order exactly where one of these is.
    pub factors: Vec<FactorClaim>,
}

/// A sum at all orders of one parity, with the verdicts that tell where it is zero.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct FactorClaim {
    /// Its terms, each direction once, rising by `per_order` and `fixed`.
    pub terms: Vec<RayClaim>,
    /// The lengths of order k and of order `k + period` are the same: even.
    #[serde(with = "fraction")]
    pub period: BigInt,
    /// Orders of the first period, from 2 or 3 on: all, or exactly those that may be zero.
    pub judged: Vec<OrderClaim>,
    /// The statement.
    pub zeros: Zeros,
}

/// A term that turns on by the same angle from order to order: at order k it is at `k·per_order + fixed`.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct RayClaim {
    /// In turns, from 0 to below 1.
    #[serde(with = "fraction")]
    pub per_order: BigRational,
    /// In turns, from 0 to below 1.
    #[serde(with = "fraction")]
    pub fixed: BigRational,
    /// Weight.
    #[serde(with = "fraction")]
    pub weight: BigRational,
}

/// The orders of one parity at which a factor is zero: these modulo the modulus.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Zeros {
    /// Even, and the least that says so.
    pub modulus: u32,
    /// Of the parity, rising, below the modulus.
    pub residues: Vec<u32>,
}

impl Zeros {
    /// Whether an order is among them.
    pub fn contains(&self, order: u32) -> bool {
        self.modulus > 0 && self.residues.binary_search(&(order % self.modulus)).is_ok()
    }
}

/// Whether orders are even or odd; the first of them above 1.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Parity {
    Even,
    Odd,
}

impl Parity {
    pub fn first_order(self) -> u32 {
        match self {
            Parity::Even => 2,
            Parity::Odd => 3,
        }
    }

    pub fn name(self) -> &'static str {
        match self {
            Parity::Even => "even",
            Parity::Odd => "odd",
        }
    }
}

/// Weights by `per_order` and `fixed`, both in `[0, 1)`, none zero.
pub(super) type Rays = BTreeMap<(BigRational, BigRational), BigRational>;

/// Collects rays.
pub(super) fn collect_rays(rays: impl IntoIterator<Item = ([BigRational; 2], BigRational)>) -> Rays {
    let mut all = Rays::new();
    for ([per_order, fixed], weight) in rays {
        *all.entry((turn(&per_order), turn(&fixed))).or_insert_with(BigRational::zero) += weight;
    }
    all.retain(|_, weight| !weight.is_zero());
    all
}
