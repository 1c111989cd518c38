//! Does a sum vanish just where a factor of it does?
//!
//! `P = Q F_1 F_2² F_3³ …` is checked coefficient by coefficient, and that Q vanishes nowhere on the circle by an identity modulo a prime. So P
//! vanishes there where one of the F does, and with it `F_1 F_2 F_3 …`.

use std::iter::repeat_n;

use num_rational::BigRational;
use num_traits::{One, ToPrimitive, Zero};

use super::audit::{Audit, Reason, refuse_if, steps_of};
use super::check::certify;
use super::circle::DividedClaim;
use super::collected::{Collected, collect, collected, vectors};
use super::coprime_check::check_identity;
use super::unknown::Unknown;
use super::vector::Vector;

/// Coefficients from the constant one on.
type Coefficients = Vec<Collected>;

/// The product of the factors, each once; its leading coefficient is 1.
pub(super) fn check_divided(
    claim: &DividedClaim,
    u: [&BigRational; 2],
    unknown: &Unknown<'_>,
    audit: &Audit,
) -> Result<Coefficients, Reason> {
    let without = read(&claim.without, audit)?;
    let powers = claim.powers.iter().map(|power| monic(power, audit)).collect::<Result<Vec<_>, Reason>>()?;
    refuse_if(powers.last().is_none_or(|last| last.len() < 2), "the last factor has a degree")?;
    let in_all = (1_usize..).zip(&powers).map(|(times, power)| times.saturating_mul(power.len() - 1));
    let degree = in_all.fold(without.len(), usize::saturating_add);
    if Some(degree) != unknown.degree().to_usize().map(|degree| degree + 1) {
        return Err("the factors do not have the degree of the sum".into());
    }
    if [&claim.coprime.phi, &claim.coprime.delta] != u {
        return Err("the factor without zeros is not one in the same unknown".into());
    }
    check_identity(&claim.coprime, &of_coefficients(&without), audit)?;
    let each = (1..).zip(&powers).filter(|(_, power)| power.len() > 1);
    let mut each = each.flat_map(|(times, power)| repeat_n(power, times));
    let whole = each.try_fold(without, |all, power| multiplied(&all, power, audit))?;
    check_equal(claim, whole, unknown, audit)?;
    let constant = vec![Collected::from([(BigRational::zero(), BigRational::one())])];
    powers.iter().try_fold(constant, |all, power| multiplied(&all, power, audit))
}

/// Each coefficient of the sum is that of the product.
fn check_equal(claim: &DividedClaim, whole: Coefficients, unknown: &Unknown<'_>, audit: &Audit) -> Result<(), Reason> {
    if claim.equalities.len() != whole.len() {
        return Err(format!("{} certificates for {} coefficients", claim.equalities.len(), whole.len()).into());
    }
    let mut terms: Vec<Vec<(BigRational, BigRational)>> =
        whole.into_iter().map(|sum| sum.into_iter().map(|(angle, weight)| (angle, -weight)).collect()).collect();
    for (exponent, sum) in unknown.exponents.iter().zip(&unknown.sums) {
        if let Some(place) = exponent.to_usize().and_then(|at| terms.get_mut(at)) {
            place.extend(sum.iter().map(|(angle, weight)| (angle.clone(), weight.clone())));
        }
    }
    for ((exponent, terms), certificate) in terms.into_iter().enumerate().zip(&claim.equalities) {
        certify(&collect(terms, audit)?, true, certificate, audit)
            .map_err(|refusal| Reason::from(refusal).within(format!("coefficient {exponent} of the product")))?;
    }
    Ok(())
}

/// A polynomial with these coefficients, those omitted that have no term.
pub(super) fn of_coefficients(coefficients: &[Collected]) -> Unknown<'_> {
    let (exponents, sums) = (0..).zip(coefficients).filter(|(_, sum)| !sum.is_empty()).unzip();
    Unknown { exponents, sums }
}

fn read(coefficients: &[Vec<Vector>], audit: &Audit) -> Result<Coefficients, Reason> {
    let one = |terms: &Vec<Vector>| {
        let sum = collected(terms, audit)?;
        if vectors(sum.clone()) == *terms { Ok(sum) } else { Err("the terms of a factor are not collected".into()) }
    };
    coefficients.iter().map(one).collect()
}

fn monic(coefficients: &[Vec<Vector>], audit: &Audit) -> Result<Coefficients, Reason> {
    let power = read(coefficients, audit)?;
    let one = Collected::from([(BigRational::zero(), BigRational::one())]);
    if power.last() == Some(&one) { Ok(power) } else { Err("the leading coefficient of a factor is not 1".into()) }
}

fn multiplied(a: &[Collected], b: &[Collected], audit: &Audit) -> Result<Coefficients, Reason> {
    let mut terms = vec![Vec::new(); (a.len() + b.len()).saturating_sub(1)];
    for (i, one) in a.iter().enumerate() {
        for (j, other) in b.iter().enumerate() {
            audit.spend(1)?;
            for (s, v) in one {
                for (t, w) in other {
                    audit.spend(steps_of(s).max(steps_of(v)).max(steps_of(t)).max(steps_of(w)))?;
                    terms[i + j].push((s + t, v * w));
                }
            }
        }
    }
    terms.into_iter().map(|terms| Ok(collect(terms, audit)?)).collect()
}
