//! Does a certificate prove what it claims? Checked with whole numbers, by rules a person could follow.

use std::collections::BTreeMap;
use std::fmt;

use num_bigint::BigInt;
use num_integer::Integer;
use num_rational::BigRational;
use num_traits::{One, Signed, ToPrimitive, Zero};

use super::certificate::{Certificate, Polygon, Residue, Step};
use super::document::Vector;

/// More corners than this in one certificate are not expanded.
const MOST_CORNERS: u64 = 100_000;
/// The order of a root is checked by the prime divisors of the conductor, found by trial division.
const LARGEST_CONDUCTOR: u64 = 1_000_000_000_000;

/// Why a certificate is not accepted.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Refusal {
    /// The verdict says one thing and the certificate is of the kind for the other.
    WrongKind,
    /// A polygon whose number of sides is not prime.
    SidesNotPrime(u64),
    /// More corners than can be expanded.
    TooManyCorners,
    /// Polygons that do not add up to the terms; the angle where they differ, what the terms say, what the polygons say.
    PolygonsDiffer(Box<[BigRational; 3]>),
    /// A modulus that is not a prime below 2⁶⁴.
    NotPrime(BigInt),
    /// A conductor that is not between 1 and 10¹².
    ConductorOutOfRange(BigInt),
    /// A root whose multiplicative order is not the conductor.
    WrongOrder(BigInt),
    /// An angle that the conductor does not make whole.
    AngleNotWhole(BigRational),
    /// A weight that the scale does not make whole, or a scale that is not positive.
    WeightNotWhole(BigRational),
    /// Another residue than the one claimed: the one found.
    WrongResidue(u64),
    /// A residue of zero proves nothing.
    ZeroResidue,
    /// A step (from 1) of a splitting whose class need not vanish by itself; the prime that is missing from its modulus.
    ClassNotForced(usize, u64),
    /// A step of a splitting (from 1) whose class is taken modulo a number that is not positive.
    ModulusNotPositive(usize),
    /// A step of a splitting that compares what is no pair of classes of a prime.
    NoSuchClasses(usize),
    /// A step of a splitting whose prime divides the conductor twice.
    PrimeSquared(usize, u64),
    /// A splitting that does not end in one vector; how many are left.
    NotOneVector(usize),
}

impl fmt::Display for Refusal {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Refusal::WrongKind => write!(f, "`vanishes` and the kind of the certificate contradict each other"),
            Refusal::SidesNotPrime(sides) => write!(f, "a polygon has {sides} sides, which is not a prime"),
            Refusal::TooManyCorners => write!(f, "the polygons have more than {MOST_CORNERS} corners"),
            Refusal::PolygonsDiffer(differ) => {
                let [angle, terms, polygons] = differ.as_ref();
                write!(f, "at angle {angle} the terms collect to {terms}, but the polygons to {polygons}")
            }
            Refusal::NotPrime(modulus) => write!(f, "{modulus} is not a prime below 2^64"),
            Refusal::ConductorOutOfRange(conductor) => write!(f, "the conductor {conductor} is not in 1..=10^12"),
            Refusal::WrongOrder(root) => write!(f, "the multiplicative order of the root {root} is not the conductor"),
            Refusal::AngleNotWhole(angle) => write!(f, "the angle {angle} times the conductor is not whole"),
            Refusal::WeightNotWhole(weight) => write!(f, "the weight {weight} times a positive scale is not whole"),
            Refusal::WrongResidue(found) => write!(f, "the sum is {found} modulo the prime, not the residue claimed"),
            Refusal::ZeroResidue => write!(f, "the residue is 0, which proves nothing"),
            Refusal::ClassNotForced(step, prime) => {
                write!(f, "step {step}: {prime} divides the conductor and must divide the modulus of the class")
            }
            Refusal::ModulusNotPositive(step) => write!(f, "step {step}: the modulus of a class is positive"),
            Refusal::NoSuchClasses(step) => write!(f, "step {step}: needs a prime and two different classes below it"),
            Refusal::PrimeSquared(step, prime) => write!(f, "step {step}: {prime} divides the conductor twice"),
            Refusal::NotOneVector(left) => write!(f, "the splitting ends in {left} vectors instead of one"),
        }
    }
}

impl std::error::Error for Refusal {}

