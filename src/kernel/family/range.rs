//! Is a solution in the range that is asked about: are there φ and δ from 0° to 360° that make it?
//!
//! Conditions are about multiples of φ and δ modulo a turn. A whole multiple takes every value where the unknown runs through one turn; half of φ
//! takes those up to 180° alone.

use num_bigint::BigInt;
use num_rational::BigRational;
use num_traits::{Signed, Zero};

use crate::exact::Turn;
use crate::proof::ConditionClaim;

/// That a multiple of φ and one of δ come to an angle between these ends, in turns, modulo a turn.
#[derive(Clone, Debug)]
pub struct Place {
    /// How many times φ and δ enter.
    pub times: [BigRational; 2],
    /// The ends; equal where the angle is exact.
    pub ends: [BigRational; 2],
}

/// How far an angle may be from its decimals, in turns.
const SLACK: (i64, i64) = (1, 1_000_000);

impl Place {
    /// At an angle in turns.
    pub fn exact(times: &[BigRational; 2], turns: &BigRational) -> Self {
        Place { times: times.clone(), ends: [turns.clone(), turns.clone()] }
    }

    /// Near an angle in degrees: told wider, so that nothing in the range is lost.
    pub fn near(times: &[BigRational; 2], degrees: f64) -> Self {
        let turns = BigRational::from_float(degrees / 360.0).unwrap_or_default();
        let slack = BigRational::new(SLACK.0.into(), SLACK.1.into());
        Place { times: times.clone(), ends: [&turns - &slack, turns + slack] }
    }

    /// The values between which it lies for φ and δ from 0 to a turn: all whole numbers of turns that can be added to it.
    fn lifted(&self) -> Vec<[BigRational; 2]> {
        let zero = BigRational::zero();
        let low: BigRational = self.times.iter().filter(|times| times.is_negative()).sum();
        let high: BigRational = self.times.iter().filter(|times| **times > zero).sum();
        let mut turns: BigInt = (low - &self.ends[1]).ceil().to_integer();
        let last = (high - &self.ends[0]).floor().to_integer();
        let mut found = Vec::new();
        while turns <= last {
            let by = BigRational::from_integer(turns.clone());
            found.push(self.ends.each_ref().map(|end| end + &by));
            turns += 1;
        }
        found
    }
}

/// Whether these places, on multiples that are not of one angle, have φ and δ from 0 to a turn in common.
pub fn is_in_range(places: &[Place]) -> bool {
    let (one, other, rest) = match places {
        [] => return true,
        [only] => return !only.lifted().is_empty(),
        [one, other, rest @ ..] => (one, other, rest),
    };
    let ([a, b], [c, d]) = (&one.times, &other.times);
    let determinant = a * d - b * c;
    if determinant.is_zero() {
        return places.iter().all(|place| !place.lifted().is_empty());
    }
    let others = other.lifted();
    // φ = (d u − b v)/(ad − bc) and δ = (a v − c u)/(ad − bc).
    one.lifted().iter().any(|u| {
        others.iter().any(|v| {
            let phi = sum(&scaled(u, &(d / &determinant)), &scaled(v, &(-b / &determinant)));
            let delta = sum(&scaled(v, &(a / &determinant)), &scaled(u, &(-c / &determinant)));
            let holds = |place: &Place| {
                let [low, high] = sum(&scaled(&phi, &place.times[0]), &scaled(&delta, &place.times[1]));
                place.lifted().iter().any(|[from, to]| *from <= high && low <= *to)
            };
            let ends =
                |[low, high]: &[BigRational; 2]| *low <= BigRational::from_integer(1.into()) && !high.is_negative();
            [&phi, &delta].into_iter().all(ends) && rest.iter().all(holds)
        })
    })
}

fn scaled(ends: &[BigRational; 2], by: &BigRational) -> [BigRational; 2] {
    let [one, other] = ends.each_ref().map(|end| end * by);
    if one <= other { [one, other] } else { [other, one] }
}

fn sum([a, b]: &[BigRational; 2], [c, d]: &[BigRational; 2]) -> [BigRational; 2] {
    [a + c, b + d]
}

/// Conditions without what others imply: those on multiples of one angle are one on the greatest common divisor of the multiples.
/// None where they contradict each other, or hold for no φ and δ from 0° to 360°.
pub fn in_range(conditions: &[ConditionClaim]) -> Option<Vec<ConditionClaim>> {
    let mut found: Vec<ConditionClaim> = Vec::new();
    for condition in conditions {
        match found.iter_mut().find(|known| are_parallel(known, condition)) {
            Some(known) => *known = both(known, condition)?,
            None => found.push(condition.clone()),
        }
    }
    let place = |one: &ConditionClaim| Place::exact(&[one.phi.clone(), one.delta.clone()], &one.turn);
    is_in_range(&found.iter().map(place).collect::<Vec<_>>()).then_some(found)
}

fn are_parallel(one: &ConditionClaim, other: &ConditionClaim) -> bool {
    &one.phi * &other.delta == &one.delta * &other.phi
}

/// Two conditions on multiples of the same angle, as one on the greatest common divisor; none where both do not hold together.
fn both(one: &ConditionClaim, other: &ConditionClaim) -> Option<ConditionClaim> {
    let own = if one.phi.is_zero() { &one.delta } else { &one.phi };
    let their = if one.phi.is_zero() { &other.delta } else { &other.phi };
    // As whole numbers p, q without common divisor: 1 = a p + b q.
    let ratio = own / their;
    let euclid = num_integer::Integer::extended_gcd(ratio.numer(), ratio.denom());
    let [a, b] = [euclid.x, euclid.y].map(BigRational::from_integer);
    let turn = Turn::new(&a * &one.turn + &b * &other.turn).turns().clone();
    let [p, q] = [ratio.numer(), ratio.denom()].map(|number| BigRational::from_integer(number.clone()));
    let holds = |times: &BigRational, right: &BigRational| (&turn * times - right).is_integer();
    (holds(&p, &one.turn) && holds(&q, &other.turn)).then(|| ConditionClaim {
        phi: &one.phi / &p,
        delta: &one.delta / &p,
        turn: turn.clone(),
    })
}
