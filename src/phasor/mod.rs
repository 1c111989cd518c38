//! Which sum of rotating vectors is an order of the force, the moment, the torque?
//!
//! For order k, with throw β, bank α and arm z (theory, section 3):
//!
//! - direct: `P_k⁺ = Σ m e^{i(kβ − (k−1)α)}`,
//! - reverse: `P_k⁻ = Σ m e^{i(−kβ + (k+1)α)}`,
//! - inertia torque: `Σ m e^{ik(β − α)}`.
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
/// The coefficient c_k, the factor ½ω² and the crank radius, common to all terms, are left out.
pub fn sum(layout: &Layout, quantity: Quantity, order: u32, sense: Option<Sense>) -> PhasorSum {
    let term = |cylinder: &Cylinder| Term {
        angle: phase(cylinder, order, sense),
        weight: match quantity {
            Quantity::Moment => &cylinder.reciprocating_mass * layout.arm(cylinder),
            Quantity::Force | Quantity::Torque => cylinder.reciprocating_mass.clone(),
        },
    };
    PhasorSum::new(layout.cylinders.iter().map(term).collect())
}
