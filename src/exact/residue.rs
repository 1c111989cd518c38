//! Which prime shows that a sum is not zero?
//!
//! Modulo a prime ℓ ≡ 1 (mod N) some whole number `g` has order N, and `e^{2πi/N} ↦ g` carries sums to sums. A sum
//! whose image is not zero is not zero (theory, section 5). The least such prime and root are taken.

use num_bigint::BigInt;
use num_integer::Integer;
use num_traits::{One, ToPrimitive, Zero};

use super::collected::whole;
use super::sum::Term;
use crate::proof::Residue;

/// Conductors from here on are answered by a splitting: the search for a prime grows with the conductor.
pub(super) const CONDUCTOR_LIMIT: u64 = 1_000_000;

/// The residue certificate of a sum that is not zero; `None` where its conductor reaches [`CONDUCTOR_LIMIT`].
pub(super) fn find(terms: &[Term]) -> Option<Residue> {
    let conductor = terms.iter().fold(BigInt::one(), |n, term| n.lcm(term.angle.denominator()));
    let scale = terms.iter().fold(BigInt::one(), |s, term| s.lcm(term.weight.denom()));
    let order = conductor.to_u64().filter(|&n| n < CONDUCTOR_LIMIT)?;
    let divisors = prime_divisors(order);
    // A sum that is not zero has a norm that is not zero, and only its divisors can fail: the search ends.
    let primes = (1..).map(|k| k * order + 1).filter(|&prime| is_prime(prime));
    primes.into_iter().find_map(|prime| {
        let root = (1..prime).find(|&g| has_order(g, order, &divisors, prime))?;
        let residue = terms.iter().fold(0, |sum, term| {
            let exponent = whole(term.angle.turns(), &conductor).to_u64().unwrap_or(0);
            let weight = whole(&term.weight, &scale).mod_floor(&BigInt::from(prime)).to_u64().unwrap_or(0);
            (sum + multiply(weight, power(root, exponent, prime), prime)) % prime
        });
        (!residue.is_zero()).then(|| Residue {
            conductor: order.into(),
            prime: prime.into(),
            root: root.into(),
            scale: scale.clone(),
            residue: residue.into(),
        })
    })
}

fn multiply(a: u64, b: u64, modulus: u64) -> u64 {
    let product = u128::from(a) * u128::from(b) % u128::from(modulus);
    product.to_u64().unwrap_or_else(|| unreachable!("a remainder is below its modulus"))
}

fn power(base: u64, exponent: u64, modulus: u64) -> u64 {
    let (mut result, mut base, mut exponent) = (1 % modulus, base % modulus, exponent);
    while exponent > 0 {
        if exponent.is_odd() {
            result = multiply(result, base, modulus);
        }
        base = multiply(base, base, modulus);
        exponent /= 2;
    }
    result
}

fn has_order(g: u64, order: u64, prime_divisors: &[u64], modulus: u64) -> bool {
    power(g, order, modulus) == 1 && prime_divisors.iter().all(|q| power(g, order / q, modulus) != 1)
}

fn is_prime(candidate: u64) -> bool {
    candidate > 1 && (2..).take_while(|d| d * d <= candidate).all(|d| !candidate.is_multiple_of(d))
}

fn prime_divisors(number: u64) -> Vec<u64> {
    (2..=number).filter(|d| number.is_multiple_of(*d) && is_prime(*d)).collect()
}
