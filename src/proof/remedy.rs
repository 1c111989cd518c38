//! What does a remedy claim, and does it hold? The engine, the weights, and the corrected sums with their evidence.

use std::collections::{BTreeMap, BTreeSet};

use num_bigint::BigInt;
use num_rational::BigRational;
use num_traits::{One, Signed, Zero};
use serde::{Deserialize, Serialize};

use super::certificate::Certificate;
use super::check::{Collected, check_certificate, collect};
use super::document::{Fault, Quantity, Sense, Vector};
use super::fraction;

/// A remedy as data: what `verify` reads beside the verdicts on engines.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct RemedyDocument {
    /// Title of the engine.
    pub title: String,
    /// The orders that are claimed to vanish.
    pub remedied_orders: Vec<u32>,
    /// Position of the plane that moments are taken about.
    #[serde(with = "fraction")]
    pub reference_plane: BigRational,
    /// Whether the engine names its rods; else those of the cylinders stand for any.
    pub rods_known: bool,
    /// The cylinders.
    pub cylinders: Vec<RodCylinder>,
    /// The masses of the engine that turn.
    pub masses: Vec<TurningClaim>,
    /// The weights of the remedy.
    pub weights: Vec<WeightClaim>,
    /// The sums of the corrected engine.
    pub sums: Vec<CorrectedClaim>,
}

/// A rod, which names a coefficient c_k.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord, Serialize, Deserialize)]
pub struct RodClaim {
    /// λ = r/l.
    #[serde(with = "fraction")]
    pub ratio: BigRational,
    /// δ = e/l.
    #[serde(with = "fraction")]
    pub offset: BigRational,
}

/// A cylinder with its rod.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct RodCylinder {
    /// Crank-throw angle β in turns.
    #[serde(with = "fraction")]
    pub throw: BigRational,
    /// Bank angle α in turns.
    #[serde(with = "fraction")]
    pub bank: BigRational,
    /// Position z.
    #[serde(with = "fraction")]
    pub position: BigRational,
    /// Reciprocating mass times crank radius, in multiples of m r.
    #[serde(with = "fraction")]
    pub weight: BigRational,
    /// Its rod.
    pub rod: RodClaim,
}

/// A mass that turns at a multiple of the crank speed.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct TurningClaim {
    /// The multiple.
    pub order: u32,
    /// With the crank or against it.
    pub sense: Sense,
    /// Position z.
    #[serde(with = "fraction")]
    pub position: BigRational,
    /// Its direction at θ = 0, in turns.
    #[serde(with = "fraction")]
    pub angle: BigRational,
    /// Mass times radius, in multiples of m r.
    #[serde(with = "fraction")]
    pub mass_radius: BigRational,
}

/// A weight of the remedy: `Σ coefficient · Σ weight e^{2πi·angle}`, its mass-radius in multiples of m r.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct WeightClaim {
    /// Which multiple of the crank speed it turns at.
    pub order: u32,
    /// With the crank or against it.
    pub sense: Sense,
    /// Position z.
    #[serde(with = "fraction")]
    pub position: BigRational,
    /// Its parts.
    pub parts: Vec<WeightPart>,
}

/// The part of a weight with one coefficient.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct WeightPart {
    /// None is 1, else c_k of this rod.
    pub coefficient: Option<RodClaim>,
    /// The sum that it stands before.
    pub terms: Vec<Vector>,
}

/// One sum of the corrected engine, which is zero.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct CorrectedClaim {
    /// Force or moment.
    pub quantity: Quantity,
    /// The order k.
    pub order: u32,
    /// Direct or reverse.
    pub sense: Sense,
    /// None is 1, else c_k of this rod.
    pub coefficient: Option<RodClaim>,
    /// The sum, in multiples of m r.
    pub terms: Vec<Vector>,
    /// The evidence that it is zero.
    pub certificate: Certificate,
}

