//! Is a factor zero exactly at the orders that are stated? By one period of verdicts, or by those on the orders that may be zero.
//!
//! **Which may be zero.** Let n rays have weights that are rational and not zero, and R be the product of the primes up to n. If the sum is zero at
//! order k, then every ray i has another one j with `R·(angle_i − angle_j)` whole. For take a smallest vanishing part that holds i: no
//! part of it vanishes. Let L be least with all its angles, less that of i, in multiples of 1/L, and p a prime of L. The classes modulo p
//! vanish one by one where p² divides L, or where p is larger than the number of rays, as one is empty and all are equal: either way
//! there is one class alone, and L was not the least. So L divides R.

use num_bigint::BigInt;
use num_integer::Integer;
use num_rational::BigRational;
use num_traits::{One, Signed, ToPrimitive, Zero};

use super::audit::{Audit, Reason, steps_of};
use super::check::certify;
use super::collected::collect;
use super::recurrence::{FactorClaim, Parity, Rays, Zeros, collect_rays};
use super::theorem::first_beyond;
use super::whole::{is_prime, prime_divisors};

/// Longer periods are not gone through.
const LONGEST_PERIOD: u64 = 1_000_000;
/// So many marks of the sieve cost about what one sum of fractions costs.
const MARKS_A_STEP: u64 = 32;

/// What factors come to, multiplied out.
pub(super) fn expand(factors: &[FactorClaim], audit: &Audit) -> Result<Rays, Reason> {
    let mut product = collect_rays([([BigRational::zero(), BigRational::zero()], BigRational::one())]);
    for factor in factors {
        let pairs = (product.len() as u64).saturating_mul(factor.terms.len() as u64);
        let size = |ray: &super::recurrence::RayClaim| {
            steps_of(&ray.per_order).max(steps_of(&ray.fixed)).max(steps_of(&ray.weight))
        };
        let largest = factor.terms.iter().map(size).max().unwrap_or(1);
        audit.spend(pairs.saturating_mul(largest.saturating_mul(3)))?;
        let rays = product.iter().flat_map(|((per_order, fixed), weight)| {
            factor.terms.iter().map(move |ray| ([per_order + &ray.per_order, fixed + &ray.fixed], weight * &ray.weight))
        });
        product = collect_rays(rays);
    }
    Ok(product)
}

/// Period, orders, certificates and statement of a factor.
pub(super) fn check_factor(factor: &FactorClaim, parity: Parity, audit: &Audit) -> Result<(), Reason> {
    let rays: Vec<([&BigRational; 2], &BigRational)> =
        factor.terms.iter().map(|ray| ([&ray.per_order, &ray.fixed], &ray.weight)).collect();
    let collected =
        collect_rays(rays.iter().map(|(angles, weight)| (angles.map(BigRational::clone), (*weight).clone())));
    let written = rays.iter().map(|([per_order, fixed], weight)| (*per_order, *fixed, *weight));
    if !written.eq(collected.iter().map(|((per_order, fixed), weight)| (per_order, fixed, weight))) {
        return Err(
            "its terms are collected: each direction once, rising, angles from 0 to below 1, no weight 0".into()
        );
    }
    let period = period_of(factor)?;
    check_orders(factor, parity, period, audit)?;
    for verdict in &factor.judged {
        let order = BigRational::from_integer(verdict.order.into());
        let at_order =
            rays.iter().map(|([per_order, fixed], weight)| (*per_order * &order + *fixed, (*weight).clone()));
        let sum = collect(at_order, audit)?;
        certify(&sum, verdict.vanishes, &verdict.certificate, audit)
            .map_err(|refusal| Reason::from(refusal).within(format!("order {}", verdict.order)))?;
    }
    check_zeros(factor, parity, period)
}

/// From order k to order `k + period` all rays turn by the same angle.
fn period_of(factor: &FactorClaim) -> Result<u64, Reason> {
    let period = &factor.period;
    if !period.is_positive() || period.is_odd() {
        return Err(format!("the period {period} is not a positive even number").into());
    }
    let times = BigRational::from_integer(period.clone());
    if let [first, others @ ..] = factor.terms.as_slice() {
        let is_moved =
            |ray: &&super::recurrence::RayClaim| !((&ray.per_order - &first.per_order) * &times).is_integer();
        if let Some(ray) = others.iter().find(is_moved) {
            let (one, other) = (&first.per_order, &ray.per_order);
            return Err(format!("the period {period} times the angle between {one} and {other} is not whole").into());
        }
    }
    let whole = period.to_u64().filter(|period| *period <= LONGEST_PERIOD);
    whole.ok_or_else(|| format!("a period of {period} orders is too long, at most {LONGEST_PERIOD}").into())
}

