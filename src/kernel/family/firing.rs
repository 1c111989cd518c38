//! At which bank angles, or bank angles and pin splits, do the cylinders fire evenly?

use std::collections::BTreeSet;

use num_bigint::BigInt;
use num_rational::BigRational;
use num_traits::{One, Signed, Zero};

use super::zeros::lifted;
use crate::engine::{DELTA, Family, Linear, PHI};
use crate::exact::{Turn, fraction};

/// The bank angles φ in (0°, 360°) at which an even firing order exists; `None` where the cycle is not given, or
/// where another angle than φ is open.
pub fn even_firing(family: &Family) -> Option<BTreeSet<Turn>> {
    if centres(family).iter().any(|centre| centre.symbols().keys().any(|name| name != PHI)) {
        return None;
    }
    let EvenFiring { phi, turns, .. } = even_firing_lines(family)?;
    let (none, one) = (BigRational::zero(), BigRational::one());
    let values = turns.iter().flat_map(|turn| lifted([turn.turns(); 2], &phi, [&none, &one]));
    Some(values.map(|[value, _]| value).filter(|value| *value != none && *value != one).map(Turn::new).collect())
}

/// Where an even firing order exists: where `phi·φ + delta·δ` is one of these turns, modulo a turn.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct EvenFiring {
    /// How many times φ enters, 0 or more.
    pub phi: BigRational,
    /// How many times δ enters, more than 0 where φ does not.
    pub delta: BigRational,
    /// The turns; none: it fires evenly nowhere.
    pub turns: BTreeSet<Turn>,
}

/// The φ and δ at which an even firing order exists; `None` where the cycle is not given, where the top dead centres stand against
/// each other as they do whatever φ and δ are, or where these turn them against each other by more than one angle.
///
/// In an even order the top dead centres, modulo a revolution, are the multiples of the interval. Between a cylinder that is turned otherwise
/// than the first and the first, that leaves finitely many turns, and each is tried.
pub fn even_firing_lines(family: &Family) -> Option<EvenFiring> {
    let centres = centres(family);
    let step = step(family)?;
    let first = centres.first()?;
    let apart = |centre: &Linear| [PHI, DELTA].map(|name| centre.coefficient(name) - first.coefficient(name));
    let all: Vec<[BigRational; 2]> = centres.iter().map(apart).collect();
    let [phi, delta] = all.iter().find(|[phi, delta]| !phi.is_zero() || !delta.is_zero())?;
    if all.iter().any(|[p, d]| p * delta != d * phi) {
        return None;
    }
    // The largest angle of which every centre is turned by a whole multiple.
    let axis = usize::from(phi.is_zero());
    let along = if axis == 0 { phi } else { delta };
    let unit = fraction::common_unit(all.iter().map(|times| &times[axis]));
    let [phi, delta] = [phi, delta].map(|times| times / along * &unit);
    let times: Vec<BigRational> = all.iter().map(|of| &of[axis] / &unit).collect();
    let (other, by) = centres.iter().zip(&times).find(|(_, by)| !by.is_zero())?;
    let at =
        |u: &Turn| centres.iter().zip(&times).map(|(centre, by)| Turn::new(centre.known() + by * u.turns())).collect();
    let candidates = candidates(by, &(other.known() - first.known()), &step).into_iter();
    let turns = candidates.filter(|u| is_even(at(u), &step)).collect();
    Some(EvenFiring { phi, delta, turns })
}

/// The top dead centres.
fn centres(family: &Family) -> Vec<Linear> {
    family.cylinders().iter().map(|cylinder| cylinder.bank.minus(&cylinder.throw)).collect()
}

/// From one firing to the next, in turns.
fn step(family: &Family) -> Option<BigRational> {
    Some(family.cycle()?.turns() / BigRational::from_integer(family.cylinders().len().into()))
}

/// The u at which two top dead centres, `times·u + known` apart, are a multiple of the step apart.
fn candidates(times: &BigRational, known: &BigRational, step: &BigRational) -> BTreeSet<Turn> {
    // Multiples of the step, modulo a turn, are the multiples of a turn over the denominator of the step.
    let grid = BigRational::new(BigInt::one(), step.denom().clone());
    let most = (times.abs() / &grid).ceil().to_integer() + BigInt::one();
    let known = Turn::new(known.clone()).turns().clone();
    let mut angles = BTreeSet::new();
    let mut m = -&most - step.denom();
    while m <= &most + step.denom() {
        let u = (&grid * BigRational::from_integer(m.clone()) - &known) / times;
        if !u.is_negative() && u < BigRational::one() {
            angles.insert(Turn::new(u));
        }
        m += BigInt::one();
    }
    angles
}

/// Whether top dead centres modulo a revolution are those of an even order.
fn is_even(centres: Vec<Turn>, step: &BigRational) -> bool {
    let mut found: Vec<Turn> = centres.iter().map(|at| at - &centres[0]).collect();
    let mut wanted: Vec<Turn> =
        (0..centres.len()).map(|j| Turn::new(step * BigRational::from_integer(j.into()))).collect();
    found.sort();
    wanted.sort();
    found == wanted
}
