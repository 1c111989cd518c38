//! How large are the counterweights that hold what turns with the crank?

use num_rational::BigRational;
use num_traits::{ToPrimitive, Zero};

use super::point::{Part, float, parts};
use crate::exact::PhasorSum;
use crate::layout::{Layout, throws};
use crate::proof::{Quantity, Sense};

/// The larger of two counterweights in the planes of the outermost throws, as its mass-radius in multiples of m r:
/// `U_1 + U_2 = −P/2`, `z_1 U_1 + z_2 U_2 = −C/2` for the direct first order (theory, section 7).
///
/// A couple alone, √3 a in a six of three throws, needs `U = |C|/2b` in each plane, b apart: then a counterweight at
/// the radius ρ weighs `m_cw = U/ρ` (Grigoryev, Vasilyev and Dolgov, section 2).
pub fn counterweight(layout: &Layout) -> Option<Part> {
    let force = parts(layout, Quantity::Force, 1, Sense::Direct);
    let moment = parts(layout, Quantity::Moment, 1, Sense::Direct);
    let is_gone = |parts: &crate::loads::Parts| parts.values().all(PhasorSum::vanishes);
    if is_gone(&force) && is_gone(&moment) {
        return Some(Part { value: 0.0, vanishes: true });
    }
    if force.keys().chain(moment.keys()).any(Option::is_some) {
        // With an offset c_1 is not 1.
        return None;
    }
    let throws = throws(layout);
    let positions = || throws.iter().map(|throw| &throw.position - &layout.reference_plane);
    let (first, second) = (positions().max()?, positions().min()?);
    let value = |parts: &crate::loads::Parts| parts.values().map(float).sum::<num_complex::Complex<f64>>();
    let (p, c) = (if is_gone(&force) { Zero::zero() } else { value(&force) }, value(&moment));
    if first == second {
        return is_gone(&moment).then_some(Part { value: p.norm() / 2.0, vanishes: false });
    }
    let number = |value: &BigRational| value.to_f64();
    let (z_1, z_2) = (number(&first)?, number(&second)?);
    let apart = 2.0 * (z_1 - z_2);
    let larger = ((c - p * z_2) / apart).norm().max(((p * z_1 - c) / apart).norm());
    Some(Part { value: larger, vanishes: false })
}
