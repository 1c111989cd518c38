//! What of the engine's forces does one place of a shaft carry?

use num_complex::Complex;
use num_rational::BigRational;

use crate::engine::Engine;
use crate::numbers;
use crate::order::{self, MassGroup};

/// What of the engine's forces one place carries.
#[derive(Clone, Debug)]
pub struct Carried {
    /// The part of the load of each crankpin.
    pub parts: Vec<f64>,
    /// What the masses of the crankshaft itself pull there with at θ = 0, in newtons; it turns with the crank.
    pub shaft: Complex<f64>,
    /// How many times that turns while the reference turns once; below 0 against it.
    pub turns: f64,
}

impl Carried {
    /// What the masses of the crankshaft pull there with.
    pub(super) fn of_shaft(&self, theta: f64) -> Complex<f64> {
        self.shaft * Complex::cis(self.turns * theta)
    }
}

/// What a bearing carries: these parts of the pins, and those of the masses of the crankshaft itself.
pub(super) fn carried_by(
    engine: &Engine,
    crank: usize,
    parts: &[BigRational],
    part: impl Fn(&BigRational) -> BigRational,
    newtons: f64,
) -> Carried {
    let is_own = |group: MassGroup| match group {
        MassGroup::Crankshaft | MassGroup::Counterweights => true,
        // Rods load the pins, and a balancer shaft is in bearings of its own.
        MassGroup::Reciprocating | MassGroup::Rotating | MassGroup::Balancers => false,
    };
    let turns = turns_of(engine, crank);
    let speed = turns * turns;
    let turning = order::turning_masses(engine).into_iter();
    let turning = turning.filter(|mass| is_own(mass.source.group()) && mass.crank.is_none_or(|own| own == crank));
    let shaft = turning.map(|mass| {
        numbers::direction(&mass.angle) * numbers::float(&(&mass.mass_radius * part(&mass.position))) * newtons * speed
    });
    Carried { shaft: shaft.sum(), turns, parts: parts.iter().map(numbers::float).collect() }
}

/// How many times a crankshaft turns while the reference turns once; below 0 against it.
pub(super) fn turns_of(engine: &Engine, crank: usize) -> f64 {
    engine.geared_cranks().get(crank).map_or(1.0, |crank| crank.sense.signed(f64::from(crank.speed)))
}
