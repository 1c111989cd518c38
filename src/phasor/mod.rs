//! Which sum of rotating vectors is an order of the force, the moment, the torque?
//!
//! For order k, with throw β, bank α and arm z (theory, section 3):
//!
//! - direct: `P_k⁺ = Σ m r e^{i(kβ − (k−1)α)}`,
//! - reverse: `P_k⁻ = Σ m r e^{i(−kβ + (k+1)α)}`,
//! - inertia torque: `Σ m r² e^{ik(β − α)}`.
//!
//! The moment weighs each term of the force by its arm z.

use crate::exact::{PhasorSum, Term, Turn};
use crate::layout::{Cylinder, Layout};
use crate::proof::{Quantity, Sense};

/// Angle of a cylinder's vector in the star of order k: direct, reverse, or the torque's (none).
pub fn phase(cylinder: &Cylinder, order: u32, sense: Option<Sense>) -> Turn {
    let k = i64::from(order);
    match sense {
        Some(Sense::Direct) => &cylinder.throw.times(k) - &cylinder.bank.times(k - 1),
        Some(Sense::Reverse) => &cylinder.bank.times(k + 1) - &cylinder.throw.times(k),
        None => (&cylinder.throw - &cylinder.bank).times(k),
    }
}

/// The sum of one quantity, order and sense, one term a cylinder.
///
/// Masses and crank radii are in multiples of the layout's; its coefficient c_k and the factor ½ω² are left out.
pub fn sum(layout: &Layout, quantity: Quantity, order: u32, sense: Option<Sense>) -> PhasorSum {
    let term = |cylinder: &Cylinder| Term {
        angle: phase(cylinder, order, sense),
        weight: match quantity {
            Quantity::Force => cylinder.weight(),
            Quantity::Moment => cylinder.weight() * layout.arm(cylinder),
            Quantity::Torque => cylinder.weight() * &cylinder.crank_radius,
        },
    };
    PhasorSum::new(layout.cylinders.iter().map(term).collect())
}
