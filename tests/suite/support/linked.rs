//! Master rods and links, each body on its closed motion: what the tests of articulated rods compare the program with.

use std::f64::consts::TAU;

use crankstar::engine::Engine;
use crankstar::file;
use crankstar::loads::{self, Loads, OrderLoads};
use num_complex::Complex;
use num_traits::ToPrimitive;

pub fn read(text: &str) -> Engine {
    file::parse("engine.toml", text).unwrap_or_else(|error| panic!("{error}\n{text}"))
}

pub fn of_orders(engine: &Engine, orders: &[u32]) -> Loads {
    loads::loads(engine, orders).expect("numbers")
}

pub fn order(loads: &Loads, order: u32) -> &OrderLoads {
    loads.orders.iter().find(|one| one.order == order).expect("an order")
}

/// Half of each vector, to as many digits behind the point as the table prints.
#[track_caller]
pub fn assert_halves(swing: &loads::Swing, expected: [f64; 2], digits: i32) {
    let found = [swing.direct.value.norm() / 2.0, swing.reverse.value.norm() / 2.0];
    for (found, expected) in found.into_iter().zip(expected) {
        assert!((found - expected).abs() <= 0.5001 * 10_f64.powi(-digits), "{found}, expected {expected}");
    }
}

/// A master rod and a link: κ = a/l, Δ and ε in radians, and L, in crank radii as all lengths here.
#[derive(Clone, Copy)]
pub struct Linked {
    pub rod: f64,
    pub radius: f64,
    pub delta: f64,
    pub correction: f64,
    pub link: f64,
}

impl Linked {
    /// The knuckle pin, seen with the master's axis in direction 0, at a crank angle after its top dead centre.
    pub fn knuckle(&self, psi: f64) -> Complex<f64> {
        let slant = psi.sin() / self.rod;
        let along = Complex::new((1.0 - slant * slant).sqrt(), -slant);
        Complex::cis(psi) + self.radius * along * Complex::cis(self.delta + self.correction)
    }

    /// How far the piston of the link stands out on its own axis.
    pub fn piston(&self, psi: f64) -> f64 {
        let seen = self.knuckle(psi) * Complex::cis(-self.delta);
        seen.re + (self.link * self.link - seen.im * seen.im).sqrt()
    }

    pub fn master(&self, psi: f64) -> f64 {
        psi.cos() + (self.rod * self.rod - psi.sin() * psi.sin()).sqrt()
    }

    /// c_k, by the mean over points of a turn; ψ counts from its own cylinder.
    pub fn coefficient(&self, order: u32) -> Complex<f64> {
        let (k, points) = (f64::from(order), 512);
        let angles = (0..points).map(|j| TAU * f64::from(j) / f64::from(points));
        let sum: Complex<f64> = angles.map(|psi| self.piston(psi + self.delta) * Complex::cis(-k * psi)).sum();
        sum * (2.0 * k * k / f64::from(points))
    }
}

/// A mass on its way.
pub type Body = (f64, Box<dyn Fn(f64) -> Complex<f64>>);

/// The second derivative, from nine points: of eighth order.
pub fn second_derivative(way: &dyn Fn(f64) -> Complex<f64>, at: f64) -> Complex<f64> {
    const WEIGHTS: [f64; 5] = [-205.0 / 72.0, 8.0 / 5.0, -1.0 / 5.0, 8.0 / 315.0, -1.0 / 560.0];
    let step = 0.012;
    let pair = |n: usize| way(at + n as f64 * step) + way(at - n as f64 * step);
    let sum: Complex<f64> = (1..5).map(|n| pair(n) * WEIGHTS[n]).sum();
    (way(at) * WEIGHTS[0] + sum) / (step * step)
}

/// The orders of the force add up to what the momentum of every body loses, at crank angles all round.
#[track_caller]
pub fn assert_shakes_as_bodies(text: &str, bodies: &[Body], orders: &[u32]) {
    let engine = read(text);
    let harmonics = of_orders(&engine, orders).force.harmonics().to_vec();
    // The program counts in multiples of the first mass that is not zero.
    let unit = engine.dimensions().mass.clone().and_then(|mass| mass.to_f64()).expect("a mass");
    for place in 0..7 {
        let theta = 0.3 + f64::from(place);
        let expected: Complex<f64> =
            bodies.iter().map(|(mass, way)| -second_derivative(way, theta) * *mass / unit).sum();
        let at = |one: &loads::Harmonic| {
            let k = f64::from(one.order);
            one.direct * Complex::cis(k * theta) + one.reverse * Complex::cis(-k * theta)
        };
        let sum: Complex<f64> = harmonics.iter().map(at).sum();
        assert!((sum - expected).norm() < 1e-9 * 20.0, "{sum} and {expected}\n{text}");
    }
}
