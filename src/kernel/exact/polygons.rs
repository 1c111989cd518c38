//! Which regular polygons make up a sum that is zero?
//!
//! Every vanishing sum with whole weights is a whole combination of rotated regular p-gons, p prime (Rédei 1950,
//! de Bruijn 1953, Schoenberg 1964). Several ways to find one are tried; of few vectors the fewest polygons are searched for ([`super::fewest`]).

use std::collections::BTreeMap;

use num_bigint::BigUint;
use num_rational::BigRational;

use super::decide::{collect, corner_in_class, primes_up_to};
use super::fewest;
use super::terms::{Exponent, Terms, Weight, classes};
use crate::proof::Polygon;

/// Weights of polygons by (sides, exponent of the first corner).
type Found<E, W> = BTreeMap<(u32, E), W>;

/// Polygons that add up to a vanishing sum: of few vectors the fewest, and then the fewest negative ones; of many, the fewest negative ones found.
pub(super) fn find<E: Exponent, W: Weight>(conductor: &E, scale: &W, terms: &[(E, W)]) -> Vec<Polygon> {
    let has_negative = terms.iter().any(|(_, weight)| weight.is_negative());
    let rising = strip_then_split(terms, conductor, true);
    let (primes, _) = primes_up_to(terms.len(), conductor);
    // Polygons of one prime are independent, so there is but one way: with pairs whatever the signs.
    if primes.len() < 2 && (primes.first() == Some(&2) || !has_negative) {
        return to_polygons(rising, conductor, scale);
    }
    let two = E::from(2);
    let twice = conductor.clone() * two.clone();
    let even: Terms<E, W> =
        terms.iter().map(|(exponent, weight)| (exponent.clone() * two.clone(), weight.clone())).collect();
    let mut attempts = vec![(conductor, rising)];
    if has_negative {
        attempts.push((&twice, with_negative_vectors_turned(&even, &twice, true)));
    }
    attempts.push((conductor, strip_then_split(terms, conductor, false)));
    if has_negative {
        attempts.push((&twice, with_negative_vectors_turned(&even, &twice, false)));
    }
    attempts.push((conductor, split(terms, conductor)));
    let cost = |found: &Found<E, W>| (found.values().filter(|weight| weight.is_negative()).count(), found.len());
    let best = attempts.into_iter().min_by_key(|(_, found)| cost(found));
    let Some((conductor_of_best, best)) = best else { return Vec::new() };
    // Two are the fewest: a sum that is one polygon was taken off whole.
    match (best.len() > 2).then(|| fewest::find(conductor, terms)).flatten() {
        Some(fewest) if fewest.polygons.len() < best.len() => {
            to_polygons(by_corner(fewest, conductor), conductor, scale)
        }
        _ => to_polygons(best, conductor_of_best, scale),
    }
}

fn by_corner<E: Exponent, W: Weight>(fewest: fewest::Fewest<E, W>, conductor: &E) -> Found<E, W> {
    let mut found = Found::new();
    for (sides, corner, weight) in fewest.polygons {
        add(&mut found, sides, corner, weight, conductor);
    }
    found
}

/// Takes whole polygons off, primes rising or falling, and splits what is left.
fn strip_then_split<E: Exponent, W: Weight>(terms: &[(E, W)], conductor: &E, rising: bool) -> Found<E, W> {
    let (mut primes, _) = primes_up_to(terms.len(), conductor);
    if !rising {
        primes.reverse();
    }
    // In order of the exponents; what is taken off stays with weight 0.
    let mut left: Terms<E, W> = terms.iter().cloned().collect();
    let mut found = Found::new();
    for &prime in &primes {
        let step = conductor.clone() / E::from(prime);
        for (first, _) in terms.iter().take_while(|(exponent, _)| *exponent < step) {
            let corner = |j: u32| first.clone() + step.clone() * E::from(j);
            let place = |j| left.binary_search_by(|(exponent, _)| exponent.cmp(&corner(j))).ok();
            let places: Option<Terms<usize, ()>> = (0..prime).map(|j| Some((place(j)?, ()))).collect();
            let Some(places) = places else { continue };
            let weights = || places.iter().map(|(place, ())| &left[*place].1);
            let Some(least) = weights().min_by_key(|weight| weight.abs()).cloned() else { continue };
            if least.is_zero() || weights().any(|weight| weight.signum() != least.signum()) {
                continue;
            }
            for (place, ()) in places {
                left[place].1 -= least.clone();
            }
            add(&mut found, prime, first.clone(), least, conductor);
        }
    }
    left.retain(|(_, weight)| !weight.is_zero());
    merge(&mut found, split(&left, conductor), conductor);
    found
}

