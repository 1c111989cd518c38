//! Is a number prime, what divides it, and what are its powers modulo a prime? Numbers below 2⁶⁴.

/// `a + b` modulo `modulus`.
pub(super) fn added(a: u64, b: u64, modulus: u64) -> u64 {
    reduced(u128::from(a) + u128::from(b), modulus)
}

/// `a·b` modulo `modulus`.
pub(super) fn multiplied(a: u64, b: u64, modulus: u64) -> u64 {
    reduced(u128::from(a) * u128::from(b), modulus)
}

fn reduced(number: u128, modulus: u64) -> u64 {
    let remainder = number % u128::from(modulus);
    u64::try_from(remainder).unwrap_or_else(|_| unreachable!("a remainder is below its modulus"))
}

/// `base^exponent` modulo `modulus`.
pub(super) fn power(base: u64, mut exponent: u64, modulus: u64) -> u64 {
    let (mut result, mut square) = (1 % modulus, base % modulus);
    while exponent > 0 {
        if exponent % 2 == 1 {
            result = multiplied(result, square, modulus);
        }
        square = multiplied(square, square, modulus);
        exponent /= 2;
    }
    result
}

/// The primes that divide a number, by trial division.
pub(super) fn prime_divisors(number: u64) -> Vec<u64> {
    let (mut left, mut divisors, mut candidate) = (number, Vec::new(), 2);
    while candidate * candidate <= left {
        if left % candidate == 0 {
            divisors.push(candidate);
            while left % candidate == 0 {
                left /= candidate;
            }
        }
        candidate += 1;
    }
    divisors.extend((left > 1).then_some(left));
    divisors
}

/// Miller–Rabin with the first twelve primes as bases, which decides every number below 2⁶⁴ (Sorenson and Webster 2015).
pub(super) fn is_prime(number: u64) -> bool {
    const BASES: [u64; 12] = [2, 3, 5, 7, 11, 13, 17, 19, 23, 29, 31, 37];
    if number < 2 || BASES.iter().any(|base| number.is_multiple_of(*base)) {
        return BASES.contains(&number);
    }
    let twos = (number - 1).trailing_zeros();
    let odd = (number - 1) >> twos;
    BASES.iter().all(|&base| {
        let mut at = power(base, odd, number);
        if at == 1 {
            return true;
        }
        for _ in 0..twos {
            if at == number - 1 {
                return true;
            }
            at = multiplied(at, at, number);
        }
        false
    })
}
