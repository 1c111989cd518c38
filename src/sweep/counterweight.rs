//! How large are the counterweights that hold what turns with the crank?

use num_complex::Complex;
use num_traits::{ToPrimitive, Zero};

use super::integers::IntegerEngine;
use super::swept_engine::{Amplitude, float};
use crate::engine::{Engine, throws};
use crate::order::{self, Factor};
use crate::proof::{Quantity, Sense};

/// The larger of two counterweights in the planes of the outermost throws, as its mass-radius in multiples of m r:
/// `U_1 + U_2 = −P/2`, `z_1 U_1 + z_2 U_2 = −C/2` for the direct first order (theory, section 7).
///
/// A couple alone, √3 a in a six of three throws, needs `U = |C|/2b` in each plane, b apart: then a counterweight at
/// the radius ρ weighs `m_cw = U/ρ` (Grigoryev, Vasilyev and Dolgov, section 2).
pub fn counterweight(engine: &Engine) -> Option<Amplitude> {
    counterweight_of(engine, IntegerEngine::new(engine).as_ref())
}

/// The same for an engine whose whole numbers are known already.
pub(super) fn counterweight_of(engine: &Engine, whole: Option<&IntegerEngine>) -> Option<Amplitude> {
    let whole = whole.filter(|whole| whole.knows(1));
    let [force, moment] = [Quantity::Force, Quantity::Moment].map(|quantity| match whole {
        Some(_) if engine.has_offset() => None,
        Some(whole) => {
            let pair = whole.pair(quantity, 1);
            Some((pair.direct, pair.zeros[0]))
        }
        None => {
            let sum = order::all_masses(engine, quantity, 1, Sense::Direct);
            // With an offset c_1 is not 1.
            let is_plain = sum.parts().keys().all(|factor| *factor == Factor::One);
            let value = sum.parts().values().map(float).sum::<Complex<f64>>();
            is_plain.then(|| (value, sum.vanishes()))
        }
    });
    let ((p, no_force), (c, no_moment)) = (force?, moment?);
    if no_force && no_moment {
        return Some(Amplitude { value: 0.0, vanishes: true });
    }
    let p = if no_force { Complex::zero() } else { p };
    let throws = throws(engine);
    let positions = || throws.iter().map(|throw| &throw.position - engine.reference_plane());
    let (first, second) = (positions().max()?, positions().min()?);
    if first == second {
        return no_moment.then_some(Amplitude { value: p.norm() / 2.0, vanishes: false });
    }
    let (z_1, z_2) = (first.to_f64()?, second.to_f64()?);
    let apart = 2.0 * (z_1 - z_2);
    let larger = ((c - p * z_2) / apart).norm().max(((p * z_1 - c) / apart).norm());
    Some(Amplitude { value: larger, vanishes: false })
}
