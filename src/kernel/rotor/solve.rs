//! Which of the solved cases is it, and what is its answer?

use num_rational::BigRational;
use num_traits::Zero;

use super::answer::{Answer, Found, NotSolved, Reason};
use super::exact::{Real, across, along};
use super::wanted::Wanted;
use super::{secondary, triangle};
use crate::exact::{PhasorSum, Term, Turn};
use crate::file::{Rotor, RotorMass};
use crate::numbers;

/// The answer, with `ΣU` and `ΣzU` of what is known.
pub(super) fn solve(rotor: &Rotor, [force, couple]: [PhasorSum; 2]) -> Result<Answer, NotSolved> {
    if secondary::is_wanted(rotor) {
        return secondary::four_cranks(rotor);
    }
    let wanted: Vec<(usize, Wanted)> =
        rotor.masses.iter().map(Wanted::of).enumerate().filter(|(_, wanted)| !wanted.is_none()).collect();
    let vector = |wanted: &Wanted| wanted.size && wanted.angle;
    let size = |wanted: &Wanted| wanted.size && !wanted.angle;
    match wanted.as_slice() {
        [] if force.vanishes() && couple.vanishes() => Ok(Answer::Balanced),
        [] => Ok(Answer::Residual(Box::new([force, couple]))),
        [(index, one)] if vector(one) => Ok(one_vector(rotor, *index, &[force, couple])),
        [(a, one), (b, other)] if vector(one) && vector(other) && !one.position && !other.position => {
            Ok(two_planes(rotor, [*a, *b], &[force, couple]))
        }
        [(index, one)] if size(one) => one_size(rotor, *index, &[force, couple]),
        [(a, one), (b, other)] if size(one) && size(other) && one.position == other.position => {
            two_sizes(rotor, [*a, *b], &[force, couple])
        }
        _ => triangle::solve(rotor, &wanted),
    }
}

fn degrees(sum: &PhasorSum) -> f64 {
    let angle = numbers::degrees(numbers::evaluate(sum));
    if angle < 0.0 { angle + 360.0 } else { angle }
}

/// A mass whose vector is this sum.
fn of_vector(index: usize, vector: PhasorSum, position: Option<Real>) -> Found {
    let angle = if vector.vanishes() { 0.0 } else { degrees(&vector) };
    Found { index, mass_radius: Real::length(&vector), angle, turn: None, cosine: None, vector: Some(vector), position }
}

fn negative(sum: &PhasorSum) -> PhasorSum {
    sum.scaled(&BigRational::from_integer((-1).into()))
}

/// `ΣzU` about another position.
fn about(force: &PhasorSum, couple: &PhasorSum, position: &BigRational) -> PhasorSum {
    couple.minus(&force.scaled(position))
}

fn one_vector(rotor: &Rotor, index: usize, [force, couple]: &[PhasorSum; 2]) -> Answer {
    let mass = &rotor.masses[index];
    match &mass.position {
        Some(position) if about(force, couple, position).vanishes() => {
            Answer::Found(vec![vec![of_vector(index, negative(force), None)]])
        }
        Some(_) => Answer::Never(Reason::Couple),
        None if force.vanishes() && couple.vanishes() => Answer::Many(Reason::BalancedAlready),
        None if force.vanishes() => Answer::Never(Reason::CoupleAlone),
        None if !across(couple, force).vanishes() => Answer::Never(Reason::NotParallel),
        None => {
            let position = Real::quotient(&along(couple, force), &along(force, force));
            Answer::Found(vec![vec![of_vector(index, negative(force), Some(position))]])
        }
    }
}

fn two_planes(rotor: &Rotor, [a, b]: [usize; 2], [force, couple]: &[PhasorSum; 2]) -> Answer {
    let at = |index: usize| rotor.masses[index].position.clone().unwrap_or_else(BigRational::zero);
    let (one, other) = (at(a), at(b));
    if one == other {
        return match about(force, couple, &one).vanishes() {
            true => Answer::Many(Reason::OnePlane),
            false => Answer::Never(Reason::OnePlane),
        };
    }
    let part = |at: &BigRational, from: &BigRational| about(force, couple, from).scaled(&(from - at).recip());
    Answer::Found(vec![vec![of_vector(a, part(&one, &other), None), of_vector(b, part(&other, &one), None)]])
}

/// The direction of a mass whose angle is given, as a sum of length 1.
fn direction(mass: &RotorMass) -> PhasorSum {
    let angle = mass.angle.clone().unwrap_or_else(Turn::zero);
    PhasorSum::new(vec![Term { angle, weight: BigRational::from_integer(1.into()) }])
}

