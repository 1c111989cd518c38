//! Which prime shows that a sum is not zero?
//!
//! Modulo a prime ℓ ≡ 1 (mod N) some whole number `g` has order N, and `e^{2πi/N} ↦ g` carries sums to sums. A sum
//! whose image is not zero is not zero (theory, section 5). The shortest reason is taken: the least such prime, and of it the least such root.

use num_integer::Integer;
use num_traits::{ToPrimitive, Zero};
use smallvec::SmallVec;

use super::terms::{Exponent, Weight};
use crate::proof::Residue;

/// Conductors from here on are answered by a splitting: the search for a prime grows with the conductor.
pub(super) const CONDUCTOR_LIMIT: u64 = 1_000_000;

/// Of primes below this every root is tried.
const MANY_ROOTS: u64 = 1000;

/// The residue certificate of a sum that is not zero; `None` where its conductor reaches [`CONDUCTOR_LIMIT`].
pub(super) fn find<E: Exponent, W: Weight>(conductor: &E, scale: &W, terms: &[(E, W)]) -> Option<Residue> {
    let order = conductor.to_u64().filter(|&n| n < CONDUCTOR_LIMIT)?;
    let divisors = prime_divisors(order);
    // A sum that is not zero has a norm that is not zero, and only its divisors can fail: the search ends.
    let primes = (1..).map(|k| k * order + 1).filter(|&prime| is_prime(prime));
    primes.into_iter().find_map(|prime| {
        let roots = (1..prime).filter(|&g| has_order(g, order, &divisors, prime));
        // The image by another root is that of a conjugate of the sum. Of a large prime one root is tried: it fails once in as many sums.
        let (root, residue) = roots
            .take(if prime < MANY_ROOTS { usize::MAX } else { 1 })
            .map(|root| (root, image(terms, root, prime)))
            .find(|(_, image)| !image.is_zero())?;
        Some(Residue {
            conductor: order.into(),
            prime: prime.into(),
            root: root.into(),
            scale: scale.clone().into(),
            residue: residue.into(),
        })
    })
}

/// The image of a sum modulo a prime.
fn image<E: Exponent, W: Weight>(terms: &[(E, W)], root: u64, prime: u64) -> u64 {
    terms.iter().fold(0, |sum, (exponent, weight)| {
        let exponent = exponent.to_u64().unwrap_or_else(|| unreachable!("an exponent is below the conductor"));
        (sum + multiply(weight.modulo(prime), power(root, exponent, prime), prime)) % prime
    })
}

/// The product of two remainders.
fn multiply(a: u64, b: u64, modulus: u64) -> u64 {
    // Long words divide ten times slower, and only a modulus beyond all that is usual needs them.
    if modulus <= u64::from(u32::MAX) {
        return a * b % modulus;
    }
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

/// The primes that divide a number, rising: each is taken out whole, and what is left at the root of the rest is one too.
fn prime_divisors(number: u64) -> SmallVec<[u64; 8]> {
    let (mut primes, mut rest, mut candidate) = (SmallVec::new(), number, 2);
    while candidate * candidate <= rest {
        if rest.is_multiple_of(candidate) {
            primes.push(candidate);
            while rest.is_multiple_of(candidate) {
                rest /= candidate;
            }
        }
        candidate += 1;
    }
    if rest > 1 {
        primes.push(rest);
    }
    primes
}
