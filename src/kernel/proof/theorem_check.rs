//! Does one period prove a statement on every order?

use num_bigint::BigInt;
use num_integer::Integer;
use num_rational::BigRational;
use num_traits::{Signed, ToPrimitive, Zero};

use super::audit::{Audit, Reason, refuse_if};
use super::check::certify;
use super::collected::collect;
use super::document::Document;
use super::theorem::{Survivors, TheoremClaim, first_beyond};
use super::whole::prime_divisors;

/// Every angle is a whole multiple of `1/period`, so one verdict per class proves all; each is checked, then the statement.
/// Masses that turn with the crank make order 1 alone, which is stated separately.
pub(super) fn check_theorem(document: &Document, claim: &TheoremClaim, audit: &Audit) -> Result<(), Reason> {
    refuse_if(!document.has_equal_centric_rods(), "a statement on every order needs rods that are equal and centric")?;
    document.check_turning()?;
    check_period(document, &claim.period)?;
    check_orders(claim)?;
    for verdict in &claim.verdicts {
        let (quantity, order) = (claim.quantity, verdict.order);
        let groups = document.groups(quantity, order);
        let [group] = &groups[..] else { return Err(format!("order {order} has {} sums", groups.len()).into()) };
        audit.spend(document.steps_of_terms(order))?;
        let terms = document.terms(group, quantity, order, Some(claim.sense));
        let sum = collect(terms.into_iter().map(|(_, term)| (term.angle, term.weight)), audit)?;
        certify(&sum, verdict.vanishes, &verdict.certificate, audit)
            .map_err(|refusal| Reason::from(refusal).within(format!("order {order}")))?;
    }
    check_statement(claim)
}

fn check_period(document: &Document, period: &BigInt) -> Result<(), Reason> {
    if !period.is_positive() || period.is_odd() {
        return Err(format!("the period {period} is not a positive even number").into());
    }
    let times = BigRational::from_integer(period.clone());
    for cylinder in &document.cylinders {
        let angles = [&cylinder.throw, &cylinder.bank];
        if let Some(angle) = angles.into_iter().find(|&angle| !(angle * &times).is_integer()) {
            let name = &cylinder.name;
            return Err(format!("the period {period} times the angle {angle} of cylinder {name} is not whole").into());
        }
    }
    Ok(())
}

/// Order 1, and the even ones up to the period: one of each class.
fn check_orders(claim: &TheoremClaim) -> Result<(), Reason> {
    let even = |index: u32| 2 * index;
    let last = (&claim.period / 2_u32).to_u32().filter(|half| *half < u32::MAX / 2);
    let Some(last) = last else {
        return Err(format!("the period {} has more classes than verdicts", claim.period).into());
    };
    let orders = std::iter::once(1).chain((1..=last).map(even)).map(u64::from);
    match first_beyond(&claim.verdicts, orders)? {
        None => Ok(()),
        Some(order) => Err(format!("order {order} is beyond the period {}", claim.period).into()),
    }
}

/// The modulus is the least, and divides the period, so the statement is right once it is on every order of the list.
fn check_statement(claim: &TheoremClaim) -> Result<(), Reason> {
    let Survivors { modulus, residues, .. } = &claim.survivors;
    if *modulus == 0 || modulus.is_odd() || !(&claim.period % modulus).is_zero() {
        return Err(format!("the modulus {modulus} is not an even divisor of the period {}", claim.period).into());
    }
    let is_rising = residues.windows(2).all(|pair| pair[0] < pair[1]);
    if !is_rising || residues.iter().any(|residue| residue >= modulus || residue.is_odd()) {
        return Err(format!("the residues are not rising even numbers below {modulus}").into());
    }
    let repeats = |prime: &u64| {
        let step = u64::from(*modulus) / prime;
        let is_left = |residue: u64| residues.binary_search(&u32::try_from(residue).unwrap_or(u32::MAX)).is_ok();
        residues.iter().all(|&residue| is_left((u64::from(residue) + step) % u64::from(*modulus)))
    };
    if prime_divisors(u64::from(modulus / 2)).iter().any(repeats) {
        return Err(format!("the same is said with a smaller modulus than {modulus}").into());
    }
    match claim.verdicts.iter().find(|verdict| claim.survivors.contains(verdict.order) == verdict.vanishes) {
        Some(verdict) => Err(format!("order {}: the statement contradicts the verdict", verdict.order).into()),
        None => Ok(()),
    }
}
