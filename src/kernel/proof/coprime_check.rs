//! Does an identity modulo a prime show that a sum vanishes for no angle?
//!
//! Were `|x| = 1` and `P(x) = 0`, then also `P*(x) = x^d conj(P(x)) = 0`: the resultant of both, a whole combination of roots of
//! unity, would be zero, and so would be its image. With the leading coefficient of P kept that image is zero only where the images of
//! P and P* have a common factor, and `U P + V P* ≡ 1` excludes one.

use num_bigint::BigInt;
use num_integer::Integer;
use num_rational::BigRational;
use num_traits::{Signed, ToPrimitive};

use super::audit::{Audit, Reason, refuse_if, squared_words, steps_of};
use super::circle::CoprimeClaim;
use super::collected::Collected;
use super::part::Part;
use super::refusal::LARGEST_CONDUCTOR;
use super::unknown::Unknown;
use super::whole::{added, is_prime, multiplied, power, prime_divisors};

/// Larger primes are not tried by division.
const LARGEST_PRIME: u64 = 1 << 32;

/// Checks that the parts cancel for no angle.
pub(super) fn check_coprime(claim: &CoprimeClaim, left: &[Part<'_>], audit: &Audit) -> Result<(), Reason> {
    check_identity(claim, &Unknown::of(left, &claim.phi, &claim.delta, audit)?, audit)
}

/// Checks that a polynomial vanishes nowhere on the circle.
pub(super) fn check_identity(claim: &CoprimeClaim, unknown: &Unknown<'_>, audit: &Audit) -> Result<(), Reason> {
    refuse_if(claim.prime > LARGEST_PRIME, format!("the prime is at most {LARGEST_PRIME}"))?;
    audit.spend(LARGEST_PRIME.isqrt() / 64)?;
    refuse_if(!is_prime(claim.prime), format!("{} is not prime", claim.prime))?;
    if !(1..=LARGEST_CONDUCTOR).contains(&claim.conductor) {
        return Err(format!("the conductor is between 1 and {LARGEST_CONDUCTOR}").into());
    }
    audit.spend(30 + squared_words(&claim.scale))?;
    let order_divides = |n: u64| power(claim.root, n, claim.prime) == 1;
    let too_small = prime_divisors(claim.conductor).iter().any(|q| order_divides(claim.conductor / q));
    if claim.root >= claim.prime || !order_divides(claim.conductor) || too_small {
        return Err(format!("{} does not have the order {} modulo the prime", claim.root, claim.conductor).into());
    }
    let straight = image(unknown, claim, 1, audit)?;
    let mut mirrored = image(unknown, claim, -1, audit)?;
    mirrored.reverse();
    refuse_if(straight.last().is_none_or(|leading| *leading == 0), "the leading coefficient is 0 modulo the prime")?;
    let length = straight.len();
    if claim.u.len().max(claim.v.len()) > length || claim.u.iter().chain(&claim.v).any(|c| *c >= claim.prime) {
        return Err("the factors have more coefficients than the sum, or some that are not below the prime".into());
    }
    audit.spend((length * length * 2) as u64)?;
    let mut whole = vec![0; 2 * length];
    for (factor, of) in [(&claim.u, &straight), (&claim.v, &mirrored)] {
        for (i, a) in factor.iter().enumerate() {
            for (j, b) in of.iter().enumerate() {
                whole[i + j] = added(whole[i + j], multiplied(*a, *b, claim.prime), claim.prime);
            }
        }
    }
    match whole[0] == 1 && whole[1..].iter().all(|coefficient| *coefficient == 0) {
        true => Ok(()),
        false => Err("U P + V P* is not 1 modulo the prime".into()),
    }
}

/// The coefficients modulo the prime, or with −1 those of the conjugate sums.
fn image(unknown: &Unknown<'_>, claim: &CoprimeClaim, sign: i64, audit: &Audit) -> Result<Vec<u64>, Reason> {
    let mut image = vec![0; unknown.degree().to_usize().unwrap_or(0) + 1];
    for (exponent, sum) in unknown.exponents.iter().zip(&unknown.sums) {
        if let Some(place) = exponent.to_usize().and_then(|at| image.get_mut(at)) {
            *place = image_of(sum, claim, sign, audit)?;
        }
    }
    Ok(image)
}

fn image_of(sum: &Collected, claim: &CoprimeClaim, sign: i64, audit: &Audit) -> Result<u64, Reason> {
    let times_conductor = BigRational::from_integer(BigInt::from(claim.conductor) * sign);
    let scale = BigRational::from_integer(claim.scale.clone());
    let mut found = 0;
    for (angle, weight) in sum {
        audit.spend(4 + steps_of(angle) + steps_of(weight).saturating_mul(2) + squared_words(&claim.scale))?;
        let (exponent, whole) = (angle * &times_conductor, weight * &scale);
        if !exponent.is_integer() || !whole.is_integer() || !claim.scale.is_positive() {
            return Err("conductor and scale do not make every angle and every weight whole".into());
        }
        let modulo = |number: BigInt, modulus: u64| number.mod_floor(&BigInt::from(modulus)).to_u64().unwrap_or(0);
        let exponent = modulo(exponent.to_integer(), claim.conductor);
        let weight = modulo(whole.to_integer(), claim.prime);
        found = added(found, multiplied(weight, power(claim.root, exponent, claim.prime), claim.prime), claim.prime);
    }
    Ok(found)
}
