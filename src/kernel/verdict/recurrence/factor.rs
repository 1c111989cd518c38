//! At which orders of a parity is a sum of rays zero? All of a short period are decided, of a long one those that may be zero.

use num_bigint::BigInt;
use num_integer::Integer;
use num_traits::ToPrimitive;

use super::candidates::candidates;
use super::rays::Ray;
use crate::exact::PhasorSum;
use crate::proof::{Certificate, Zeros};
use crate::verdict::theorem::{LONGEST_PERIOD, LONGEST_SIEVED, NoTheorem};

/// A sum of rays at all orders of a parity.
#[derive(Clone, Debug)]
pub struct FactorPattern {
    /// Its terms, each direction once.
    pub rays: Vec<Ray>,
    /// Whether orders k and `k + period` are zero is the same: even.
    pub period: u32,
    /// Of one period all orders, or those that may be zero.
    pub judged: Vec<JudgedOrder>,
    /// Whether orders are omitted that cannot be zero.
    pub others_left: bool,
    zeros: Zeros,
}

/// The verdict on one order.
#[derive(Clone, Debug)]
pub struct JudgedOrder {
    /// The order.
    pub order: u32,
    /// The evidence.
    pub certificate: Certificate,
}

impl FactorPattern {
    /// Judges a factor at the orders with the parity of this one.
    pub(super) fn new(rays: Vec<Ray>, first_order: u32) -> Result<Self, NoTheorem> {
        let period = period(&rays);
        let short = period.to_u32().filter(|period| *period <= LONGEST_SIEVED);
        let period = short.ok_or(NoTheorem::PeriodTooLong(period))?;
        let others_left = period > LONGEST_PERIOD;
        let orders = match others_left {
            true => candidates(&rays, first_order, period).ok_or(NoTheorem::TooManyCandidates(period))?,
            false => (0..period / 2).map(|index| first_order + 2 * index).collect(),
        };
        let judge = |order: u32| {
            let sum = PhasorSum::new(rays.iter().map(|ray| ray.at(order)).collect());
            JudgedOrder { order, certificate: sum.certificate() }
        };
        let judged: Vec<JudgedOrder> = orders.into_iter().map(judge).collect();
        let zeros = shortest(&judged, period);
        Ok(FactorPattern { rays, period, judged, others_left, zeros })
    }

    /// Where it is zero.
    pub fn zeros(&self) -> &Zeros {
        &self.zeros
    }

    /// Whether it is zero at all orders of the parity.
    pub fn vanishes_always(&self) -> bool {
        self.zeros.modulus == 2 && !self.zeros.residues.is_empty()
    }
}

impl JudgedOrder {
    /// Whether the sum is zero.
    pub fn vanishes(&self) -> bool {
        self.certificate.claims_zero()
    }
}

/// The least even number that makes whole what the rays turn against the first one.
fn period(rays: &[Ray]) -> BigInt {
    let [first, others @ ..] = rays else { return BigInt::from(2) };
    let turns = others.iter().map(|ray| &ray.per_order - &first.per_order);
    turns.fold(BigInt::from(2), |period, turn| period.lcm(turn.denominator()))
}

/// The zeros with the least modulus that says so.
fn shortest(judged: &[JudgedOrder], period: u32) -> Zeros {
    let mut residues: Vec<u32> =
        judged.iter().filter(|order| order.vanishes()).map(|order| order.order % period).collect();
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
