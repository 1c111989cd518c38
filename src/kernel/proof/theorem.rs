//! What does a statement on every order say?

use num_bigint::BigInt;
use serde::{Deserialize, Serialize};

use super::certificate::Certificate;
use super::fraction;
use super::quantity::{Quantity, Sense};

/// The orders that do not vanish, out of those that exist: order 1 and the even ones.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Survivors {
    /// Whether order 1 is left.
    pub order_one: bool,
    /// What the even orders are taken modulo: even.
    pub modulus: u32,
    /// An even order is left where it is one of these modulo the modulus: even numbers from 0, rising.
    pub residues: Vec<u32>,
}

impl Survivors {
    /// Whether an order that exists is left.
    pub fn contains(&self, order: u32) -> bool {
        match order {
            1 => self.order_one,
            _ => self.residues.contains(&(order % self.modulus)),
        }
    }
}

/// A statement on one vector at every order that exists, with the verdicts of one period that prove it.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct TheoremClaim {
    /// Force or moment.
    pub quantity: Quantity,
    /// Direct or reverse.
    pub sense: Sense,
    /// The sum of order k depends on k only modulo this even number.
    #[serde(with = "fraction")]
    pub period: BigInt,
    /// The statement.
    pub survivors: Survivors,
    /// Order 1, and the even orders up to the period.
    pub verdicts: Vec<OrderClaim>,
}

/// Checks that verdicts are on these orders, one after the other; returns the first order that is beyond them.
pub(super) fn first_beyond(
    verdicts: &[OrderClaim],
    orders: impl IntoIterator<Item = u64>,
) -> Result<Option<u32>, String> {
    let mut found = verdicts.iter().map(|verdict| verdict.order);
    for order in orders {
        match found.next() {
            None => return Err(format!("order {order} is missing")),
            Some(other) if u64::from(other) != order => {
                return Err(format!("order {other} is in the place of order {order}"));
            }
            Some(_) => (),
        }
    }
    Ok(found.next())
}

/// The verdict on one order; its terms are those of the engine.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct OrderClaim {
    /// The order k.
    pub order: u32,
    /// Whether the sum is zero.
    pub vanishes: bool,
    /// The evidence.
    pub certificate: Certificate,
}
