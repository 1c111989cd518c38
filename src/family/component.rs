//! At which bank angles does the part of an order along the reference direction vanish, or the part across it?
//!
//! Along direction 0 an order swings with `½|P⁺ + P̄⁻|`, across it with `½|P⁺ − P̄⁻|` (theory, sections 3 and 9). With open
//! φ both are sums `Σ_j e^{ijφ} S_j`. Where every S_j is a rational multiple of one S that is not zero, they vanish where the
//! polynomial of these multiples does, whose roots among the roots of unity are found, all of them, by division.

use std::collections::BTreeSet;

use num_bigint::BigInt;
use num_integer::Integer;
use num_rational::BigRational;
use num_traits::{One, ToPrimitive, Zero};

use super::left::ratio;
use super::{OpenSum, Part, phase, sums_of};
use crate::engine::{Cylinder, Family, Linear, PHI};
use crate::exact::{PhasorSum, Term, Turn};
use crate::proof::{Quantity, Sense};

/// A part of the force or the moment.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Component {
    /// Along the reference direction, the bisector of a V: vertical.
    Along,
    /// Across it: horizontal.
    Across,
}

/// The angles φ at which a sum vanishes.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Zeros {
    /// All.
    Everywhere,
    /// Exactly these in (0°, 360°).
    At(BTreeSet<Turn>),
    /// Not solved for.
    NotSolved,
}

/// Polynomials of a higher degree are not solved.
const HIGHEST_DEGREE: usize = 64;

/// The angles φ at which a component of one order vanishes; not solved where another unknown is open too.
pub fn component_zeros(family: &Family, quantity: Quantity, order: u32, component: Component) -> Zeros {
    let sign = BigRational::from_integer(if component == Component::Along { 1.into() } else { (-1).into() });
    let terms = family.cylinders().iter().flat_map(|cylinder: &Cylinder<Linear, Linear>| {
        let weight = super::weight(family, cylinder, quantity);
        let mirrored = phase(cylinder, order, Sense::Reverse).scaled(&-BigRational::one());
        let reverse = (mirrored, weight.scaled(&sign));
        [(phase(cylinder, order, Sense::Direct), weight), reverse]
    });
    let terms: Vec<(Linear, Linear)> = terms.collect();
    let sums = sums_of(&terms);
    let each: Vec<Zeros> = sums.iter().map(zeros_of).collect();
    if each.contains(&Zeros::NotSolved) {
        return Zeros::NotSolved;
    }
    let sets = each.into_iter().filter_map(|zeros| match zeros {
        Zeros::At(set) => Some(set),
        _ => None,
    });
    let common = sets.reduce(|common, set| common.intersection(&set).cloned().collect());
    common.map_or(Zeros::Everywhere, Zeros::At)
}

fn zeros_of(sum: &OpenSum) -> Zeros {
    let (none, one) = (BigRational::zero(), BigRational::one());
    if sum.left().next().is_none() {
        return Zeros::Everywhere;
    }
    let inside = |values: BTreeSet<BigRational>| {
        Zeros::At(values.into_iter().filter(|value| *value != none && *value != one).map(Turn::new).collect())
    };
    values_of_multiples(sum, PHI, [&none, &one]).map_or(Zeros::NotSolved, inside)
}

