//! Does it follow from the parts of a sum that are left, when it vanishes?

use num_rational::BigRational;

use super::audit::{Audit, Reason};
use super::certificate::Certificate;
use super::check::certify;
use super::collected::{Collected, collect, collected, difference_of_squares};
use super::open::{AlternativeClaim, PartClaim, WhenClaim};

/// A part with its terms collected.
pub(super) struct Part<'a> {
    claim: &'a PartClaim,
    sum: Collected,
}

/// Checks the certificate of a part.
pub(super) fn check_part<'a>(claim: &'a PartClaim, audit: &Audit) -> Result<Part<'a>, Reason> {
    let sum = collected(&claim.terms, audit)?;
    certify(&sum, claim.certificate.claims_zero(), &claim.certificate, audit)?;
    Ok(Part { claim, sum })
}

/// Checks the claim on when a sum vanishes against its parts that do not vanish.
pub(super) fn check_when(when: &WhenClaim, left: &[Part<'_>], audit: &Audit) -> Result<(), Reason> {
    let contradiction = || Err(format!("{} parts do not vanish, which contradicts `when`", left.len()).into());
    match when {
        WhenClaim::Always => match left {
            [] => Ok(()),
            _ => contradiction(),
        },
        WhenClaim::Never => match left {
            [_] => Ok(()),
            _ => contradiction(),
        },
        WhenClaim::NotSolved => match left {
            [_, _, _, ..] => Ok(()),
            _ => contradiction(),
        },
        WhenClaim::UnequalLengths { certificate } => match left {
            [first, second] => check_lengths(first, second, false, certificate, audit),
            _ => contradiction(),
        },
        WhenClaim::EqualLengths { certificate } => match left {
            [first, second] => check_lengths(first, second, true, certificate, audit),
            _ => contradiction(),
        },
        WhenClaim::Where { alternatives, equal_lengths } => match left {
            [first, second] => two(first, second, alternatives, equal_lengths, audit),
            [first, second, third] => three([first, second, third], alternatives, equal_lengths, audit),
            _ => contradiction(),
        },
    }
}

/// `e^{i(x_2 − x_1)} = −S_1/S_2` has one solution: one congruence is all.
fn two(
    first: &Part<'_>,
    second: &Part<'_>,
    alternatives: &[AlternativeClaim],
    equal_lengths: &[Certificate],
    audit: &Audit,
) -> Result<(), Reason> {
    if !equal_lengths.is_empty() {
        return Err("two parts that cancel are equally long, so that no evidence for it belongs here".into());
    }
    match alternatives {
        [only] => check_alternative(first, &[second], only, audit),
        _ => Err("two parts cancel at one turn, so there is one alternative".into()),
    }
}

/// Three vectors of equal length sum to zero iff they stand 120° apart: in one order or the other.
fn three(
    [first, second, third]: [&Part<'_>; 3],
    alternatives: &[AlternativeClaim],
    equal_lengths: &[Certificate],
    audit: &Audit,
) -> Result<(), Reason> {
    let ([one, other], [with_second, with_third]) = (alternatives, equal_lengths) else {
        return Err("three parts need two alternatives, and evidence that they are equally long".into());
    };
    check_lengths(first, second, true, with_second, audit)?;
    check_lengths(first, third, true, with_third, audit)?;
    check_alternative(first, &[second, third], one, audit)?;
    check_alternative(first, &[second, third], other, audit)?;
    match one.conditions.iter().zip(&other.conditions).any(|(a, b)| (&a.turn - &b.turn).is_integer()) {
        true => Err("the two alternatives are the same".into()),
        false => Ok(()),
    }
}

fn check_lengths(
    a: &Part<'_>,
    b: &Part<'_>,
    equal: bool,
    certificate: &Certificate,
    audit: &Audit,
) -> Result<(), Reason> {
    let difference = difference_of_squares(&a.sum, &b.sum, audit)?;
    Ok(certify(&difference, equal, certificate, audit)?)
}

/// Each condition is about how its part is turned against the first, and the parts turned so cancel.
fn check_alternative(
    first: &Part<'_>,
    others: &[&Part<'_>],
    claim: &AlternativeClaim,
    audit: &Audit,
) -> Result<(), Reason> {
    if claim.conditions.len() != others.len() {
        return Err("there is one condition a part after the first".into());
    }
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