/// Collected terms: weight by angle in `[0, 1)`, no weight zero.
pub(super) type Collected = BTreeMap<BigRational, BigRational>;

/// Checks that a certificate proves that the sum of these vectors is zero, or that it is not.
///
/// # Errors
/// The first rule that the certificate breaks.
pub fn check_certificate(terms: &[Vector], vanishes: bool, certificate: &Certificate) -> Result<(), Refusal> {
    if certificate.claims_zero() != vanishes {
        return Err(Refusal::WrongKind);
    }
    match certificate {
        Certificate::Polygons { polygons } => check_polygons(terms, polygons),
        Certificate::Residue(residue) => check_residue(terms, residue),
        Certificate::Splitting { steps } => check_splitting(terms, steps),
    }
}

pub(super) fn collect(vectors: impl IntoIterator<Item = (BigRational, BigRational)>) -> Collected {
    let mut collected = Collected::new();
    for (angle, weight) in vectors {
        let angle = &angle - angle.floor();
        *collected.entry(angle).or_insert_with(BigRational::zero) += weight;
    }
    collected.retain(|_, weight| !weight.is_zero());
    collected
}

fn pairs(terms: &[Vector]) -> impl Iterator<Item = (BigRational, BigRational)> + '_ {
    terms.iter().map(|term| (term.angle.clone(), term.weight.clone()))
}

/// The corners of a regular polygon sum to zero, so what expands into polygons is zero.
fn check_polygons(terms: &[Vector], polygons: &[Polygon]) -> Result<(), Refusal> {
    let mut corners = 0_u64;
    for polygon in polygons {
        corners = corners.saturating_add(polygon.sides);
        if corners > MOST_CORNERS {
            return Err(Refusal::TooManyCorners);
        }
        if !is_prime(polygon.sides) {
            return Err(Refusal::SidesNotPrime(polygon.sides));
        }
    }
    let expanded = polygons.iter().flat_map(|polygon| {
        (0..polygon.sides).map(|j| {
            let step = BigRational::new(j.into(), polygon.sides.into());
            (&polygon.rotation + step, polygon.weight.clone())
        })
    });
    let (wanted, found) = (collect(pairs(terms)), collect(expanded));
    let at = |sum: &Collected, angle: &BigRational| sum.get(angle).cloned().unwrap_or_else(BigRational::zero);
    match wanted.keys().chain(found.keys()).find(|angle| at(&wanted, angle) != at(&found, angle)) {
        Some(angle) => Err(Refusal::PolygonsDiffer(Box::new([angle.clone(), at(&wanted, angle), at(&found, angle)]))),
        None => Ok(()),
    }
}

/// `e^{2πi/N} ↦ root` respects sums and products, so a sum whose image is not zero is not zero.
fn check_residue(terms: &[Vector], claim: &Residue) -> Result<(), Refusal> {
    let prime = claim.prime.to_u64().filter(|&p| is_prime(p));
    let prime = prime.ok_or_else(|| Refusal::NotPrime(claim.prime.clone()))?;
    let modulus = BigInt::from(prime);
    let conductor = claim.conductor.to_u64().filter(|n| (1..=LARGEST_CONDUCTOR).contains(n));
    let conductor = conductor.ok_or_else(|| Refusal::ConductorOutOfRange(claim.conductor.clone()))?;
    let order_divides = |n: u64| claim.root.modpow(&n.into(), &modulus).is_one();
    if !order_divides(conductor) || prime_divisors(conductor).iter().any(|q| order_divides(conductor / q)) {
        return Err(Refusal::WrongOrder(claim.root.clone()));
    }
    let mut sum = BigInt::zero();
    for term in terms {
        let exponent = &term.angle * BigRational::from_integer(claim.conductor.clone());
        if !exponent.is_integer() {
            return Err(Refusal::AngleNotWhole(term.angle.clone()));
        }
        let weight = &term.weight * BigRational::from_integer(claim.scale.clone());
        if !weight.is_integer() || !claim.scale.is_positive() {
            return Err(Refusal::WeightNotWhole(term.weight.clone()));
        }
        let exponent = exponent.to_integer().mod_floor(&claim.conductor);
        sum += weight.to_integer() * claim.root.modpow(&exponent, &modulus);
    }
    let found = sum.mod_floor(&modulus);
    if found != claim.residue.mod_floor(&modulus) {
        return Err(Refusal::WrongResidue(found.to_u64().unwrap_or_default()));
    }
    if found.is_zero() { Err(Refusal::ZeroResidue) } else { Ok(()) }
}

