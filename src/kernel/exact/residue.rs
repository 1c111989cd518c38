//! Which prime shows that a sum is not zero?
//!
//! Modulo a prime ℓ ≡ 1 (mod N) some whole number `g` has order N, and `e^{2πi/N} ↦ g` carries sums to sums. A sum
//! whose image is not zero is not zero (theory, section 5). The shortest reason is taken: the least such prime, and of it the least such root.

use num_traits::Zero;

use super::modulo::{has_order, multiply, power, prime_divisors, primes};
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
    primes(order, 0).find_map(|prime| {
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
