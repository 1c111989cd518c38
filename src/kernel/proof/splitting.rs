//! Does a splitting lead to one vector, each step keeping a part that would be zero if the whole were?

use num_bigint::BigInt;
use num_integer::Integer;
use num_rational::BigRational;
use num_traits::{One, Signed, Zero};

use super::audit::{Audit, refuse_if, squared_words, steps_of};
use super::certificate::Step;
use super::collected::{Collected, collect, common_multiple};
use super::refusal::Refusal;
use super::whole::is_prime;

/// Primes of a comparison are recognised by trial division. Those above the number of terms serve nothing, as a class is empty then.
const LARGEST_PRIME: u64 = 1_000_000;

/// One vector of non-zero weight is not zero.
pub(super) fn check_splitting(sum: &Collected, steps: &[Step], audit: &Audit) -> Result<(), Refusal> {
    let mut sum = sum.clone();
    for (index, step) in steps.iter().enumerate() {
        sum = match step {
            Step::Class { angle, modulus } => keep_class(&sum, angle, modulus, index + 1, audit)?,
            Step::Compare { prime, first, second } => compare(&sum, *prime, (*first, *second), index + 1, audit)?,
        };
    }
    if sum.len() == 1 { Ok(()) } else { Err(Refusal::NotOneVector(sum.len())) }
}

/// x^p − ζ_M is irreducible over Q(ζ_M) where p divides M, and a prime above the number of terms leaves a class
/// empty: either way the classes vanish one by one, but for primes up to the number of terms that divide N once.
fn keep_class(
    sum: &Collected,
    angle: &BigRational,
    modulus: &BigInt,
    step: usize,
    audit: &Audit,
) -> Result<Collected, Refusal> {
    refuse_if(!modulus.is_positive(), Refusal::ModulusNotPositive(step))?;
    let conductor = common_denominator(sum, audit)?;
    let terms = sum.len() as u64;
    let member = steps_of(angle).max(squared_words(modulus));
    audit.spend(terms.saturating_mul(member.saturating_add((conductor.bits() + modulus.bits()) / 64 + 1)))?;
    let forced = |p: &u64| (&conductor % p).is_zero() && !(modulus % p).is_zero() && is_prime(*p);
    if let Some(prime) = (2..=terms).find(forced) {
        return Err(Refusal::ClassNotForced(step, prime));
    }
    let modulus = BigRational::from_integer(modulus.clone());
    let members = sum.iter().filter(|(t, _)| ((*t - angle) * &modulus).is_integer());
    collect(members.map(|(t, weight)| (t - angle, weight.clone())), audit)
}

/// 1 + x + … + x^{p−1} is irreducible over Q(ζ_M) where p does not divide M: all classes of a zero sum are equal.
fn compare(sum: &Collected, prime: u64, classes: (u64, u64), step: usize, audit: &Audit) -> Result<Collected, Refusal> {
    let (first, second) = classes;
    if prime > LARGEST_PRIME || !is_prime(prime) || first == second || first >= prime || second >= prime {
        return Err(Refusal::NoSuchClasses(step));
    }
    let p = BigInt::from(prime);
    let conductor = common_denominator(sum, audit)?;
    let (quotient, remainder) = conductor.div_rem(&p);
    let rest = if remainder.is_zero() { quotient } else { conductor };
    refuse_if((&rest % &p).is_zero(), Refusal::PrimeSquared(step, prime))?;
    audit.spend((sum.len() as u64).saturating_mul(2).saturating_mul(squared_words(&rest)))?;
    let inverse = (&rest % &p).modpow(&(&p - 2_u32).max(BigInt::one()), &p);
    let whole = BigRational::from_integer(&p * &rest);
    let part = |class: u64, sign: i64| {
        let corner = BigRational::new(class.into(), p.clone());
        let (p, whole, inverse) = (&p, &whole, &inverse);
        sum.iter().filter_map(move |(angle, weight)| {
            let exponent = (angle * whole).to_integer();
            let member = (exponent * inverse).mod_floor(p) == BigInt::from(class);
            member.then(|| (angle - &corner, weight * BigRational::from_integer(sign.into())))
        })
    };
    collect(part(first, 1).chain(part(second, -1)), audit)
}

fn common_denominator(sum: &Collected, audit: &Audit) -> Result<BigInt, Refusal> {
    let mut common = BigInt::one();
    for angle in sum.keys() {
        let words = |number: &BigInt| number.bits() / 64 + 1;
        audit.spend(words(&common).saturating_mul(words(angle.denom())))?;
        common = common_multiple(&common, angle.denom());
    }
    Ok(common)
}
