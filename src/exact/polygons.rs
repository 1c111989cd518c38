//! Which regular polygons make up a sum that is zero?
//!
//! Every vanishing sum with whole weights is a whole combination of rotated regular p-gons, p prime (Rédei 1950,
//! de Bruijn 1953, Schoenberg 1964). Several ways to find one are tried and the plainest result is kept.

use std::collections::BTreeMap;

use num_bigint::{BigInt, BigUint};
use num_rational::BigRational;
use num_traits::{One, Signed, Zero};

use super::collected::IntegerSum;
use super::decide::{collect, corner_in_class, primes_up_to};
use crate::proof::Polygon;

type Terms = Vec<(BigUint, BigInt)>;
/// Weights of polygons by (sides, exponent of the first corner).
type Found = BTreeMap<(u32, BigUint), BigInt>;

/// Polygons that add up to a vanishing sum: the fewest negative ones, then the fewest, then the least sides first.
pub(super) fn find(sum: &IntegerSum) -> Vec<Polygon> {
    let even = IntegerSum {
        conductor: &sum.conductor * 2_u32,
        scale: sum.scale.clone(),
        terms: sum.terms.iter().map(|(exponent, weight)| (exponent * 2_u32, weight.clone())).collect(),
    };
    let mut attempts: Vec<(&BigUint, Found)> = Vec::new();
    for rising in [true, false] {
        attempts.push((&sum.conductor, strip_then_split(&sum.terms, &sum.conductor, rising)));
        if sum.terms.iter().any(|(_, weight)| weight.is_negative()) {
            attempts.push((&even.conductor, with_negative_vectors_turned(&even, rising)));
        }
    }
    attempts.push((&sum.conductor, split(&sum.terms, &sum.conductor)));
    let cost = |found: &Found| (found.values().filter(|weight| weight.is_negative()).count(), found.len());
    let best = attempts.into_iter().min_by_key(|(_, found)| cost(found));
    best.map(|(conductor, found)| to_polygons(found, conductor, &sum.scale)).unwrap_or_default()
}

/// Takes whole polygons off, primes rising or falling, and splits what is left.
fn strip_then_split(terms: &Terms, conductor: &BigUint, rising: bool) -> Found {
    let (mut primes, _) = primes_up_to(terms.len(), conductor);
    if !rising {
        primes.reverse();
    }
    let mut left: BTreeMap<BigUint, BigInt> = terms.iter().cloned().collect();
    let mut found = Found::new();
    for &prime in &primes {
        let step = conductor / prime;
        for (first, _) in terms.iter().filter(|(exponent, _)| *exponent < step) {
            let corners: Vec<BigUint> = (0..prime).map(|j| first + &step * j).collect();
            let weights: Option<Vec<&BigInt>> = corners.iter().map(|corner| left.get(corner)).collect();
            let Some(weights) = weights else { continue };
            let Some(least) = weights.iter().min_by_key(|weight| weight.magnitude()).map(|weight| (*weight).clone())
            else {
                continue;
            };
            if weights.iter().any(|weight| weight.sign() != least.sign()) {
                continue;
            }
            for corner in &corners {
                if let Some(weight) = left.get_mut(corner) {
                    *weight -= &least;
                }
            }
            left.retain(|_, weight| !weight.is_zero());
            add(&mut found, prime, first.clone(), least, conductor);
        }
    }
    let rest: Terms = left.into_iter().collect();
    merge(&mut found, split(&rest, conductor), conductor);
    found
}

/// Turns each negative vector by half a turn: `−w` at `t` is `w` at `t + ½` less the pair `w` at `t` and `t + ½`.
fn with_negative_vectors_turned(sum: &IntegerSum, rising: bool) -> Found {
    let half = &sum.conductor / 2_u32;
    let turned = sum.terms.iter().map(|(exponent, weight)| match weight.is_negative() {
        true => ((exponent + &half) % &sum.conductor, -weight),
        false => (exponent.clone(), weight.clone()),
    });
    let mut found = strip_then_split(&collect(turned).into_vec(), &sum.conductor, rising);
    for (exponent, weight) in sum.terms.iter().filter(|(_, weight)| weight.is_negative()) {
        add(&mut found, 2, exponent.clone(), weight.clone(), &sum.conductor);
    }
    found
}

