//! What does a statement on every order say, and does one period prove it?

use std::collections::BTreeSet;

use num_bigint::BigInt;
use num_integer::Integer;
use num_rational::BigRational;
use num_traits::{Signed, Zero};
use serde::{Deserialize, Serialize};

use super::certificate::Certificate;
use super::check::check_certificate;
use super::document::{Document, Quantity, Sense};
use super::fraction;

/// The orders that do not vanish, out of those that exist: order 1 and the even ones.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
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
    /// Order 1, and one even order of each class modulo the period.
    pub verdicts: Vec<OrderClaim>,
}

/// The verdict on one order; its terms are those of the cylinders.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct OrderClaim {
    /// The order k.
    pub order: u32,
    /// Whether the sum is zero.
    pub vanishes: bool,
    /// The evidence.
    pub certificate: Certificate,
}

/// Every angle is a whole multiple of `1/period`, so one verdict a class proves all; each is checked, then the statement.
pub(super) fn check_theorem(document: &Document, claim: &TheoremClaim) -> Result<(), String> {
    if document.cylinders.is_empty() {
        return Err("a statement on every order needs the cylinders".into());
    }
    if claim.quantity == Quantity::Torque {
        return Err("a statement on every order is about force or moment".into());
    }
    check_period(document, &claim.period)?;
    check_classes(claim)?;
    for verdict in &claim.verdicts {
        let terms = document.terms(claim.quantity, verdict.order, Some(claim.sense));
        check_certificate(&terms, verdict.vanishes, &verdict.certificate)
            .map_err(|refusal| format!("order {}: {refusal}", verdict.order))?;
    }
    check_statement(claim)
}

fn check_period(document: &Document, period: &BigInt) -> Result<(), String> {
    if !period.is_positive() || period.is_odd() {
        return Err(format!("the period {period} is not a positive even number"));
    }
    let times = BigRational::from_integer(period.clone());
    for cylinder in &document.cylinders {
        let angles = [&cylinder.throw, &cylinder.bank];
        if let Some(angle) = angles.into_iter().find(|&angle| !(angle * &times).is_integer()) {
            return Err(format!(
                "the period {period} times the angle {angle} of cylinder {} is not whole",
                cylinder.name
            ));
        }
    }
    Ok(())
}

/// Order 1 once, and each even class modulo the period once.
fn check_classes(claim: &TheoremClaim) -> Result<(), String> {
    let (mut has_one, mut classes) = (false, BTreeSet::new());
    for &OrderClaim { order, .. } in &claim.verdicts {
        let is_new = match order {
            1 => !std::mem::replace(&mut has_one, true),
            _ if order == 0 || order.is_odd() => return Err(format!("there is no order {order}: 1 and the even ones")),
            _ => classes.insert(BigInt::from(order) % &claim.period),
        };
        if !is_new {
            return Err(format!("order {order}: its class is in the list twice"));
        }
    }
    if !has_one {
        return Err("order 1 is missing".into());
    }
    match BigInt::from(2 * classes.len()) == claim.period {
        true => Ok(()),
        false => Err(format!("{} even classes modulo the period {}, which has more", classes.len(), claim.period)),
    }
}

/// The modulus divides the period, so the statement is right once it is on every order of the list.
fn check_statement(claim: &TheoremClaim) -> Result<(), String> {
    let Survivors { modulus, residues, .. } = &claim.survivors;
    if *modulus == 0 || modulus.is_odd() || !(&claim.period % modulus).is_zero() {
        return Err(format!("the modulus {modulus} is not an even divisor of the period {}", claim.period));
    }
    let is_rising = residues.windows(2).all(|pair| pair[0] < pair[1]);
    if !is_rising || residues.iter().any(|residue| residue >= modulus || residue.is_odd()) {
        return Err(format!("the residues are not rising even numbers below {modulus}"));
    }
    match claim.verdicts.iter().find(|verdict| claim.survivors.contains(verdict.order) == verdict.vanishes) {
        Some(verdict) => Err(format!("order {}: the statement contradicts the verdict", verdict.order)),
        None => Ok(()),
    }
}