/// The values of an unknown x in a range, in turns and with its ends, at which a sum vanishes whose parts are rational multiples
/// of one of them; `None` where they are not, where another unknown enters, or where the polynomial is too long.
pub(super) fn values_of_multiples(
    sum: &OpenSum,
    unknown: &str,
    range: [&BigRational; 2],
) -> Option<BTreeSet<BigRational>> {
    let parts: Vec<_> = sum.left().collect();
    let first = parts.first()?;
    let split = |part: &Part| match unknown {
        PHI => (part.phi.clone(), part.delta.is_zero()),
        _ => (part.delta.clone(), part.phi.is_zero()),
    };
    let (multiples, alone): (Vec<BigRational>, Vec<bool>) = parts.iter().map(|part| split(part)).unzip();
    if alone.contains(&false) {
        return None;
    }
    let ratios = parts.iter().map(|part| ratio(&part.sum, &first.sum)).collect::<Option<Vec<_>>>()?;
    // z = e^{ix/unit}, and the exponents are whole from the lowest on.
    let unit = multiples.iter().fold(BigInt::one(), |unit, multiple| unit.lcm(multiple.denom()));
    let scale = BigRational::from_integer(unit.clone());
    let exponents: Vec<BigInt> = multiples.iter().map(|multiple| (multiple * &scale).to_integer()).collect();
    let lowest = exponents.iter().min().cloned()?;
    let places = exponents.iter().map(|exponent| (exponent - &lowest).to_usize().filter(|at| *at <= HIGHEST_DEGREE));
    let places = places.collect::<Option<Vec<usize>>>()?;
    let degree = places.iter().max().copied().unwrap_or(0);
    let mut polynomial = vec![BigRational::zero(); degree + 1];
    for (place, ratio) in places.into_iter().zip(ratios) {
        polynomial[place] += ratio;
    }
    Some(roots(polynomial)?.into_iter().flat_map(|n| values_at(n, &scale, range)).collect())
}

/// The orders n of the primitive roots of unity that are roots; `None` where other roots may lie on the unit circle.
fn roots(mut polynomial: Vec<BigRational>) -> Option<Vec<i64>> {
    let mut found = Vec::new();
    // φ(n) ≥ √(n/2), so that no n above 2 d² has a root of degree d or less.
    let degree = polynomial.len() - 1;
    for n in 1..=(2 * degree * degree) as i64 {
        if vanishes_at(&polynomial, n) {
            found.push(n);
            let cyclotomic = cyclotomic(n);
            while let Some(quotient) = divided(&polynomial, &cyclotomic) {
                polynomial = quotient;
            }
        }
    }
    (polynomial.len() == 1).then_some(found)
}

fn vanishes_at(polynomial: &[BigRational], n: i64) -> bool {
    let term = |(place, weight): (usize, &BigRational)| Term {
        angle: Turn::fraction(place as i64, n),
        weight: weight.clone(),
    };
    PhasorSum::new(polynomial.iter().enumerate().map(term).collect()).vanishes()
}

/// The n-th cyclotomic polynomial: `x^n − 1` divided by those of the smaller divisors of n.
fn cyclotomic(n: i64) -> Vec<BigRational> {
    let mut rest = vec![BigRational::zero(); n as usize + 1];
    rest[0] = -BigRational::one();
    rest[n as usize] = BigRational::one();
    for divisor in (1..n).filter(|divisor| n % divisor == 0) {
        rest = divided(&rest, &cyclotomic(divisor)).unwrap_or(rest);
    }
    rest
}

/// The quotient of two polynomials whose last coefficient is not zero; `None` where something is left.
fn divided(dividend: &[BigRational], divisor: &[BigRational]) -> Option<Vec<BigRational>> {
    let steps = dividend.len().checked_sub(divisor.len())?;
    let last = divisor.last()?;
    let mut rest = dividend.to_vec();
    let mut quotient = vec![BigRational::zero(); steps + 1];
    for step in (0..=steps).rev() {
        let factor = &rest[step + divisor.len() - 1] / last;
        for (place, coefficient) in divisor.iter().enumerate() {
            rest[step + place] -= coefficient * &factor;
        }
        quotient[step] = factor;
    }
    rest.iter().all(Zero::is_zero).then_some(quotient)
}

/// The x in a range with `e^{ix/unit}` a primitive n-th root of unity.
fn values_at(n: i64, unit: &BigRational, [low, high]: [&BigRational; 2]) -> Vec<BigRational> {
    // z = e^{2πi a/n} is e^{ix/unit} for x = unit · a/n turns, with any a prime to n.
    let place = |end: &BigRational| end / unit * BigRational::from_integer(n.into());
    let (mut a, last) = (place(low).ceil().to_integer(), place(high).floor().to_integer());
    let mut values = Vec::new();
    while a <= last {
        if a.gcd(&BigInt::from(n)).is_one() {
            values.push(unit * BigRational::new(a.clone(), n.into()));
        }
        a += 1;
    }
    values
}
