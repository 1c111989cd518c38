//! How are sums by the powers of one unknown taken together?

use std::collections::BTreeMap;
use std::ops::RangeInclusive;

use num_rational::BigRational;
use num_traits::{One, ToPrimitive};

use super::audit::{Audit, Reason, demand, refuse_if, steps_of};
use super::certificate::Certificate;
use super::check::certify;
use super::collected::{Collected, collect};
use super::part::Part;
use super::unknown::{NOT_WHOLE, Unknown, check_positive, product, turned, whole_times};

/// Sums by the power of y before them.
pub(super) type Laurent = BTreeMap<i64, Collected>;

/// The parts by classes, those that are in no other being the first: each by the power of y before it, where the n-th other class is turned n
/// times by v. That is the angle from the first part of the first class to that of the second, and is no multiple of y's.
pub(super) fn split<const OTHERS: usize>(
    others: [&[usize]; OTHERS],
    u: [&BigRational; 2],
    left: &[Part<'_>],
    powers: RangeInclusive<i64>,
    audit: &Audit,
) -> Result<(Laurent, [Laurent; OTHERS]), Reason> {
    check_positive(u)?;
    let is_list = |class: &&[usize]| class.iter().all(|at| *at < left.len()) && class.is_sorted_by(|a, b| a < b);
    demand(others.iter().all(is_list), "a class is not a rising list of places of parts that do not vanish")?;
    let classes_of = |place: &usize| others.iter().filter(|class| class.contains(place)).count();
    refuse_if((0..left.len()).any(|place| classes_of(&place) > 1), "a part is in two classes")?;
    let first: Vec<usize> = (0..left.len()).filter(|place| classes_of(place) == 0).collect();
    refuse_if(first.is_empty() || others.iter().any(|class| class.is_empty()), "a class is empty")?;
    let start = &left[first[0]];
    let v = left[others[0][0]].turned_against(start);
    refuse_if(&v[0] * u[1] == &v[1] * u[0], "the classes are not turned against each other by an angle on its own")?;
    let of_class = |places: &[usize], turns: i64| -> Result<Laurent, Reason> {
        let mut class = Laurent::new();
        let turns = BigRational::from_integer(turns.into());
        for &place in places {
            let apart = left[place].turned_against(start);
            audit.spend(steps_of(&apart[0]) + steps_of(&apart[1]))?;
            let against = [0, 1].map(|axis: usize| &apart[axis] - &v[axis] * &turns);
            let times = whole_times(&against, u).ok_or(NOT_WHOLE)?;
            let times = times.to_i64().filter(|times| powers.contains(times));
            let times =
                times.ok_or_else(|| format!("u does not enter {} to {} times", powers.start(), powers.end()))?;
            let before = class.insert(times, left[place].sum().clone());
            refuse_if(before.is_some(), "two parts of a class are turned alike")?;
        }
        Ok(class)
    };
    let mut classes = others.map(|_| Laurent::new());
    for ((class, places), turns) in classes.iter_mut().zip(others).zip(1..) {
        *class = of_class(places, turns)?;
    }
    Ok((of_class(&first, 0)?, classes))
}

pub(super) fn doubled(class: &Laurent) -> Laurent {
    class.iter().map(|(power, sum)| (*power, twice(sum))).collect()
}

pub(super) fn twice(sum: &Collected) -> Collected {
    sum.iter().map(|(angle, weight)| (angle.clone(), weight + weight)).collect()
}

/// `conj(a) b − conj(c) d`.
pub(super) fn combined(pairs: [(&Laurent, &Laurent); 2], audit: &Audit) -> Result<Laurent, Reason> {
    combined_from(i64::MIN, pairs, audit)
}

/// `|a|² − |c|²`, which is real: its powers from 0 on.
pub(super) fn difference(a: &Laurent, c: &Laurent, audit: &Audit) -> Result<Laurent, Reason> {
    combined_from(0, [(a, a), (c, c)], audit)
}

fn combined_from(lowest: i64, pairs: [(&Laurent, &Laurent); 2], audit: &Audit) -> Result<Laurent, Reason> {
    let mut terms: BTreeMap<i64, Vec<(BigRational, BigRational)>> = BTreeMap::new();
    let one = BigRational::one();
    for ((a, b), sign) in pairs.into_iter().zip([one.clone(), -one]) {
        for (low, sum) in a {
            for (high, other) in b.range(low.saturating_add(lowest)..) {
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
