//! At which bank angles does the part of an order along the reference direction vanish, or the part across it?
//!
//! Along direction 0 an order swings with `½|P⁺ + P̄⁻|`, across it with `½|P⁺ − P̄⁻|` (theory, sections 3 and 9). With open
//! φ both are sums `Σ_j e^{ijφ} S_j`, solved as every other.

use num_rational::BigRational;
use num_traits::One;

use super::classify::{phase, sums_of, weight};
use super::zeros::{Zeros, sums_zeros};
use crate::engine::{Cylinder, Family, Linear};
use crate::proof::{Planar, Sense};

/// A part of the force or the moment.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Component {
    /// Along the reference direction, the bisector of a V: vertical.
    Along,
    /// Across it: horizontal.
    Across,
}

/// The values of an unknown, φ or δ, in a range, in turns and with its ends, at which a component of one order vanishes; not solved where another angle is
/// open too.
pub fn component_zeros(
    family: &Family,
    quantity: Planar,
    order: u32,
    component: Component,
    (unknown, range): (&str, [&BigRational; 2]),
) -> Zeros {
    let sign = BigRational::from_integer(if component == Component::Along { 1.into() } else { (-1).into() });
    let terms = family.cylinders().iter().flat_map(|cylinder: &Cylinder<Linear, Linear>| {
        let weight = weight(family, cylinder, quantity);
        let mirrored = phase(cylinder, order, Sense::Reverse).scaled(&-BigRational::one());
        let reverse = (mirrored, weight.scaled(&sign));
        [(phase(cylinder, order, Sense::Direct), weight), reverse]
    });
    let terms: Vec<(Linear, Linear)> = terms.collect();
    sums_zeros(&sums_of(&terms), unknown, range)
}
