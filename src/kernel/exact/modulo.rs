//! How does one compute modulo a prime, and which primes have a root of 1 of an order?

use num_integer::Integer;
use num_traits::ToPrimitive;
use smallvec::SmallVec;

/// The primes from a number on that are 1 modulo an order.
pub fn primes(order: u64, least: u64) -> impl Iterator<Item = u64> {
    (least / order + 1..).map(move |k| k * order + 1).filter(|&candidate| is_prime(candidate))
}

/// The product of two remainders.
pub fn multiply(a: u64, b: u64, modulus: u64) -> u64 {
    // Long words divide ten times slower, and only a modulus beyond all that is usual needs them.
    if modulus <= u64::from(u32::MAX) {
        return a * b % modulus;
    }
    let product = u128::from(a) * u128::from(b) % u128::from(modulus);
    product.to_u64().unwrap_or_else(|| unreachable!("a remainder is below its modulus"))
}

/// A power of a remainder.
pub fn power(base: u64, exponent: u64, modulus: u64) -> u64 {
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

/// Whether that power of a remainder is the first that is 1.
pub fn has_order(g: u64, order: u64, prime_divisors: &[u64], modulus: u64) -> bool {
    power(g, order, modulus) == 1 && prime_divisors.iter().all(|q| power(g, order / q, modulus) != 1)
}

fn is_prime(candidate: u64) -> bool {
    candidate > 1 && (2..).take_while(|d| d * d <= candidate).all(|d| !candidate.is_multiple_of(d))
}

/// The primes that divide a number, rising: each is taken out whole, and what is left at the root of the rest is one too.
pub fn prime_divisors(number: u64) -> SmallVec<[u64; 8]> {
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