/// The orders of one period from the first of the parity on: all of them, or exactly those that may be zero.
fn check_orders(factor: &FactorClaim, parity: Parity, period: u64, audit: &Audit) -> Result<(), Reason> {
    let orders = (u64::from(parity.first_order())..).step_by(2).take(usize::try_from(period / 2).unwrap_or(usize::MAX));
    let right: Vec<u64> = match factor.judged.len() as u64 == period / 2 {
        true => orders.collect(),
        false => orders
            .zip(sieve(factor, parity, period, audit)?)
            .filter(|(_, may_be)| *may_be)
            .map(|(order, _)| order)
            .collect(),
    };
    match first_beyond(&factor.judged, right)? {
        None => Ok(()),
        Some(order) => Err(format!("order {order} does not belong here").into()),
    }
}

/// Which orders of one period may be zero, by the lemma.
fn sieve(factor: &FactorClaim, parity: Parity, period: u64, audit: &Audit) -> Result<Vec<bool>, Reason> {
    let count = factor.terms.len() as u64;
    audit.spend((period / 2).saturating_mul(count).saturating_mul(count) / MARKS_A_STEP + 1)?;
    let product = (2..=count).filter(|p| is_prime(*p)).fold(BigInt::one(), |product, p| product * p);
    let times = BigRational::from_integer(product);
    let orders = usize::try_from(period / 2).unwrap_or_default();
    let mut all = vec![true; orders];
    for (place, one) in factor.terms.iter().enumerate() {
        let mut marked = vec![false; orders];
        for (_, other) in factor.terms.iter().enumerate().filter(|(other, _)| *other != place) {
            let angle = |k: u64| {
                let turned = (&one.per_order - &other.per_order) * BigRational::from_integer(k.into());
                (turned + &one.fixed - &other.fixed) * &times
            };
            let first = u64::from(parity.first_order());
            if let Some((start, step)) = whole_ones(&angle(first), &(angle(first + 2) - angle(first))) {
                marked.iter_mut().skip(start).step_by(step).for_each(|mark| *mark = true);
            }
        }
        all.iter_mut().zip(marked).for_each(|(all, marked)| *all &= marked);
    }
    Ok(all)
}

/// The t with `start + t·increase` whole: the first, and the step from each to the next.
fn whole_ones(start: &BigRational, increase: &BigRational) -> Option<(usize, usize)> {
    // Over the denominator of the increase the start has to be whole too.
    let over = increase.denom();
    let start = start * BigRational::from_integer(over.clone());
    if !start.is_integer() {
        return None;
    }
    let modulo = |number: &BigInt| number.mod_floor(over).to_u64();
    let (mut at, by, over) = (modulo(start.numer())?, modulo(increase.numer())?, over.to_u64()?);
    let step = usize::try_from(over).ok()?;
    let found = (0..step).find(|_| {
        let is_whole = at == 0;
        at = (at + by) % over;
        is_whole
    });
    found.map(|first| (first, step))
}

/// The modulus is the least, and the statement says of each order of the period what the verdicts say.
fn check_zeros(factor: &FactorClaim, parity: Parity, period: u64) -> Result<(), Reason> {
    let Zeros { modulus, residues } = &factor.zeros;
    let modulus = u64::from(*modulus);
    if modulus == 0 || modulus.is_odd() || !period.is_multiple_of(modulus) {
        return Err(format!("the modulus {modulus} is not an even divisor of the period {period}").into());
    }
    let is_odd = parity == Parity::Odd;
    let is_rising = residues.windows(2).all(|pair| pair[0] < pair[1]);
    if !is_rising || residues.iter().any(|residue| u64::from(*residue) >= modulus || residue.is_odd() != is_odd) {
        return Err(format!("the residues are not rising {} numbers below {modulus}", parity.name()).into());
    }
    let repeats = |prime: &u64| {
        let step = modulus / prime;
        let is_there =
            |residue: u64| u32::try_from(residue % modulus).is_ok_and(|it| residues.binary_search(&it).is_ok());
        step.is_even() && residues.iter().all(|&residue| is_there(u64::from(residue) + step))
    };
    if prime_divisors(modulus).iter().any(repeats) {
        return Err(format!("the same is said with a smaller modulus than {modulus}").into());
    }
    if let Some(verdict) = factor.judged.iter().find(|verdict| factor.zeros.contains(verdict.order) != verdict.vanishes)
    {
        return Err(format!("order {}: the statement contradicts the verdict", verdict.order).into());
    }
    let zeros = factor.judged.iter().filter(|verdict| verdict.vanishes).count() as u64;
    match zeros == residues.len() as u64 * (period / modulus) {
        true => Ok(()),
        false => Err("the statement has zeros among the residual orders".into()),
    }
}
