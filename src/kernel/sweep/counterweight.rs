//! How large are the counterweights that hold what turns with the crank?

use num_complex::Complex;
use num_rational::BigRational;
use num_traits::{ToPrimitive, Zero};

use super::amplitude::{Amplitude, float};
use super::integers::IntegerEngine;
use crate::engine::{Cylinder, Engine, throws};
use crate::order::{self, Factor};
use crate::proof::{Planar, Sense};

/// The larger of two counterweights in the planes of the outermost throws, as its mass-radius in multiples of m r:
/// `U_1 + U_2 = −P/2`, `z_1 U_1 + z_2 U_2 = −C/2` for the direct first order (theory, section 7).
///
/// A couple alone, √3 a in a six of three throws, needs `U = |C|/2b` in each plane, b apart: then a counterweight at
/// the radius ρ weighs `m_cw = U/ρ` (Grigoryev, Vasilyev and Dolgov, section 2).
///
/// The whole numbers of the engine may be known already.
pub(super) fn counterweight(engine: &Engine, whole: Option<&IntegerEngine>) -> Option<Amplitude> {
    let whole = whole.filter(|whole| whole.knows(1));
    let [force, moment] = match whole {
        Some(_) if engine.has_offset() => return None,
        Some(whole) => whole.pairs(1).map(|pair| Some((pair.direct, pair.zeros[0]))),
        None => Planar::BOTH.map(|quantity| {
            let sum = order::all_masses(engine, quantity, 1, Sense::Direct);
            // With an offset c_1 is not 1.
            let is_plain = sum.parts().keys().all(|factor| *factor == Factor::One);
            let value = sum.parts().values().map(float).sum::<Complex<f64>>();
            is_plain.then(|| (value, sum.vanishes()))
        }),
    };
    let ((p, no_force), (c, no_moment)) = (force?, moment?);
    if no_force && no_moment {
        return Some(Amplitude::ZERO);
    }
    let p = if no_force { Complex::zero() } else { p };
    let (first, second) = outermost(engine)?;
    if first == second {
        return no_moment.then_some(Amplitude::decided(p.norm() / 2.0));
    }
    let [z_1, z_2] = [first, second].map(|position| (position - engine.reference_plane()).to_f64());
    let (z_1, z_2) = (z_1?, z_2?);
    let apart = 2.0 * (z_1 - z_2);
    let larger = ((c - p * z_2) / apart).norm().max(((p * z_1 - c) / apart).norm());
    Some(Amplitude::decided(larger))
}

/// The highest and the lowest position of a throw.
fn outermost(engine: &Engine) -> Option<(BigRational, BigRational)> {
    let ends = |positions: &mut dyn Iterator<Item = &BigRational>| {
        let first = positions.next()?;
        let (high, low) = positions.fold((first, first), |(high, low), at| (high.max(at), low.min(at)));
        Some((high.clone(), low.clone()))
    };
    let cylinders = engine.cylinders();
    let stands_apart = |(place, one): (usize, &Cylinder)| {
        let others = cylinders[..place].iter();
        others.filter(|other| other.pin == one.pin).any(|other| other.position != one.position)
    };
    // A throw is in the middle of its cylinders: where they stand together, at the position of each.
    match cylinders.iter().enumerate().any(stands_apart) {
        false => ends(&mut cylinders.iter().map(|cylinder| &cylinder.position)),
        true => ends(&mut throws(engine).iter().map(|throw| &throw.position)),
    }
}
