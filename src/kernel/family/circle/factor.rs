//! Which factor of a sum has its zeros on the circle, each once? `P = Q F_1 F_2² F_3³ …`, and Q has none there.
//!
//! `F_1 F_2² …` is the greatest common divisor of P and its mirror image, so that Q and Q* have no common factor. It is found modulo
//! primes, and multiplied out to decide (theory, section 16).

use num_integer::Integer;
use num_rational::BigRational;
use num_traits::ToPrimitive;

use super::field::{Coefficients, Field, root_of_order};
use super::images::Images;
use super::never;
use super::polynomial::Polynomial;
use crate::exact::PhasorSum;
use crate::exact::modulo::{power, primes};
use crate::proof::DividedClaim;

/// So many products of terms may multiplying out take, about.
const MOST_PRODUCTS: u64 = 400_000;
/// Smaller primes by accident divide a resultant.
const LEAST_PRIME: u64 = 1 << 31;
/// So many tell apart fractions of 300 digits.
const MOST_PRIMES: usize = 64;

/// The factors, and `F_1 F_2 F_3 …`; `None` where there are none, or they are too large.
pub(super) fn split(polynomial: &Polynomial) -> Option<(DividedClaim, Polynomial)> {
    let most = MOST_PRODUCTS.isqrt();
    let conductor = polynomial.conductor().to_u64().filter(|conductor| *conductor <= most)?;
    let units: Vec<u64> = (1..=conductor).filter(|a| a.gcd(&conductor) == 1).collect();
    let terms = (polynomial.degree().to_u64()? + 1) * units.len() as u64;
    if terms > most {
        return None;
    }
    let mut gathered: Option<(Images, usize)> = None;
    for prime in primes(conductor, LEAST_PRIME).take(MOST_PRIMES) {
        let Some(next) = images(polynomial, conductor, prime, &units) else { continue };
        let (images, count) = match gathered.take() {
            Some((known, count)) if known.shape == next.shape => (known.and(&next), count + 1),
            Some((known, count)) if known.rank() >= next.rank() => (known, count),
            Some(_) | None => (next, 1),
        };
        if images.shape.len() < 2 {
            return None;
        }
        let found = count.is_power_of_two().then(|| images.polynomials(conductor)).flatten();
        if let Some(found) = found.and_then(|found| multiplied_out(polynomial, found)) {
            return Some(found);
        }
        gathered = Some((images, count));
    }
    None
}

/// Q, F_1, F_2, … modulo a prime, put together from all images of `e^{2πi/N}`.
fn images(polynomial: &Polynomial, conductor: u64, prime: u64, units: &[u64]) -> Option<Images> {
    let root = root_of_order(conductor, prime)?;
    let scale = polynomial.scale();
    let of_root = |root: u64| Field { conductor, prime, root, scale: &scale };
    let lists = units.iter().map(|a| factors(&of_root(power(root, *a, prime)), polynomial));
    Images::of(&of_root(root), units, &lists.collect::<Option<Vec<_>>>()?)
}

fn factors(field: &Field<'_>, polynomial: &Polynomial) -> Option<Vec<Coefficients>> {
    let [straight, mirrored] = field.images(polynomial);
    if [straight.first(), straight.last()].into_iter().any(|end| end.is_none_or(|end| *end == 0)) {
        return None;
    }
    let common = field.common(&straight, &mirrored);
    let mut factors = vec![field.quotient(&straight, &common)];
    // What is in it once more than in `distinct` stays in `rest`.
    let mut rest = field.common(&common, &field.derivative(&common));
    let mut distinct = field.quotient(&common, &rest);
    while distinct.len() > 1 {
        let again = field.common(&distinct, &rest);
        factors.push(field.quotient(&distinct, &again));
        rest = field.quotient(&rest, &again);
        distinct = again;
    }
    Some(factors)
}

/// Decides whether these are the factors, Q still times what made the weights whole.
fn multiplied_out(polynomial: &Polynomial, found: Vec<Vec<PhasorSum>>) -> Option<(DividedClaim, Polynomial)> {
    let (scaled, powers) = found.split_first()?;
    let scale = BigRational::from_integer(polynomial.scale()).recip();
    let without: Vec<PhasorSum> = scaled.iter().map(|sum| sum.scaled(&scale)).collect();
    let once = powers.iter().skip(1).fold(powers.first()?.clone(), |all, power| product(&all, power));
    let each = powers.iter().zip(1..).flat_map(|(power, times)| std::iter::repeat_n(power, times));
    let whole = each.fold(without.clone(), |all, power| product(&all, power));
    let mut differences: Vec<PhasorSum> =
        whole.iter().map(|sum| sum.scaled(&BigRational::from_integer((-1).into()))).collect();
    for (exponent, sum) in polynomial.exponents.iter().zip(&polynomial.sums) {
        let place = differences.get_mut(exponent.to_usize()?)?;
        *place = sum.plus(place);
    }
    if !differences.iter().all(PhasorSum::vanishes) {
        return None;
    }
    let equalities = differences.iter().map(|sum| sum.tidied().certificate()).collect();
    let of = |coefficients: &[PhasorSum]| of_coefficients(polynomial, coefficients);
    let coprime = never::prove(&of(&without))?;
    let vectors = |coefficients: &[PhasorSum]| coefficients.iter().map(PhasorSum::vectors).collect();
    let powers = powers.iter().map(|power| vectors(power)).collect();
    Some((DividedClaim { without: vectors(&without), coprime, powers, equalities }, of(&once)))
}

fn of_coefficients(polynomial: &Polynomial, coefficients: &[PhasorSum]) -> Polynomial {
    let each = (0..).zip(coefficients).filter(|(_, sum)| !sum.terms().is_empty());
    let (exponents, sums) = each.map(|(exponent, sum)| (exponent, sum.clone())).unzip();
    Polynomial { phi: polynomial.phi.clone(), delta: polynomial.delta.clone(), exponents, sums }
}

/// Collected, from the constant coefficient on.
fn product(a: &[PhasorSum], b: &[PhasorSum]) -> Vec<PhasorSum> {
    let mut product = vec![PhasorSum::new(Vec::new()); (a.len() + b.len()).saturating_sub(1)];
    for (i, one) in a.iter().enumerate() {
        for (j, other) in b.iter().enumerate() {
            product[i + j] = product[i + j].plus(&one.times(other));
        }
    }
    product.iter().map(PhasorSum::tidied).collect()
}
