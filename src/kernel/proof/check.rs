//! Does a certificate prove what it claims? Checked with whole numbers, by rules a person could follow.

use num_bigint::BigInt;
use num_integer::Integer;
use num_rational::BigRational;
use num_traits::{Signed, ToPrimitive, Zero};

use super::audit::{Audit, refuse_if, squared_words, steps_of};
use super::certificate::{Certificate, Polygon, Residue};
use super::collected::{Collected, collect, collected};
use super::refusal::{LARGEST_CONDUCTOR, MOST_CORNERS, Refusal};
use super::splitting::check_splitting;
use super::vector::Vector;
use super::whole::{added, multiplied, power, prime_divisors};

/// Checks that a certificate proves that the sum of these vectors is zero, or that it is not.
///
/// # Errors
/// The first rule that the certificate breaks.
pub fn check_certificate(terms: &[Vector], vanishes: bool, certificate: &Certificate) -> Result<(), Refusal> {
    let audit = Audit::new();
    certify(&collected(terms, &audit)?, vanishes, certificate, &audit)
}

/// The same for terms that are collected, as every kind of certificate is about those.
pub(super) fn certify(
    sum: &Collected,
    vanishes: bool,
    certificate: &Certificate,
    audit: &Audit,
) -> Result<(), Refusal> {
    refuse_if(certificate.claims_zero() != vanishes, Refusal::WrongKind)?;
    match certificate {
        Certificate::Polygons { polygons } => check_polygons(sum, polygons, audit),
        Certificate::Residue(residue) => check_residue(sum, residue, audit),
        Certificate::Splitting { steps } => check_splitting(sum, steps, audit),
    }?;
    audit.count(certificate);
    Ok(())
}

/// The corners of a regular polygon sum to zero, however many there are from two on, so what expands into polygons is zero.
fn check_polygons(sum: &Collected, polygons: &[Polygon], audit: &Audit) -> Result<(), Refusal> {
    let mut corners = 0_u64;
    for polygon in polygons {
        corners = corners.saturating_add(polygon.sides);
        refuse_if(corners > MOST_CORNERS, Refusal::TooManyCorners)?;
        refuse_if(polygon.sides < 2, Refusal::NoPolygon(polygon.sides))?;
        refuse_if(polygon.weight.is_zero(), Refusal::EmptyPolygon)?;
        let size = steps_of(&polygon.rotation).max(steps_of(&polygon.weight));
        audit.spend(polygon.sides.saturating_mul(size))?;
    }
    let expanded = polygons.iter().flat_map(|polygon| {
        (0..polygon.sides).map(|j| {
            let step = BigRational::new(j.into(), polygon.sides.into());
            (&polygon.rotation + step, polygon.weight.clone())
        })
    });
    let found = collect(expanded, audit)?;
    let at = |sum: &Collected, angle: &BigRational| sum.get(angle).cloned().unwrap_or_else(BigRational::zero);
    match sum.keys().chain(found.keys()).find(|angle| at(sum, angle) != at(&found, angle)) {
        Some(angle) => Err(Refusal::PolygonsDiffer(Box::new([angle.clone(), at(sum, angle), at(&found, angle)]))),
        None => Ok(()),
    }
}

/// `e^{2πi/N} ↦ root` respects sums and products, so a sum whose image is not zero is not zero.
///
/// The modulus need not be a prime: `root^N − 1 ≡ 0` is the product of all `Φ_d(root)`, d a divisor of N, and each with d < N divides
/// some `root^{N/q} − 1`. Where none of these shares a factor with the modulus, `Φ_N(root) ≡ 0` is left.
fn check_residue(sum: &Collected, claim: &Residue, audit: &Audit) -> Result<(), Refusal> {
    let modulus = claim.prime.to_u64().filter(|&modulus| modulus >= 2);
    let modulus = modulus.ok_or_else(|| Refusal::ModulusOutOfRange(claim.prime.clone()))?;
    let conductor = claim.conductor.to_u64().filter(|n| (1..=LARGEST_CONDUCTOR).contains(n));
    let conductor = conductor.ok_or_else(|| Refusal::ConductorOutOfRange(claim.conductor.clone()))?;
    // A thousand divisions of the conductor at most, and a power for each of its prime divisors.
    audit.spend(30 + squared_words(&claim.root) + squared_words(&claim.scale) + squared_words(&claim.residue))?;
    let modulo = |number: &BigInt| number.mod_floor(&BigInt::from(modulus)).to_u64().unwrap_or_default();
    let root = modulo(&claim.root);
    let less_one = |n: u64| added(power(root, n, modulus), modulus - 1, modulus);
    let is_smaller = |q: &u64| less_one(conductor / q).gcd(&modulus) != 1;
    if less_one(conductor) != 0 || prime_divisors(conductor).iter().any(is_smaller) {
        return Err(Refusal::WrongOrder(claim.root.clone()));
    }
    let scale = BigRational::from_integer(claim.scale.clone());
    let times_conductor = BigRational::from_integer(claim.conductor.clone());
    let mut found = 0;
    for (angle, weight) in sum {
        audit.spend(4 + steps_of(angle) + steps_of(weight).saturating_mul(2) + squared_words(&claim.scale))?;
        let exponent = angle * &times_conductor;
        if !exponent.is_integer() {
            return Err(Refusal::AngleNotWhole(angle.clone()));
        }
        let whole = weight * &scale;
        if !whole.is_integer() || !claim.scale.is_positive() {
            return Err(Refusal::WeightNotWhole(weight.clone()));
        }
        let image = power(root, exponent.to_integer().to_u64().unwrap_or_default(), modulus);
        let term = multiplied(modulo(&whole.to_integer()), image, modulus);
        found = added(found, term, modulus);
    }
    refuse_if(found != modulo(&claim.residue), Refusal::WrongResidue(found))?;
    if found == 0 { Err(Refusal::ZeroResidue) } else { Ok(()) }
}
