//! At which orders of a parity is a sum of rays zero? All of a short period are decided, of a long one those that may be zero.

use num_bigint::BigInt;
use num_integer::Integer;
use num_traits::ToPrimitive;

use super::candidates::candidates;
use super::rays::Ray;
use crate::exact::PhasorSum;
use crate::proof::{FactorClaim, OrderClaim, Zeros};
use crate::verdict::theorem::{LONGEST_PERIOD, LONGEST_SIEVED, NoTheorem};

/// A sum of rays at all orders of a parity.
#[derive(Clone, Debug)]
pub struct FactorPattern {
    /// Its terms, its verdicts, and its zeros.
    pub claim: FactorClaim,
    /// Its period, where orders are omitted that cannot be zero.
    pub sieved: Option<u32>,
}

impl FactorPattern {
    /// Judges a factor at the orders with the parity of this one.
    pub(super) fn new(mut rays: Vec<Ray>, first_order: u32) -> Result<Self, NoTheorem> {
        let period = period(&rays);
        let short = period.to_u32().filter(|period| *period <= LONGEST_SIEVED);
        let period = short.ok_or(NoTheorem::PeriodTooLong(period))?;
        let sieved = (period > LONGEST_PERIOD).then_some(period);
        let orders = match sieved {
            Some(_) => candidates(&rays, first_order, period).ok_or(NoTheorem::TooManyCandidates(period))?,
            None => (0..period / 2).map(|index| first_order + 2 * index).collect(),
        };
        let judge = |order: u32| {
            let sum = PhasorSum::new(rays.iter().map(|ray| ray.at(order)).collect());
            let certificate = sum.certificate();
            OrderClaim { order, vanishes: certificate.claims_zero(), certificate }
        };
        let judged: Vec<OrderClaim> = orders.into_iter().map(judge).collect();
        let zeros = shortest(&judged, period);
        rays.sort_by(|one, other| (&one.per_order, &one.fixed).cmp(&(&other.per_order, &other.fixed)));
        let terms = rays.into_iter().map(Ray::claim).collect();
        Ok(FactorPattern { claim: FactorClaim { terms, period: period.into(), judged, zeros }, sieved })
    }

    /// Whether it is zero at all orders of the parity.
    pub fn vanishes_always(&self) -> bool {
        self.claim.zeros.modulus == 2 && !self.claim.zeros.residues.is_empty()
    }
}

/// The least even number that makes whole what the rays turn against the first one.
fn period(rays: &[Ray]) -> BigInt {
    let [first, others @ ..] = rays else { return BigInt::from(2) };
    let turns = others.iter().map(|ray| &ray.per_order - &first.per_order);
    turns.fold(BigInt::from(2), |period, turn| period.lcm(turn.denominator()))
}

/// The zeros with the least modulus that says so.
fn shortest(judged: &[OrderClaim], period: u32) -> Zeros {
    let mut residues: Vec<u32> =
        judged.iter().filter(|order| order.vanishes).map(|order| order.order % period).collect();
    residues.sort_unstable();
    let repeats_after = |modulus: u32| {
        let is_there = |residue: u32| residues.binary_search(&(residue % period)).is_ok();
        residues.iter().all(|residue| is_there(residue + modulus))
    };
    let divides = |modulus: &u32| period.is_multiple_of(*modulus) && repeats_after(*modulus);
    let modulus = (1..=period / 2).map(|half| 2 * half).find(divides).unwrap_or(period);
    residues.retain(|residue| *residue < modulus);
    Zeros { modulus, residues }
}
