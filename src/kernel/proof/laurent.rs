//! How are sums by the powers of one unknown taken together?

use std::collections::BTreeMap;

use num_rational::BigRational;
use num_traits::One;

use super::audit::{Audit, Reason};
use super::certificate::Certificate;
use super::check::certify;
use super::collected::{Collected, collect};
use super::unknown::{Unknown, product, turned};

/// Sums by the power of y before them.
pub(super) type Laurent = BTreeMap<i64, Collected>;

pub(super) fn doubled(class: &Laurent) -> Laurent {
    class.iter().map(|(power, sum)| (*power, twice(sum))).collect()
}

pub(super) fn twice(sum: &Collected) -> Collected {
    sum.iter().map(|(angle, weight)| (angle.clone(), weight + weight)).collect()
}

/// `conj(a) b − conj(c) d`.
pub(super) fn combined(pairs: [(&Laurent, &Laurent); 2], audit: &Audit) -> Result<Laurent, Reason> {
    let mut terms: BTreeMap<i64, Vec<(BigRational, BigRational)>> = BTreeMap::new();
    let one = BigRational::one();
    for ((a, b), sign) in pairs.into_iter().zip([one.clone(), -one]) {
        for (low, sum) in a {
            for (high, other) in b {
                let signed = product(sum, other, audit)?.into_iter().map(|(angle, weight)| (angle, weight * &sign));
                terms.entry(high - low).or_default().extend(signed);
            }
        }
    }
    terms.into_iter().map(|(power, terms)| Ok((power, collect(terms, audit)?))).collect()
}

/// The coefficients that are not zero, by their certificates.
pub(super) fn left_of(
    coefficients: impl ExactSizeIterator<Item = (i64, Collected)>,
    certificates: &[Certificate],
    audit: &Audit,
) -> Result<Vec<(i64, Collected)>, Reason> {
    if coefficients.len() != certificates.len() {
        return Err(format!("{} certificates for {} coefficients", certificates.len(), coefficients.len()).into());
    }
    let mut left = Vec::new();
    for ((power, sum), certificate) in coefficients.zip(certificates) {
        certify(&sum, certificate.claims_zero(), certificate, audit)?;
        if !certificate.claims_zero() {
            left.push((power, sum));
        }
    }
    Ok(left)
}

/// A class at a turn of u.
pub(super) fn value(class: &Laurent, turn: &BigRational, audit: &Audit) -> Result<Collected, Reason> {
    Ok(collect(turned(class.iter().map(|(times, sum)| (*times, sum)), turn, audit)?, audit)?)
}

/// The polynomial with these coefficients by the power of y, up to a power of y.
pub(super) fn of_powers(coefficients: &BTreeMap<i64, Collected>) -> Unknown<'_> {
    let lowest = coefficients.keys().next().copied().unwrap_or(0);
    let exponents = coefficients.keys().map(|power| power - lowest).collect();
    Unknown { exponents, sums: coefficients.values().collect() }
}