/// Checks that the sums of the corrected engine are those of its cylinders, masses and weights, that none is left out,
/// and that each is zero.
///
/// Returns how many certificates were checked.
///
/// # Errors
/// The first sum that does not hold.
pub fn check_remedy_document(document: &RemedyDocument) -> Result<usize, Fault> {
    if document.remedied_orders.is_empty() {
        return Err(Fault {
            place: "remedied_orders".into(),
            reason: "the list is empty, there is nothing to check".into(),
        });
    }
    let mut claimed = BTreeSet::new();
    for (index, claim) in document.sums.iter().enumerate() {
        let place =
            || format!("sums[{index}] ({}, order {}, {})", claim.quantity.name(), claim.order, claim.sense.name());
        let fault = |reason: String| Fault { place: place(), reason };
        let expected = document.expected(claim.quantity, claim.order, claim.sense);
        let expected = expected.get(&claim.coefficient).cloned().unwrap_or_default();
        let terms = collect(claim.terms.iter().map(|term| (term.angle.clone(), term.weight.clone())));
        if terms != expected {
            return Err(fault("its terms are not those of the engine and the weights".into()));
        }
        check_certificate(&claim.terms, true, &claim.certificate).map_err(|refusal| fault(refusal.to_string()))?;
        if !claimed.insert((claim.quantity, claim.order, claim.sense, claim.coefficient.clone())) {
            return Err(fault("this sum is in the list twice".into()));
        }
    }
    for &order in &document.remedied_orders {
        for (quantity, sense) in [Quantity::Force, Quantity::Moment]
            .into_iter()
            .flat_map(|quantity| [Sense::Direct, Sense::Reverse].map(|sense| (quantity, sense)))
        {
            let sums = document.expected(quantity, order, sense);
            let open = sums.into_keys().find(|key| !claimed.contains(&(quantity, order, sense, key.clone())));
            if open.is_some() {
                let place = format!("sums ({}, order {order}, {})", quantity.name(), sense.name());
                return Err(Fault { place, reason: "this sum is left out".into() });
            }
        }
    }
    Ok(document.sums.len())
}

impl RemedyDocument {
    /// The collected sums of one quantity, order and sense by coefficient (theory, sections 3 and 7).
    fn expected(&self, quantity: Quantity, order: u32, sense: Sense) -> BTreeMap<Option<RodClaim>, Collected> {
        let mut sums: BTreeMap<Option<RodClaim>, Vec<(BigRational, BigRational)>> = BTreeMap::new();
        let k = BigRational::from_integer(BigInt::from(order));
        let one = BigRational::one;
        let arm = |position: &BigRational| match quantity {
            Quantity::Moment => position - &self.reference_plane,
            Quantity::Force | Quantity::Torque => one(),
        };
        for cylinder in &self.cylinders {
            let Some((coefficient, sign)) = coefficient(&cylinder.rod, order) else { continue };
            let angle = match sense {
                Sense::Direct => &k * &cylinder.throw - (&k - one()) * &cylinder.bank,
                Sense::Reverse => (&k + one()) * &cylinder.bank - &k * &cylinder.throw,
            };
            let weight = &cylinder.weight * arm(&cylinder.position) * sign;
            sums.entry(coefficient).or_default().push((angle, weight));
        }
        let double = &k * &k * BigRational::from_integer(2.into());
        for mass in self.masses.iter().filter(|mass| (mass.order, mass.sense) == (order, sense)) {
            let weight = &double * &mass.mass_radius * arm(&mass.position);
            sums.entry(None).or_default().push((mass.angle.clone(), weight));
        }
        for weight in self.weights.iter().filter(|weight| (weight.order, weight.sense) == (order, sense)) {
            let share = &double * arm(&weight.position);
            for part in &weight.parts {
                let terms = part.terms.iter().map(|term| (term.angle.clone(), &term.weight * &share));
                sums.entry(part.coefficient.clone()).or_default().extend(terms);
            }
        }
        sums.into_iter().map(|(coefficient, terms)| (coefficient, collect(terms))).collect()
    }
}

/// The coefficient of a rod at an order, with a sign; none where it is zero. Centric rods have c_1 = 1 and no other odd
/// order; with the offset's sign the coefficients of odd orders above 1 change theirs.
fn coefficient(rod: &RodClaim, order: u32) -> Option<(Option<RodClaim>, BigRational)> {
    let centric = rod.offset.is_zero();
    let odd = order % 2 == 1;
    if order == 1 {
        return Some((if centric { None } else { Some(rod.clone()) }, BigRational::one()));
    }
    if rod.ratio.is_zero() || (centric && odd) {
        return None;
    }
    let sign = if rod.offset.is_negative() && odd { -BigRational::one() } else { BigRational::one() };
    Some((Some(RodClaim { ratio: rod.ratio.clone(), offset: rod.offset.abs() }), sign))
}
