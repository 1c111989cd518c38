//! What does the height of a Lanchester pair do to the roll moment?
//!
//! The frame rolls with −T, T the inertia torque on the crankshaft (theory, section 3), and with the moments of the shafts
//! about the crankshaft's axis. A pair at ±k, its axes at the heights h₊ and h₋ and at equal distances on both sides, turns
//! the frame with `−(h₊ − h₋) k² U sin(kθ + …) ω²`. In an in-line engine `T = Σ m r² ω² b_k sin kψ` and `2k²U = |Σ m r c_k
//! e^{ikβ}|` have the same phase, and the pair holds −T in balance at `h₊ − h₋ = −2 r b_k / c_k`: nearly the rod length at
//! order 2, since `b_2 ≈ −½` and `c_2 ≈ λ`. The effect is linear: half that height takes half the torque of the order.

use num_traits::{ToPrimitive, Zero};

use super::comparable_engine::ComparableEngine;
use crate::engine::{Engine, Rod};
use crate::motion::{Enclosure, SliderCrank};

/// The height difference of a pair that takes the roll moment of its order away.
#[derive(Clone, Debug, PartialEq)]
pub struct PairHeight {
    /// The order k.
    pub order: u32,
    /// `(h₊ − h₋)/r`: how much higher the shaft lies that turns with the crank.
    pub in_crank_radii: f64,
    /// The same in metres, where the layout gives its crank radius.
    pub metres: Option<f64>,
}

/// The height of the pair of an order in an engine whose cylinders are in one line, with equal centric rods and crank
/// radii; `None` for others, and where the rods are not known or the order has no force.
pub fn pair_height(engine: &Engine, order: u32) -> Option<PairHeight> {
    let rod = engine.rods().next().filter(|_| !engine.has_links())?;
    let [first, ..] = engine.cylinders() else { return None };
    let alike = engine.cylinders().iter().all(|at| at.bank == first.bank && at.crank_radius == first.crank_radius);
    let upright = first.bank.turns().is_zero();
    let same_rods = engine.rods().all(|other: &Rod| other == rod);
    let faster = engine.faster_crank().is_some();
    if faster
        || !alike
        || !upright
        || !same_rods
        || !rod.offset.is_zero()
        || rod.ratio.is_zero()
        || order == 0
        || order % 2 == 1
    {
        return None;
    }
    let crank = SliderCrank::new(rod.ratio.clone(), rod.offset.clone()).ok()?;
    let subject = ComparableEngine::new(engine).ok()?;
    if subject.force(order, crate::proof::Sense::Direct).vanishes() {
        return None;
    }
    let part = |enclosure: &Enclosure| enclosure.to_float();
    // T = Re(−i b_k e^{ikψ}) with the coefficient −i b_k.
    let b = -part(&crank.torque_coefficient(order).im);
    let in_crank_radii = -2.0 * b / part(&crank.coefficient(order).re);
    let radius = engine.dimensions().crank_radius.as_ref().and_then(ToPrimitive::to_f64);
    Some(PairHeight { order, in_crank_radii, metres: radius.map(|radius| in_crank_radii * radius) })
}
