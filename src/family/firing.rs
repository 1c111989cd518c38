//! At which bank angles do the cylinders fire evenly?

use std::collections::BTreeSet;

use num_bigint::BigInt;
use num_rational::BigRational;
use num_traits::{One, Zero};

use crate::engine::{Family, Linear, PHI};
use crate::exact::Turn;

/// The bank angles φ in (0°, 360°) at which an even firing order exists; `None` where the cycle is not given, or
/// where another angle than φ is open.
///
/// In an even order the top dead centres, modulo a revolution, are the multiples of the interval. Between a cylinder
/// in which φ enters otherwise than in the first and the first, that leaves finitely many φ, and each is tried.
pub fn even_firing(family: &Family) -> Option<BTreeSet<Turn>> {
    let cycle = family.cycle()?.turns();
    let centres: Vec<Linear> = family.cylinders().iter().map(|cylinder| cylinder.bank.minus(&cylinder.throw)).collect();
    if centres.iter().any(|centre| centre.symbols().keys().any(|name| name != PHI)) {
        return None;
    }
    let count = BigRational::from_integer(centres.len().into());
    let step = &cycle / &count;
    let first = centres.first()?;
    let other = centres.iter().map(|centre| centre.minus(first)).find(|apart| !apart.coefficient(PHI).is_zero())?;
    Some(candidates(&other, &step).into_iter().filter(|phi| is_even(&centres, phi, &step)).collect())
}

/// The φ at which two top dead centres are a multiple of the step apart.
fn candidates(apart: &Linear, step: &BigRational) -> BTreeSet<Turn> {
    let coefficient = apart.coefficient(PHI);
    // Multiples of the step, modulo a turn, are the multiples of a turn over the denominator of the step.
    let grid = BigRational::new(BigInt::one(), step.denom().clone());
    let most = (num_traits::abs(coefficient.clone()) / &grid).ceil().to_integer() + BigInt::one();
    let known = Turn::new(apart.known().clone()).turns().clone();
    let mut angles = BTreeSet::new();
    let mut m = -&most - step.denom();
    while m <= &most + step.denom() {
        let phi = (&grid * BigRational::from_integer(m.clone()) - &known) / &coefficient;
        if phi > BigRational::zero() && phi < BigRational::one() {
            angles.insert(Turn::new(phi));
        }
        m += BigInt::one();
    }
    angles
}

/// Whether the top dead centres modulo a revolution are those of an even order.
fn is_even(centres: &[Linear], phi: &Turn, step: &BigRational) -> bool {
    let at = |centre: &Linear| Turn::new(centre.known() + centre.coefficient(PHI) * phi.turns());
    let first = at(&centres[0]);
    let mut found: Vec<Turn> = centres.iter().map(|centre| &at(centre) - &first).collect();
    let mut wanted: Vec<Turn> =
        (0..centres.len()).map(|j| Turn::new(step * BigRational::from_integer(j.into()))).collect();
    found.sort();
    wanted.sort();
    found == wanted
}
