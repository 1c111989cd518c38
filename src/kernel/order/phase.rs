//! Where is a cylinder's vector in the star of an order?
//!
//! With throw β and bank angle α (theory, section 3):
//!
//! - direct: `kβ − (k−1)α`,
//! - reverse: `−kβ + (k+1)α`,
//! - inertia torque: `k(β − α)`.

use crate::engine::Cylinder;
use crate::exact::Turn;
use crate::proof::Sense;

/// How many times the throw β and the bank angle α enter the phase: direct, reverse, or the torque's (none).
pub fn multiples(order: u32, sense: Option<Sense>) -> [i64; 2] {
    let k = i64::from(order);
    match sense {
        Some(Sense::Direct) => [k, 1 - k],
        Some(Sense::Reverse) => [-k, k + 1],
        None => [k, -k],
    }
}

/// Angle of a cylinder's vector in the star of order k: direct, reverse, or the torque's (none).
pub fn phase(cylinder: &Cylinder, order: u32, sense: Option<Sense>) -> Turn {
    phase_of(&cylinder.throw, &cylinder.bank, order, sense)
}

/// The same for a throw β and a bank angle α.
pub fn phase_of(throw: &Turn, bank: &Turn, order: u32, sense: Option<Sense>) -> Turn {
    let [of_throw, of_bank] = multiples(order, sense);
    &throw.times(of_throw) + &bank.times(of_bank)
}