/// The decision of [`super::decide`] walked once more on a sum known to be zero, writing down the polygons.
fn split(terms: &Terms, conductor: &BigUint) -> Found {
    let mut found = Found::new();
    if terms.is_empty() {
        return found;
    }
    let (primes, product) = primes_up_to(terms.len(), conductor);
    let step = conductor / &product;
    for class in classes(terms, &step).values() {
        let first = &class[0].0;
        let reduced: Terms = class.iter().map(|(e, w)| ((e - first) / &step, w.clone())).collect();
        for ((sides, corner), weight) in split_squarefree(&reduced, &primes, &product) {
            add(&mut found, sides, first + corner * &step, weight, conductor);
        }
    }
    found
}

fn split_squarefree(terms: &Terms, primes: &[u32], conductor: &BigUint) -> Found {
    let mut found = Found::new();
    if terms.is_empty() {
        return found;
    }
    let Some((&largest, smaller)) = primes.split_last() else {
        unreachable!("a sum with one collected term is not zero")
    };
    let prime = BigUint::from(largest);
    let rest = conductor / &prime;
    let classes = classes(terms, &prime);
    // S_u over the conductor M = N/p, with the corner u/p that its terms are measured from.
    let aligned: Vec<(BigUint, Terms)> = classes
        .iter()
        .map(|(class, members)| {
            let corner = corner_in_class(class, &prime, &rest);
            let from_corner = |e: &BigUint| (e + conductor - &corner) % conductor / &prime;
            let terms = collect(members.iter().map(|(e, w)| (from_corner(e), w.clone()))).into_vec();
            (corner, terms)
        })
        .collect();
    // Where a class is empty all are zero; else all equal the shortest, which spans polygons of p sides.
    let shared: Terms = if classes.len() < largest as usize {
        Terms::new()
    } else {
        aligned.iter().map(|(_, terms)| terms).min_by_key(|terms| terms.len()).cloned().unwrap_or_default()
    };
    for (corner, members) in &aligned {
        let negated = shared.iter().map(|(e, w)| (e.clone(), -w));
        let difference = collect(members.iter().cloned().chain(negated)).into_vec();
        for ((sides, exponent), weight) in split_squarefree(&difference, smaller, &rest) {
            add(&mut found, sides, corner + exponent * &prime, weight, conductor);
        }
    }
    for (exponent, weight) in shared {
        add(&mut found, largest, exponent * &prime, weight, conductor);
    }
    found
}

/// The terms by the remainder of their exponent.
pub(super) fn classes(terms: &Terms, modulus: &BigUint) -> BTreeMap<BigUint, Terms> {
    let mut classes: BTreeMap<BigUint, Terms> = BTreeMap::new();
    for (exponent, weight) in terms {
        classes.entry(exponent % modulus).or_default().push((exponent.clone(), weight.clone()));
    }
    classes
}

/// Adds a polygon under its least corner, so that like polygons meet.
fn add(found: &mut Found, sides: u32, corner: BigUint, weight: BigInt, conductor: &BigUint) {
    let key = (sides, corner % (conductor / sides));
    let total = found.entry(key.clone()).or_insert_with(BigInt::zero);
    *total += weight;
    if total.is_zero() {
        found.remove(&key);
    }
}

fn merge(found: &mut Found, more: Found, conductor: &BigUint) {
    for ((sides, corner), weight) in more {
        add(found, sides, corner, weight, conductor);
    }
}

fn to_polygons(found: Found, conductor: &BigUint, scale: &BigInt) -> Vec<Polygon> {
    let conductor = BigInt::from(conductor.clone());
    debug_assert!(!conductor.is_zero() && scale >= &BigInt::one());
    found
        .into_iter()
        .map(|((sides, corner), weight)| Polygon {
            sides: sides.into(),
            rotation: BigRational::new(corner.into(), conductor.clone()),
            weight: BigRational::new(weight, scale.clone()),
        })
        .collect()
}
