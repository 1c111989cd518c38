//! Which angles have three masses whose moments about the plane of a fourth close to a triangle?

use num_rational::BigRational;
use num_traits::{One, Signed, ToPrimitive, Zero};

use super::answer::{Answer, Found, NotSolved, Reason};
use super::exact::Real;
use super::wanted::{Wanted, mass_radius};
use crate::file::Rotor;
use crate::numbers::{self, Form};

/// One mass wholly wanted in its plane, and the angles of three others, or of two of them; or its size alone, and the angles of all three.
pub(super) fn solve(rotor: &Rotor, wanted: &[(usize, Wanted)]) -> Result<Answer, NotSolved> {
    let is_whole = |wanted: &Wanted| wanted.size && !wanted.position;
    let is_angle = |wanted: &Wanted| !wanted.size && wanted.angle && !wanted.position;
    let whole: Vec<usize> = wanted.iter().filter(|(_, one)| is_whole(one)).map(|(index, _)| *index).collect();
    let angles: Vec<usize> = wanted.iter().filter(|(_, one)| is_angle(one)).map(|(index, _)| *index).collect();
    let others: Vec<usize> = (0..rotor.masses.len()).filter(|index| !whole.contains(index)).collect();
    let (&[plane], &[_, _, _]) = (whole.as_slice(), others.as_slice()) else { return Err(NotSolved) };
    // Where the angle of the wanted mass is given, that alone says how all of them are turned.
    let given = rotor.masses[plane].angle.as_ref().map(|turn| turn.degrees());
    let needed = if given.is_some() { 3 } else { 2 };
    if whole.len() + angles.len() != wanted.len() || angles.len() < needed {
        return Err(NotSolved);
    }
    // The one whose angle is given stands first; else the first of the file at 0.
    let first = others.iter().copied().find(|index| !angles.contains(index)).unwrap_or(others[0]);
    let mut order = vec![first];
    order.extend(others.into_iter().filter(|index| *index != first));
    let reference = rotor.masses[first].angle.as_ref().map_or_else(BigRational::zero, |turn| turn.degrees());
    let from = rotor.masses[plane].position.as_ref().ok_or(NotSolved)?;
    let mut sides = Vec::new();
    for &index in &order {
        let mass = &rotor.masses[index];
        let size = mass_radius(rotor, mass).ok_or(NotSolved)?;
        sides.push([&size * (mass.position.as_ref().ok_or(NotSolved)? - from), size]);
    }
    if sides.iter().any(|[moment, _]| moment.is_zero()) {
        return Err(NotSolved);
    }
    let cosine = |a: usize, b: usize, c: usize| {
        let of = |index: usize| &sides[index][0];
        let two = BigRational::from_integer(2.into());
        (of(c) * of(c) - of(a) * of(a) - of(b) * of(b)) / (two * of(a) * of(b))
    };
    let (second, third, between) = (cosine(0, 1, 2), cosine(0, 2, 1), cosine(1, 2, 0));
    if second.abs() > BigRational::one() {
        return Ok(Answer::Never(Reason::NoTriangle));
    }
    let [u, v, w] = [0, 1, 2].map(|index: usize| &sides[index][1]);
    let two = BigRational::from_integer(2.into());
    let square = u * u + v * v + w * w + two * (u * v * &second + u * w * &third + v * w * &between);
    let is_flat = second.abs() == BigRational::one();
    let solution = |sign: f64| {
        let angle = |cosine: &BigRational| numbers::float(cosine).clamp(-1.0, 1.0).acos().to_degrees();
        // Moments that point one way at negative arms turn their masses round: the cosines have that sign already.
        let one = sign * angle(&second);
        let sine = -numbers::float(&sides[1][0]) * one.to_radians().sin() / numbers::float(&sides[2][0]);
        let other = sine.atan2(numbers::float(&third)).to_degrees();
        let base = reference.to_f64().unwrap_or(0.0);
        let known = [base, base + one, base + other];
        let mut found = Vec::new();
        let (mut re, mut im) = (0.0, 0.0);
        for ((&index, [_, size]), at) in order.iter().zip(&sides).zip(known) {
            let (sin, cos) = at.to_radians().sin_cos();
            (re, im) = (re - numbers::float(size) * cos, im - numbers::float(size) * sin);
            if rotor.masses[index].angle.is_none() {
                let cosine = if index == first {
                    None
                } else if at == known[1] {
                    Some(second.clone())
                } else {
                    Some(third.clone())
                };
                found.push(Found {
                    index,
                    mass_radius: Real::of(Form::rational(size.clone())),
                    vector: None,
                    angle: at.rem_euclid(360.0),
                    turn: None,
                    cosine,
                    position: None,
                });
            }
        }
        found.push(Found {
            index: plane,
            mass_radius: Real::of(Form::rational(square.clone()).square_root()),
            vector: None,
            angle: im.atan2(re).to_degrees().rem_euclid(360.0),
            turn: None,
            cosine: None,
            position: None,
        });
        if let Some(given) = given.as_ref().and_then(ToPrimitive::to_f64) {
            let turned = given - im.atan2(re).to_degrees();
            for one in &mut found {
                one.angle = (one.angle + turned).rem_euclid(360.0);
            }
            // Its own, without the rounding.
            found.iter_mut().filter(|one| one.index == plane).for_each(|one| one.angle = given.rem_euclid(360.0));
        }
        found.sort_by_key(|one| one.index);
        found
    };
    Ok(Answer::Found(if is_flat { vec![solution(1.0)] } else { vec![solution(1.0), solution(-1.0)] }))
}
