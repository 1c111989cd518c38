//! Which powers of primes make up a whole number?

/// `prime^exponent`, the whole power of a prime in a number.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct PrimePower {
    /// The prime.
    pub prime: u32,
    /// How often it divides.
    pub exponent: u32,
}

impl PrimePower {
    /// The power itself.
    pub fn value(self) -> u32 {
        self.prime.pow(self.exponent)
    }
}

/// The prime powers of a number above 0, rising by their primes: none of 1.
pub fn prime_powers(number: u32) -> Vec<PrimePower> {
    let (mut left, mut powers, mut prime) = (number, Vec::new(), 2);
    while left > 1 {
        if prime * prime > left {
            prime = left;
        }
        let mut exponent = 0;
        while left.is_multiple_of(prime) {
            left /= prime;
            exponent += 1;
        }
        if exponent > 0 {
            powers.push(PrimePower { prime, exponent });
        }
        prime += 1;
    }
    powers
}

/// The divisors of a number above 0, rising.
pub(super) fn divisors(number: u32) -> Vec<u32> {
    (1..=number).filter(|divisor| number.is_multiple_of(*divisor)).collect()
}

/// Two different primes whose product a number is.
pub(super) fn two_primes(number: u32) -> Option<[u32; 2]> {
    match prime_powers(number)[..] {
        [PrimePower { prime: p, exponent: 1 }, PrimePower { prime: q, exponent: 1 }] => Some([p, q]),
        _ => None,
    }
}