/// Turns each negative vector by half a turn: `−w` at `t` is `w` at `t + ½` less the pair `w` at `t` and `t + ½`.
fn with_negative_vectors_turned<E: Exponent, W: Weight>(terms: &[(E, W)], conductor: &E, rising: bool) -> Found<E, W> {
    let half = conductor.clone() / E::from(2);
    let turned = terms.iter().map(|(exponent, weight)| match weight.is_negative() {
        true => ((exponent.clone() + half.clone()) % conductor.clone(), -weight.clone()),
        false => (exponent.clone(), weight.clone()),
    });
    let mut found = strip_then_split(&collect(turned), conductor, rising);
    for (exponent, weight) in terms.iter().filter(|(_, weight)| weight.is_negative()) {
        add(&mut found, 2, exponent.clone(), weight.clone(), conductor);
    }
    found
}

/// The decision of [`super::decide`] walked once more on a sum known to be zero, writing down the polygons.
fn split<E: Exponent, W: Weight>(terms: &[(E, W)], conductor: &E) -> Found<E, W> {
    let mut found = Found::new();
    if terms.is_empty() {
        return found;
    }
    let (primes, product) = primes_up_to(terms.len(), conductor);
    let step = conductor.clone() / product.clone();
    for class in classes(terms, &step).values() {
        let first = &class[0].0;
        let from_first = |e: &E| (e.clone() - first.clone()) / step.clone();
        let reduced: Terms<E, W> = class.iter().map(|(e, w)| (from_first(e), w.clone())).collect();
        for ((sides, corner), weight) in split_squarefree(&reduced, &primes, &product) {
            add(&mut found, sides, first.clone() + corner * step.clone(), weight, conductor);
        }
    }
    found
}

fn split_squarefree<E: Exponent, W: Weight>(terms: &[(E, W)], primes: &[u32], conductor: &E) -> Found<E, W> {
    let mut found = Found::new();
    if terms.is_empty() {
        return found;
    }
    let Some((&largest, smaller)) = primes.split_last() else {
        unreachable!("a sum with one collected term is not zero")
    };
    let prime = E::from(largest);
    let rest = conductor.clone() / prime.clone();
    let classes = classes(terms, &prime);
    // S_u over the conductor M = N/p, with the corner u/p that its terms are measured from.
    let aligned: Vec<(E, Terms<E, W>)> = classes
        .iter()
        .map(|(class, members)| {
            let corner = corner_in_class(class, &prime, &rest);
            let from_corner =
                |e: &E| (e.clone() + conductor.clone() - corner.clone()) % conductor.clone() / prime.clone();
            let terms = collect(members.iter().map(|(e, w)| (from_corner(e), w.clone())));
            (corner, terms)
        })
        .collect();
    // Where a class is empty all are zero; else all equal the shortest, which spans polygons of p sides.
    let shared: Terms<E, W> = if classes.len() < largest as usize {
        Terms::new()
    } else {
        aligned.iter().map(|(_, terms)| terms).min_by_key(|terms| terms.len()).cloned().unwrap_or_default()
    };
    for (corner, members) in &aligned {
        let negated = shared.iter().map(|(e, w)| (e.clone(), -w.clone()));
        let difference = collect(members.iter().cloned().chain(negated));
        for ((sides, exponent), weight) in split_squarefree(&difference, smaller, &rest) {
            add(&mut found, sides, corner.clone() + exponent * prime.clone(), weight, conductor);
        }
    }
    for (exponent, weight) in shared {
        add(&mut found, largest, exponent * prime.clone(), weight, conductor);
    }
    found
}

/// Adds a polygon under its least corner, so that like polygons meet.
fn add<E: Exponent, W: Weight>(found: &mut Found<E, W>, sides: u32, corner: E, weight: W, conductor: &E) {
    let key = (sides, corner % (conductor.clone() / E::from(sides)));
    let total = found.entry(key.clone()).or_insert_with(W::zero);
    *total += weight;
    if total.is_zero() {
        found.remove(&key);
    }
}

fn merge<E: Exponent, W: Weight>(found: &mut Found<E, W>, more: Found<E, W>, conductor: &E) {
    for ((sides, corner), weight) in more {
        add(found, sides, corner, weight, conductor);
    }
}

fn to_polygons<E: Exponent, W: Weight>(found: Found<E, W>, conductor: &E, scale: &W) -> Vec<Polygon> {
    assert!(!conductor.is_zero() && scale.is_positive());
    let polygon = |((sides, corner), weight): ((u32, E), W)| {
        // Both are reduced here, where they may be machine words.
        let (turn, part) = (corner.gcd(conductor), weight.gcd(scale));
        let exponent = |whole: E| -> BigUint { whole.into() };
        Polygon {
            sides: sides.into(),
            rotation: BigRational::new_raw(
                exponent(corner / turn.clone()).into(),
                exponent(conductor.clone() / turn).into(),
            ),
            weight: BigRational::new_raw((weight / part.clone()).into(), (scale.clone() / part).into()),
        }
    };
    found.into_iter().map(polygon).collect()
}
