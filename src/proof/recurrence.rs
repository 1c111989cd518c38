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

use super::audit::Reason;
use super::certificate::Certificate;
use super::check::certify;
use super::collected::{Collected, collect, turn};
use super::document::Document;
use super::engine::{Quantity, Sense};
use super::factor_check::{check_factor, expand};
use super::fraction;
use super::judged::{Judged, JudgedGroup};
use super::rod::Motion;
use super::source::{Group, Source};
use super::theorem::OrderClaim;
use super::whole_sum::{WholeClaim, WholeOutcome, check_whole};

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

/// Order 1 is decided as any other; for each parity the classes are those of its first order, as every other has the same.
pub(super) fn check_recurrence(
    document: &Document,
    claim: &RecurrenceClaim,
    motion: &Motion<'_>,
) -> Result<(), Reason> {
    if document.has_links() {
        return Err("a statement class by class needs rods on the crankpins, no links".into());
    }
    if document.turning_masses.iter().any(|mass| mass.order > 1) {
        return Err("a statement on every order needs masses that turn with the crank, or none".into());
    }
    if document.cylinders.iter().any(|cylinder| cylinder.speed != 1) {
        return Err("a statement on every order needs crankshafts that turn equally fast".into());
    }
    within("order 1", check_first(document, claim, motion))?;
    for (parity, classes) in [(Parity::Even, &claim.even), (Parity::Odd, &claim.odd)] {
        let groups = document.groups(claim.quantity, parity.first_order());
        let groups: Vec<&Group> = groups.iter().filter(|group| !group.is_zero && !group.sources.is_empty()).collect();
        if groups.len() != classes.len() {
            let (found, right) = (classes.len(), groups.len());
            return Err(format!("{} orders: {found} classes here, the engine has {right}", parity.name()).into());
        }
        for (index, (group, class)) in groups.into_iter().zip(classes).enumerate() {
            let place = format!("{} orders, class {index}", parity.name());
            within(&place, check_class(document, claim, group, class, parity, motion))?;
        }
    }
    Ok(())
}

/// Tells where a reason belongs.
pub(super) fn within<T>(place: &str, checked: Result<T, Reason>) -> Result<T, Reason> {
    checked.map_err(|reason| match reason {
        Reason::Wrong(words) => Reason::Wrong(format!("{place}: {words}")),
        Reason::TooManySteps => Reason::TooManySteps,
    })
}

fn check_first(document: &Document, claim: &RecurrenceClaim, motion: &Motion<'_>) -> Result<(), Reason> {
    let (quantity, audit) = (claim.quantity, motion.audit());
    let groups = document.groups(quantity, 1);
    if groups.len() != claim.first.sums.len() {
        return Err(format!("{} sums here, the engine has {}", claim.first.sums.len(), groups.len()).into());
    }
    let place = Sense::BOTH.iter().position(|sense| *sense == claim.sense).unwrap_or_default();
    let mut judged = Judged { quantity, order: 1, groups: Vec::new(), wholes: Vec::new() };
    for (group, verdict) in groups.into_iter().zip(&claim.first.sums) {
        let terms = document.terms(&group, quantity, 1, Some(claim.sense));
        let sum = collect(terms.into_iter().map(|(_, term)| (term.angle, term.weight)), audit)?;
        certify(&sum, verdict.vanishes, &verdict.certificate, audit)?;
        // Nothing is said here of the other sense.
        let mut sums = vec![(Collected::new(), true); Sense::BOTH.len()];
        sums[place] = (sum, verdict.vanishes);
        judged.groups.push(JudgedGroup { coefficient: group.coefficient, is_zero: group.is_zero, sums });
    }
    match (claim.first.outcome, judged.groups.len()) {
        (None, 1) => Ok(()),
        (Some(outcome), 2..) => {
            let whole = WholeClaim { quantity, order: 1, sense: Some(claim.sense), outcome };
            check_whole(&whole, &judged, place, motion).map(|_| ())
        }
        (None, _) => Err("`outcome` is missing: there are several sums".into()),
        (Some(_), _) => Err("`outcome` belongs to several sums: one is the whole".into()),
    }
}

/// The factors multiplied out are the terms of the class, and each tells its zeros.
fn check_class(
    document: &Document,
    claim: &RecurrenceClaim,
    group: &Group<'_>,
    class: &ClassClaim,
    parity: Parity,
    motion: &Motion<'_>,
) -> Result<(), Reason> {
    let audit = motion.audit();
    let terms = document.terms(group, claim.quantity, parity.first_order(), Some(claim.sense));
    let names: Vec<&String> = terms.iter().map(|(name, _)| name).collect();
    if !names.iter().copied().eq(&class.of) {
        return Err(format!("its cylinders are {names:?}").into());
    }
    let mut rays = Vec::new();
    for (source, (_, term)) in group.sources.iter().zip(terms) {
        let Source::Cylinder(cylinder, _) = source else { return Err("a term that is not of a cylinder".into()) };
        let per_order = match claim.sense {
            Sense::Direct => &cylinder.throw - &cylinder.bank,
            Sense::Reverse => &cylinder.bank - &cylinder.throw,
        };
        rays.push(([per_order, cylinder.bank.clone()], term.weight));
    }
    if class.factors.is_empty() {
        return Err("a class has one factor at least".into());
    }
    if expand(&class.factors, audit)? != collect_rays(rays) {
        return Err("the factors multiplied out are not the terms of the class".into());
    }
    for (index, factor) in class.factors.iter().enumerate() {
        within(&format!("factor {index}"), check_factor(factor, parity, audit))?;
    }
    Ok(())
}
