//! Which primes divide a number, and what are the powers of one modulo another? Numbers below 2⁶⁴.

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

/// By trial division: small numbers alone are asked for.
pub(super) fn is_prime(number: u64) -> bool {
    number > 1 && (2..).take_while(|divisor| divisor * divisor <= number).all(|divisor| !number.is_multiple_of(divisor))
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
