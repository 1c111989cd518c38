//! Which masses add to which rotating vector, and by which coefficient of the motion?
//!
//! Order k of force and moment is `½ω²(P_k⁺ e^{ikθ} + P_k⁻ e^{−ikθ})` (theory, section 3). The terms of a sum that have
//! the same coefficient c_k are one exact phasor sum; sums of different coefficients are kept apart.

use std::collections::BTreeMap;

use num_rational::BigRational;
use num_traits::{Signed, Zero};

use crate::exact::{PhasorSum, Term};
use crate::layout::{Cylinder, Layout, Rod};
use crate::phasor;
use crate::proof::Sense;

/// What in the engine a force comes from.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Effect {
    /// Pistons, pins, and the reciprocating part of the rods.
    Reciprocating,
    /// Masses that turn with the crankpins.
    Rotating,
}

/// The coefficient of a sum: none is 1; else c_k of this rod, whose offset is not negative above order 1.
pub type Factor = Option<Rod>;

/// Sums that share a factor, by factor: the vector is `Σ factor · sum`, in multiples of m r.
pub type Parts = BTreeMap<Factor, PhasorSum>;

/// How much of a force at a position counts: all of it for the force, its arm for the moment, a bearing's part of it.
pub type Weighing<'a> = &'a dyn Fn(&BigRational) -> BigRational;

/// The sums of one order and sense that an effect adds, each force weighed by its position.
pub(super) fn parts(layout: &Layout, effect: Effect, weighing: Weighing, order: u32, sense: Sense) -> Parts {
    match effect {
        Effect::Reciprocating => reciprocating(layout, weighing, order, sense),
        Effect::Rotating => rotating(layout, weighing, order, sense),
    }
}

fn reciprocating(layout: &Layout, weighing: Weighing, order: u32, sense: Sense) -> Parts {
    let mut parts: BTreeMap<Factor, Vec<Term>> = BTreeMap::new();
    for (cylinder, rod) in layout.cylinders.iter().zip(&layout.mechanism.rods) {
        let Some((factor, sign)) = factor(rod, order) else { continue };
        let weight = mass_radius(layout, cylinder) * weighing(&cylinder.position) * sign;
        parts.entry(factor).or_default().push(Term { angle: phasor::phase(cylinder, order, Some(sense)), weight });
    }
    parts.into_iter().map(|(factor, terms)| (factor, PhasorSum::new(terms))).collect()
}

/// The coefficient of a rod with the sign that its offset gives it; none where it is zero.
///
/// The root `√(1−(λ sinψ−δ)²)` stays as it is where δ changes its sign and ψ goes on by half a turn, so that its
/// coefficient of order k then changes by (−1)^k; c_1 has the crank's own 1 beside it.
pub(super) fn factor(rod: &Rod, order: u32) -> Option<(Factor, BigRational)> {
    let one = BigRational::from_integer(1.into());
    let centric = rod.offset.is_zero();
    match order {
        1 if centric => Some((None, one)),
        1 => Some((Some(rod.clone()), one)),
        _ if rod.ratio.is_zero() || (centric && order % 2 == 1) => None,
        _ => {
            let flips = rod.offset.is_negative() && order % 2 == 1;
            let rod = Rod { ratio: rod.ratio.clone(), offset: rod.offset.abs() };
            Some((Some(rod), if flips { -one } else { one }))
        }
    }
}

/// A mass U at the crankpin adds `2U e^{iβ}` to the direct vector of order 1.
fn rotating(layout: &Layout, weighing: Weighing, order: u32, sense: Sense) -> Parts {
    if (order, sense) != (1, Sense::Direct) || layout.mechanism.rotating_masses.is_empty() {
        return Parts::new();
    }
    let two = BigRational::from_integer(2.into());
    let unit = unit_mass(layout);
    let terms = layout.cylinders.iter().zip(&layout.mechanism.rotating_masses).map(|(cylinder, mass)| Term {
        angle: cylinder.throw.clone(),
        weight: &two * mass / &unit * &cylinder.crank_radius * weighing(&cylinder.position),
    });
    Parts::from([(None, PhasorSum::new(terms.collect()))])
}

/// The sums of the inertia torque of one order, by rod: `Σ m r² e^{ik(β−α)}`, in multiples of m r².
pub(super) fn torque_parts(layout: &Layout, order: u32) -> BTreeMap<Rod, PhasorSum> {
    let mut parts: BTreeMap<Rod, Vec<Term>> = BTreeMap::new();
    for (cylinder, rod) in layout.cylinders.iter().zip(&layout.mechanism.rods) {
        let weight = mass_radius(layout, cylinder) * &cylinder.crank_radius;
        parts.entry(rod.clone()).or_default().push(Term { angle: phasor::phase(cylinder, order, None), weight });
    }
    parts.into_iter().map(|(rod, terms)| (rod, PhasorSum::new(terms))).collect()
}

/// Mass times crank radius of a cylinder, in multiples of m r; 0 in an engine without reciprocating masses.
pub(super) fn mass_radius(layout: &Layout, cylinder: &Cylinder) -> BigRational {
    match &layout.mechanism.mass {
        Some(mass) if mass.is_zero() => BigRational::zero(),
        _ => cylinder.weight(),
    }
}

/// The mass in kilograms that the sums are multiples of: m, or one kilogram where m is 0 or not known.
pub(super) fn unit_mass(layout: &Layout) -> BigRational {
    let mass = layout.mechanism.mass.clone().filter(|mass| !mass.is_zero());
    mass.unwrap_or_else(|| BigRational::from_integer(1.into()))
}
