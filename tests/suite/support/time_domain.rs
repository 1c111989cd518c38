//! The forces of all pistons on their exact paths, added up at each moment of a revolution: no star, no coefficient.

use std::f64::consts::TAU;
use std::ops::{Add, Mul, Sub};

use num_complex::Complex;
use num_rational::BigRational;
use num_traits::ToPrimitive;

use crankstar::engine::{Cylinder, Engine, Link};
use crankstar::numbers;
use crankstar::proof::Sense;
use crankstar::remedy::ComparableEngine;

/// Steps through a revolution: their mean is exact for all orders that these rods have to speak of.
const STEPS: usize = 512;
/// r/l of engines whose layout names no rod.
const RATIO: f64 = 0.3;

/// The largest difference of the four vectors of an order, force and moment about position 0, in m r ω².
pub fn difference(engine: &Engine, order: u32) -> f64 {
    let subject = ComparableEngine::new(engine).expect("masses in one unit");
    let mut worst = 0.0_f64;
    for (sense, sign) in [(Sense::Direct, 1.0), (Sense::Reverse, -1.0)] {
        for (sum, arm) in [(subject.force(order, sense), false), (subject.moment(order, sense), true)] {
            let there = subject.value(&sum, order, sense);
            let there = there.unwrap_or_else(|| {
                let star = sum.only().map_or(Complex::new(0.0, 0.0), |(_, sum)| numbers::evaluate(sum));
                star * coefficient(order)
            });
            worst = worst.max((there - vector(engine, sign * f64::from(order), arm)).norm());
        }
    }
    worst
}

/// Twice the mean of `F e^{−ikθ}`, where F is the force of all pistons, or its moment.
fn vector(engine: &Engine, order: f64, with_arm: bool) -> Complex<f64> {
    let steps = (0..STEPS).map(|step| TAU * step as f64 / STEPS as f64);
    let at = |theta: f64| {
        let forces = engine.cylinders().iter().map(|cylinder| {
            let arm = if with_arm { cylinder.position.to_f64().expect("a position") } else { 1.0 };
            let bank = TAU * cylinder.bank.turns().to_f64().expect("an angle");
            let mass = cylinder.reciprocating_mass.to_f64().expect("a mass");
            Complex::from_polar(1.0, bank) * (-arm * mass * path(cylinder, theta).0[2])
        });
        forces.sum::<Complex<f64>>() * Complex::from_polar(1.0, -order * theta)
    };
    steps.map(at).sum::<Complex<f64>>() * (2.0 / STEPS as f64)
}

/// Where a piston is, how fast it goes and how fast that changes, over the crank angle; lengths in crank radii.
fn path(cylinder: &Cylinder, theta: f64) -> Jet {
    let [throw, bank] = [&cylinder.throw, &cylinder.bank].map(|angle| TAU * angle.turns().to_f64().expect("an angle"));
    if let Some(link) = cylinder.link() {
        return hung(theta + throw - bank, link);
    }
    let (rod, offset) = match cylinder.rod() {
        Some(rod) => {
            let [ratio, offset] = [&rod.ratio, &rod.offset].map(|value| value.to_f64().expect("a number"));
            (1.0 / ratio, offset / ratio)
        }
        None => (1.0 / RATIO, 0.0),
    };
    slider(theta + throw - bank, rod, offset)
}

/// `cos ψ + √(l² − (sin ψ − e)²)`.
fn slider(psi: f64, rod: f64, offset: f64) -> Jet {
    let across = Jet::sine(psi) - Jet::fixed(offset);
    Jet::cosine(psi) + (Jet::fixed(rod * rod) - across * across).root()
}

/// A piston whose link hangs on a knuckle pin of a master rod: seen with its own axis in direction 0, the pin stands at the crank
/// pin and the knuckle radius along the master rod, whose piston stands Δ behind; the link reaches from there to the axis.
fn hung(psi: f64, link: &Link) -> Jet {
    let number = |value: &BigRational| value.to_f64().expect("a number");
    let delta = TAU * number(link.angle.turns());
    let (ratio, knuckle) = (number(&link.master), number(&link.knuckle) / number(&link.master));
    // The master rod as its own cylinder sees it: from the crankpin outwards, and across.
    let sine = Jet::sine(psi + delta) * Jet::fixed(ratio);
    let (along, across) = ((Jet::fixed(1.0) - sine * sine).root(), Jet::fixed(0.0) - sine);
    // Its knuckle pin is turned by Δ + ε against it, and this cylinder's axis by Δ against that of the master's: ε is left.
    let correction = TAU * number(link.correction.turns());
    let (cos, sin) = (Jet::fixed(correction.cos()), Jet::fixed(correction.sin()));
    let (along, across) = (along * cos - across * sin, along * sin + across * cos);
    let (along, across) =
        (Jet::cosine(psi) + along * Jet::fixed(knuckle), Jet::sine(psi) + across * Jet::fixed(knuckle));
    along + (Jet::fixed(1.0 / (number(&link.ratio) * number(&link.ratio))) - across * across).root()
}

/// `c_k` of a rod that is not named, by the mean of its own motion.
fn coefficient(order: u32) -> f64 {
    let steps = (0..STEPS).map(|step| TAU * step as f64 / STEPS as f64);
    let part = steps.map(|psi| -slider(psi, 1.0 / RATIO, 0.0).0[2] * (f64::from(order) * psi).cos());
    part.sum::<f64>() * (2.0 / STEPS as f64)
}

/// A number with its first and second derivative.
#[derive(Clone, Copy)]
struct Jet([f64; 3]);

impl Jet {
    fn fixed(value: f64) -> Self {
        Jet([value, 0.0, 0.0])
    }

    fn sine(angle: f64) -> Self {
        Jet([angle.sin(), angle.cos(), -angle.sin()])
    }

    fn cosine(angle: f64) -> Self {
        Jet([angle.cos(), -angle.sin(), -angle.cos()])
    }

    fn root(self) -> Self {
        let [value, first, second] = self.0;
        let root = value.sqrt();
        Jet([root, first / (2.0 * root), second / (2.0 * root) - first * first / (4.0 * root * value)])
    }
}

impl Add for Jet {
    type Output = Jet;
    fn add(self, other: Jet) -> Jet {
        Jet(std::array::from_fn(|at| self.0[at] + other.0[at]))
    }
}

impl Sub for Jet {
    type Output = Jet;
    fn sub(self, other: Jet) -> Jet {
        Jet(std::array::from_fn(|at| self.0[at] - other.0[at]))
    }
}

impl Mul for Jet {
    type Output = Jet;
    fn mul(self, other: Jet) -> Jet {
        let ([a, da, dda], [b, db, ddb]) = (self.0, other.0);
        Jet([a * b, da * b + a * db, dda * b + 2.0 * da * db + a * ddb])
    }
}
