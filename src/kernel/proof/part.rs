//! What is a part of a sum in unknowns, and does it cancel with others?

use num_rational::BigRational;

use super::alternative::AlternativeClaim;
use super::audit::{Audit, Reason, refuse_if};
use super::check::certify;
use super::collected::{Collected, collect, collected};
use super::open::PartClaim;

/// A part with its terms collected.
#[derive(Clone)]
pub(super) struct Part<'a> {
    pub claim: &'a PartClaim,
    pub sum: Collected,
}

impl Part<'_> {
    /// Its sum without unknowns.
    pub fn sum(&self) -> &Collected {
        &self.sum
    }

    /// How many times more than another part it is turned by φ and δ.
    pub fn turned_against(&self, other: &Part<'_>) -> [BigRational; 2] {
        [&self.claim.phi - &other.claim.phi, &self.claim.delta - &other.claim.delta]
    }
}

/// Checks the certificate of a part.
pub(super) fn check_part<'a>(claim: &'a PartClaim, audit: &Audit) -> Result<Part<'a>, Reason> {
    let sum = collected(&claim.terms, audit)?;
    certify(&sum, claim.certificate.claims_zero(), &claim.certificate, audit)?;
    Ok(Part { claim, sum })
}

/// Each condition is about how its part is turned against the first, and the parts turned so cancel.
pub(super) fn check_alternative(
    first: &Part<'_>,
    others: &[&Part<'_>],
    claim: &AlternativeClaim,
    audit: &Audit,
) -> Result<(), Reason> {
    refuse_if(claim.conditions.len() != others.len(), "there is one condition a part after the first")?;
    let mut terms: Vec<(BigRational, BigRational)> = first.sum.iter().map(|(t, w)| (t.clone(), w.clone())).collect();
    for (part, condition) in others.iter().zip(&claim.conditions) {
        let [phi, delta] = [&part.claim.phi - &first.claim.phi, &part.claim.delta - &first.claim.delta];
        if condition.phi != phi || condition.delta != delta {
            return Err("a condition is not about how its part is turned against the first".into());
        }
        terms.extend(part.sum.iter().map(|(angle, weight)| (angle + &condition.turn, weight.clone())));
    }
    Ok(certify(&collect(terms, audit)?, true, &claim.certificate, audit)?)
}
