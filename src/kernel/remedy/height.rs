//! What does the height of a Lanchester pair do to the roll moment?
//!
//! The frame rolls with −T, T the inertia torque on the crankshaft (theory, section 3), and with the moments of the shafts
//! about the crankshaft's axis. A pair at ±k, its axes at the heights h₊ and h₋ and at equal distances on both sides, turns
//! the frame with `−(h₊ − h₋) k² U sin(kθ + …) ω²`. In an in-line engine `T = Σ m r² ω² b_k sin kψ` and `2k²U = |Σ m r c_k
//! e^{ikβ}|` have the same phase, and the pair holds −T in balance at `h₊ − h₋ = −2 r b_k / c_k`: nearly the rod length at
//! order 2, since `b_2 ≈ −½` and `c_2 ≈ λ`. The effect is linear: half that height takes half the torque of the order.

use num_complex::Complex;
use num_traits::{ToPrimitive, Zero};

use super::comparable_engine::ComparableEngine;
use crate::engine::{Cylinder, Engine, Rods};
use crate::gas::CylinderGas;
use crate::motion::{Enclosure, SliderCrank};
use crate::numbers;

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
    let Rods::Alike(rod) = engine.all_rods() else { return None };
    let [first, ..] = engine.cylinders() else { return None };
    let alike = engine.cylinders().iter().all(|at| at.bank == first.bank && at.crank_radius == first.crank_radius);
    let upright = first.bank.turns().is_zero();
    // Crankshafts side by side roll the frame about axes of their own, and against each other where they turn so.
    if !engine.geared_cranks().is_empty()
        || !alike
        || !upright
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

/// The roll moment of an even order with a pair that cancels the force of the order, its shafts at any places, gas and inertia together.
///
/// With `A = N m r ω² c_k`, the shaft with the crank at (x₁, y₁), that against it at (x₂, y₂), and `T = N(a_g cos kθ + (b_g + b_in ω²) sin kθ)` the
/// frame feels `−(½A(x₁ − x₂) + N(b_g + b_in ω²)) sin kθ + (½A(y₁ + y₂) − N a_g) cos kθ`.
#[derive(Clone, Debug, PartialEq)]
pub struct PairRoll {
    /// The order k.
    pub order: u32,
    /// `N a_g` and `N b_g` of the gas in newton-metres; zero where the layout gives none.
    pub gas: [f64; 2],
    /// `N b_in` of the masses over ω², in kg m².
    pub inertia: f64,
    /// `N m r c_k` in kilogram metres.
    pub force: f64,
}

impl PairRoll {
    /// That of the engines of [`pair_height`], with equal masses and one gas in all cylinders that fire as the cranks pass their axes; none
    /// of others, and where mass or crank radius is not known.
    pub fn new(engine: &Engine, order: u32) -> Option<Self> {
        let height = pair_height(engine, order)?;
        let first = engine.cylinders().first()?;
        let alike = |at: &Cylinder| at.reciprocating_mass == first.reciprocating_mass;
        let mass = engine.dimensions().mass.as_ref()? * &first.reciprocating_mass;
        let radius = engine.dimensions().crank_radius.as_ref()? * &first.crank_radius;
        let turns = engine.cylinders().iter().map(|at| &at.throw);
        let star: Complex<f64> = turns.map(|throw| numbers::direction(&throw.times(i64::from(order)))).sum();
        let gas = match engine.gas() {
            None => Complex::default(),
            Some(gas) if gas.chambers.iter().all(|chamber| *chamber == gas.chambers[0]) => {
                let cylinder = CylinderGas::new(engine, 0).ok()?;
                let highest = order as usize * cylinder.revolutions() as usize;
                cylinder.harmonics(highest).torque.get(highest).copied()?
            }
            Some(_) => return None,
        };
        let rod = first.rod()?;
        let crank = SliderCrank::new(rod.ratio.clone(), rod.offset.clone()).ok()?;
        let count = numbers::length(star);
        let (mass, radius) = (numbers::float(&mass), numbers::float(&radius));
        let force = count * mass * radius * crank.coefficient(order).re.to_float();
        let same = engine.cylinders().iter().all(alike);
        // The torque of a cylinder is Re(t e^{ikψ}), t = a − ib.
        same.then(|| PairRoll {
            order,
            gas: [count * gas.re, -count * gas.im],
            inertia: -height.in_crank_radii * radius * force / 2.0,
            force,
        })
    }

    /// The peak of the roll moment of the order in newton-metres, with the pair at `x₁ − x₂` and `y₁ + y₂` in metres, at a speed in rpm.
    pub fn peak(&self, rpm: f64, [height, sideways]: [f64; 2]) -> f64 {
        let square = square(rpm);
        let sine = self.force * square * height / 2.0 + self.gas[1] + self.inertia * square;
        let cosine = self.force * square * sideways / 2.0 - self.gas[0];
        libm::hypot(sine, cosine)
    }

    /// `x₁ − x₂` and `y₁ + y₂` in metres at which the pair cancels the roll moment of the order at a speed.
    pub fn place(&self, rpm: f64) -> [f64; 2] {
        let force = self.force * square(rpm);
        [-2.0 * (self.gas[1] / force + self.inertia / self.force), 2.0 * self.gas[0] / force]
    }

    /// The same with the least sum of squares over several speeds; none without a speed above 0. The moment grows with ω², and so the
    /// weight of a speed with ω⁴.
    pub fn best_place(&self, speeds: &[f64]) -> Option<[f64; 2]> {
        let weights = speeds.iter().map(|rpm| square(*rpm).powi(2));
        let all: f64 = weights.clone().sum();
        let mean = |part: usize| {
            speeds.iter().zip(weights.clone()).map(|(rpm, w)| w * self.place(*rpm)[part]).sum::<f64>() / all
        };
        (all > 0.0 && speeds.iter().all(|rpm| *rpm > 0.0)).then(|| [mean(0), mean(1)])
    }
}

fn square(rpm: f64) -> f64 {
    let omega = numbers::angular_speed(rpm);
    omega * omega
}
