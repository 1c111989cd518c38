//! How many stars lose the moments of these orders? Theorems 5 and 8.

use num_bigint::BigUint;

use super::covers;
use super::factors::{divisors, prime_powers, two_primes};
use super::fate::Pins;

/// How many stars there are, with place 0 at direction 0.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Count {
    /// The stars.
    pub stars: BigUint,
    /// Up to rotation, mirror and reversal, where that is reported.
    pub classes: Option<BigUint>,
    /// By what they were counted.
    pub by: Counted,
}

/// By which theorem stars were counted.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Counted {
    /// There is none: lemma 2.
    None,
    /// Theorem 5: places are sums over these two primes.
    Sums([u32; 2]),
    /// After theorem 5: this many exact covers by sums over these two primes.
    Covers([u32; 2], BigUint),
    /// Theorem 8: the shaft is its own mirror image.
    MirrorImages,
}

/// The number of stars that lose the moments of all these orders, where a theorem counts them.
pub fn count(pins: Pins, orders: &[u32]) -> Option<Count> {
    if !pins.is_told() {
        return None;
    }
    let roots: Vec<u32> = orders.iter().map(|order| pins.root(*order)).filter(|root| *root > 1).collect();
    match pins.each {
        1 if !roots.is_empty() && roots.iter().all(|root| *root == pins.directions) => of_first_order(pins.directions),
        2 if divisors(pins.directions).into_iter().skip(1).all(|divisor| roots.contains(&divisor)) => {
            Some(mirror_images(pins.directions))
        }
        _ => None,
    }
}

/// The stars without a moment of order 1.
fn of_first_order(throws: u32) -> Option<Count> {
    if let Some([p, q]) = two_primes(throws) {
        let half = factorial(p - 1) * factorial(q - 1);
        let classes = (&half + every_other(p - 1) * every_other(q - 1)) / 2_u32;
        return Some(Count { stars: half * 2_u32, classes: Some(classes), by: Counted::Sums([p, q]) });
    }
    match prime_powers(throws)[..] {
        [_] => Some(Count { stars: BigUint::ZERO, classes: Some(BigUint::ZERO), by: Counted::None }),
        [p, q] => {
            let (p, q) = (p.prime, q.prime);
            let covers = covers::count(throws, p, q)?;
            let parts = throws / (p * q);
            let placings = (factorial(p) * factorial(q)).pow(parts);
            let stars = &covers * factorial(parts) * placings / throws;
            Some(Count { stars, classes: None, by: Counted::Covers([p, q], covers) })
        }
        _ => None,
    }
}

fn mirror_images(directions: u32) -> Count {
    let stars = factorial(directions.saturating_sub(1));
    // Each is its own reversal, and none of three or more directions its own mirror image.
    let classes = if directions > 2 { &stars / 2_u32 } else { stars.clone() };
    Count { stars, classes: Some(classes), by: Counted::MirrorImages }
}

fn factorial(number: u32) -> BigUint {
    (1..=number).map(BigUint::from).product()
}

/// `n (n − 2) ⋯ 2` of an even n, 1 of an odd one below 3: the placings of a set that is its own reversal on a prime number of directions, up to
/// rotation, that a mirror reverses.
fn every_other(number: u32) -> BigUint {
    match number {
        1 => BigUint::from(1_u32),
        _ => (1..=number / 2).map(|half| BigUint::from(2 * half)).product(),
    }
}