/// A mass in its given direction, `above/below` long, or opposite to it where that is below 0.
fn of_size(index: usize, mass: &RotorMass, [above, below]: [&PhasorSum; 2], position: Option<Real>) -> Found {
    let along = Real::quotient(above, below);
    let given = mass.angle.clone().unwrap_or_else(Turn::zero);
    let (mass_radius, turn) = match along.decimal < 0.0 {
        true => (Real::quotient(&negative(above), below), given.opposite()),
        false => (along, given),
    };
    let angle = numbers::float(&turn.degrees());
    Found { index, mass_radius, vector: None, angle, turn: Some(turn), cosine: None, position }
}

fn one_size(rotor: &Rotor, index: usize, [force, couple]: &[PhasorSum; 2]) -> Result<Answer, NotSolved> {
    let mass = &rotor.masses[index];
    let own = direction(mass);
    if !across(force, &own).vanishes() {
        return Ok(Answer::Never(Reason::Force));
    }
    let (size, one) = (negative(&along(force, &own)), along(&own, &own));
    let position = match &mass.position {
        Some(position) if about(force, couple, position).vanishes() => None,
        Some(_) => return Ok(Answer::Never(Reason::Couple)),
        None if force.vanishes() && couple.vanishes() => return Ok(Answer::Many(Reason::BalancedAlready)),
        None if force.vanishes() => return Ok(Answer::Never(Reason::CoupleAlone)),
        None if !across(couple, &own).vanishes() => return Ok(Answer::Never(Reason::NotParallel)),
        None => Some(Real::quotient(&along(couple, &own), &along(force, &own))),
    };
    Ok(Answer::Found(vec![vec![of_size(index, mass, [&size, &one], position)]]))
}

/// Two masses whose directions are parallel.
fn in_one_line(rotor: &Rotor, [a, b]: [usize; 2], [force, couple]: &[PhasorSum; 2]) -> Answer {
    let masses = [a, b].map(|index| &rotor.masses[index]);
    let [one, other] = masses.map(direction);
    if !across(force, &one).vanishes() {
        return Answer::Never(Reason::Force);
    }
    if !across(couple, &one).vanishes() {
        return Answer::Never(Reason::Couple);
    }
    let [Some(at), Some(there)] = masses.map(|mass| mass.position.as_ref()) else {
        return Answer::Many(Reason::OneLine);
    };
    if at == there {
        return match about(force, couple, at).vanishes() {
            true => Answer::Many(Reason::OnePlane),
            false => Answer::Never(Reason::OnePlane),
        };
    }
    let size = |own: &PhasorSum, at: &BigRational, from: &BigRational| {
        along(&about(force, couple, from), own).scaled(&(from - at).recip())
    };
    let unit = along(&one, &one);
    Answer::Found(vec![vec![
        of_size(a, masses[0], [&size(&one, at, there), &unit], None),
        of_size(b, masses[1], [&size(&other, there, at), &unit], None),
    ]])
}

fn two_sizes(rotor: &Rotor, [a, b]: [usize; 2], [force, couple]: &[PhasorSum; 2]) -> Result<Answer, NotSolved> {
    let masses = [a, b].map(|index| &rotor.masses[index]);
    let [one, other] = masses.map(direction);
    let below = across(&one, &other);
    if below.vanishes() {
        return Ok(in_one_line(rotor, [a, b], &[force.clone(), couple.clone()]));
    }
    // u₁e₁ + u₂e₂ = −F: across e₂ and e₁.
    let sizes = |sum: &PhasorSum| [negative(&across(sum, &other)), across(sum, &one)];
    let [first, second] = sizes(force);
    let positions = match masses.map(|mass| mass.position.as_ref()) {
        [Some(at), Some(there)] => {
            let moments = one.times(&first).scaled(at).plus(&other.times(&second).scaled(there));
            if !couple.times(&below).plus(&moments).vanishes() {
                return Ok(Answer::Never(Reason::Couple));
            }
            [None, None]
        }
        _ => {
            let moments = sizes(couple);
            // A mass of 0 has no moment in any plane.
            let lost = [(&first, &moments[0]), (&second, &moments[1])]
                .iter()
                .any(|(size, moment)| size.vanishes() && !moment.vanishes());
            if lost {
                return Ok(Answer::Never(Reason::CoupleAlone));
            }
            if first.vanishes() || second.vanishes() {
                return Ok(Answer::Many(Reason::BalancedAlready));
            }
            [Some(Real::quotient(&moments[0], &first)), Some(Real::quotient(&moments[1], &second))]
        }
    };
    let [at, there] = positions;
    Ok(Answer::Found(vec![vec![
        of_size(a, masses[0], [&first, &below], at),
        of_size(b, masses[1], [&second, &below], there),
    ]]))
}