/// Each step keeps a part that would be zero if the whole were; one vector of non-zero weight is not zero.
fn check_splitting(terms: &[Vector], steps: &[Step]) -> Result<(), Refusal> {
    let mut sum = collect(pairs(terms));
    for (index, step) in steps.iter().enumerate() {
        sum = match step {
            Step::Class { angle, modulus } => keep_class(&sum, angle, modulus, index + 1)?,
            Step::Compare { prime, first, second } => compare(&sum, *prime, (*first, *second), index + 1)?,
        };
    }
    if sum.len() == 1 { Ok(()) } else { Err(Refusal::NotOneVector(sum.len())) }
}

/// x^p − ζ_M is irreducible over Q(ζ_M) where p divides M, and a prime above the number of terms leaves a class
/// empty: either way the classes vanish one by one, but for primes up to the number of terms that divide N once.
fn keep_class(sum: &Collected, angle: &BigRational, modulus: &BigInt, step: usize) -> Result<Collected, Refusal> {
    if !modulus.is_positive() {
        return Err(Refusal::ModulusNotPositive(step));
    }
    let conductor = common_denominator(sum);
    let forced = |p: &u64| (&conductor % p).is_zero() && !(modulus % p).is_zero() && is_prime(*p);
    if let Some(prime) = (2..=sum.len() as u64).find(forced) {
        return Err(Refusal::ClassNotForced(step, prime));
    }
    let modulus = BigRational::from_integer(modulus.clone());
    let members = sum.iter().filter(|(t, _)| ((*t - angle) * &modulus).is_integer());
    Ok(collect(members.map(|(t, weight)| (t - angle, weight.clone()))))
}

/// 1 + x + … + x^{p−1} is irreducible over Q(ζ_M) where p does not divide M: all classes of a zero sum are equal.
fn compare(sum: &Collected, prime: u64, classes: (u64, u64), step: usize) -> Result<Collected, Refusal> {
    let (first, second) = classes;
    if !is_prime(prime) || first == second || first >= prime || second >= prime {
        return Err(Refusal::NoSuchClasses(step));
    }
    let p = BigInt::from(prime);
    let (rest, remainder) = common_denominator(sum).div_rem(&p);
    let rest = if remainder.is_zero() { rest } else { common_denominator(sum) };
    if (&rest % &p).is_zero() {
        return Err(Refusal::PrimeSquared(step, prime));
    }
    let inverse = rest.modpow(&(&p - 2_u32).max(BigInt::one()), &p);
    let part = |class: u64, sign: i64| {
        let corner = BigRational::new(class.into(), p.clone());
        let inverse = inverse.clone();
        let (p, rest) = (p.clone(), rest.clone());
        sum.iter().filter_map(move |(angle, weight)| {
            let exponent = (angle * BigRational::from_integer(&p * &rest)).to_integer();
            let member = (exponent * &inverse).mod_floor(&p) == BigInt::from(class);
            member.then(|| (angle - &corner, weight * BigRational::from_integer(sign.into())))
        })
    };
    Ok(collect(part(first, 1).chain(part(second, -1))))
}

fn common_denominator(sum: &Collected) -> BigInt {
    sum.keys().fold(BigInt::one(), |n, angle| n.lcm(angle.denom()))
}

fn prime_divisors(number: u64) -> Vec<u64> {
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
fn is_prime(number: u64) -> bool {
    const BASES: [u64; 12] = [2, 3, 5, 7, 11, 13, 17, 19, 23, 29, 31, 37];
    if number < 2 || BASES.iter().any(|base| number.is_multiple_of(*base)) {
        return BASES.contains(&number);
    }
    let modulus = BigInt::from(number);
    let minus_one = &modulus - 1_u32;
    let twos = (number - 1).trailing_zeros();
    let odd = BigInt::from((number - 1) >> twos);
    BASES.iter().all(|&base| {
        let mut power = BigInt::from(base).modpow(&odd, &modulus);
        if power.is_one() {
            return true;
        }
        for _ in 0..twos {
            if power == minus_one {
                return true;
            }
            power = &power * &power % &modulus;
        }
        false
    })
}
