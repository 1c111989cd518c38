//! What do reciprocating masses on cranks leave in the second order, and can four cranks leave none of its force?
//!
//! Of four cranks with their outer masses equal, all at one radius, in planes symmetric about the middle, force and couple of order 1 make the engine symmetric: the outer cranks at ±α, the inner
//! ones at 180° ± β, their masses `m₂`. With `ρ = a/b` of the outer and inner arms force and couple are `M cos α = m₂ cos β`, `ρ M sin α = m₂ sin β`, and the
//! force of order 2 vanishes where `2 cos α cos β = 1` (Schlick 1900), so that `4x² + (ρ² − 1)x − ρ² = 0` for `x = cos² α`, which has one
//! positive root, and `m₂ = 2xM` (theory, section 7).

use num_complex::Complex;
use num_rational::BigRational;
use num_traits::{One, Zero};

use super::answer::{Answer, Found, NotSolved};
use super::exact::Real;
use super::wanted::{Wanted, mass_radius};
use crate::exact::{PhasorSum, Term};
use crate::file::{Rotor, RotorMass};
use crate::numbers::{self, Form};

/// What is left of order 2, to be multiplied by ω²c₂.
#[derive(Clone, Debug)]
pub struct Secondary {
    /// Force and couple about the first mass, in kilogram-metres and kilogram square metres.
    pub sums: [Complex<f64>; 2],
    /// The same as exact sums, where all angles are rational; or as zero where that is proved.
    pub exact: [Option<PhasorSum>; 2],
}

/// The two of order 2, with what was found in its place; none where a mass is not known.
pub fn secondary(rotor: &Rotor, solution: &[Found]) -> Option<Secondary> {
    let first = rotor.masses.first()?.position.clone().unwrap_or_else(BigRational::zero);
    let [mut force, mut couple] = [Complex::zero(); 2];
    let mut terms = Some([Vec::new(), Vec::new()]);
    for (index, mass) in rotor.masses.iter().enumerate() {
        let found = solution.iter().find(|one| one.index == index);
        let (size, degrees) = match found {
            Some(one) => (one.mass_radius.decimal.abs(), one.angle),
            None => {
                let turn = mass.angle.as_ref()?;
                (numbers::float(&mass_radius(rotor, mass)?), numbers::float(&turn.degrees()))
            }
        };
        let arm = match found.and_then(|one| one.position.as_ref()) {
            Some(position) => position.decimal - numbers::float(&first),
            None => numbers::float(&(mass.position.as_ref()? - &first)),
        };
        let vector = Complex::from_polar(size, 2.0 * degrees.to_radians());
        force += vector;
        couple += vector * arm;
        let known = mass.angle.clone().zip(mass_radius(rotor, mass)).zip(mass.position.as_ref());
        terms = terms.zip(known.filter(|_| found.is_none())).map(
            |([mut of_force, mut of_couple], ((turn, weight), at))| {
                let angle = turn.times(2);
                of_couple.push(Term { angle: angle.clone(), weight: &weight * (at - &first) });
                of_force.push(Term { angle, weight });
                [of_force, of_couple]
            },
        );
    }
    let exact = match terms {
        Some(terms) => terms.map(|terms| Some(PhasorSum::new(terms))),
        // Where all four angles were wanted this force is what they were found for.
        None if is_wanted(rotor) => [Some(PhasorSum::new(Vec::new())), None],
        None => [None, None],
    };
    Some(Secondary { sums: [force, couple], exact })
}

/// Whether no angle is given, so that the force of order 2 has to vanish too.
pub(super) fn is_wanted(rotor: &Rotor) -> bool {
    rotor.secondary && rotor.masses.iter().all(|mass| mass.angle.is_none())
}

/// Four cranks without force and couple of order 1, and without force of order 2.
pub(super) fn four_cranks(rotor: &Rotor) -> Result<Answer, NotSolved> {
    let place = |mass: &RotorMass| mass.position.clone().ok_or(NotSolved);
    let mut order: Vec<(BigRational, usize)> = Vec::new();
    for (index, mass) in rotor.masses.iter().enumerate() {
        order.push((place(mass)?, index));
    }
    order.sort();
    let [(z1, first), (z2, second), (z3, third), (z4, last)] = order.as_slice() else { return Err(NotSolved) };
    let [one, two, three, four] = [first, second, third, last].map(|index| &rotor.masses[*index]);
    let outer = |mass: &RotorMass| Wanted::of(mass) == Wanted { size: false, angle: true, position: false };
    let inner = |mass: &RotorMass| Wanted::of(mass) == Wanted { size: true, angle: true, position: false };
    if !(outer(one) && outer(four) && inner(two) && inner(three)) || z1 + z4 != z2 + z3 || z2 == z3 || z1 == z2 {
        return Err(NotSolved);
    }
    let size = mass_radius(rotor, one).filter(|size| !size.is_zero()).ok_or(NotSolved)?;
    if mass_radius(rotor, four).as_ref() != Some(&size) {
        return Err(NotSolved);
    }
    let ratio = (z4 - z1) / (z3 - z2);
    let square = &ratio * &ratio;
    let whole = |value: i64| BigRational::from_integer(value.into());
    let less = BigRational::one() - &square;
    let root = Form::rational(&less * &less + whole(16) * &square).square_root();
    let x = root.plus(&Form::rational(less)).scaled(&whole(8).recip());
    let inner = x.scaled(&(whole(2) * &size));
    let cosine = x.to_float().sqrt();
    let alpha = cosine.min(1.0).acos().to_degrees();
    let beta = (0.5 / cosine).min(1.0).acos().to_degrees();
    let outer = Form::rational(size);
    let solution = |sign: f64| {
        // The first crank stands at 0.
        let at = |index: usize, size: &Form, angle: f64| Found {
            index,
            mass_radius: Real::of(size.clone()),
            vector: None,
            angle: (sign * (angle - alpha)).rem_euclid(360.0),
            turn: None,
            cosine: None,
            position: None,
        };
        let mut found = vec![
            at(*first, &outer, alpha),
            at(*second, &inner, 180.0 + beta),
            at(*third, &inner, 180.0 - beta),
            at(*last, &outer, -alpha),
        ];
        found.sort_by_key(|one| one.index);
        found
    };
    Ok(Answer::Found(vec![solution(1.0), solution(-1.0)]))
}
