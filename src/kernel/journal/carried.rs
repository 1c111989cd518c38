//! What of the engine's forces does one place of a shaft carry?

use num_complex::Complex;
use num_rational::BigRational;
use num_traits::Zero;

use crate::engine::Engine;
use crate::exact::{PhasorSum, Term, Turn, vanish_apart};
use crate::numbers;
use crate::order::{self, MassGroup};
use crate::torque::Class;

/// What of the engine's forces one place carries.
#[derive(Clone, Debug)]
pub struct Carried {
    /// The part of the load of each crankpin.
    pub parts: Vec<f64>,
    /// What the masses of the crankshaft itself pull there with at θ = 0, in newtons; it turns with the crank.
    pub shaft: Complex<f64>,
    /// How many times that turns while the reference turns once; below 0 against it.
    pub turns: f64,
    /// Whether the loads of the masses, and those of the gas, are proved to cancel there at every angle.
    pub nothing: [bool; 2],
}

impl Carried {
    /// What is left of masses and gas: no rounding of what cancels.
    pub(super) fn left(&self, loads: [Complex<f64>; 2]) -> [Complex<f64>; 2] {
        [0, 1].map(|of| if self.nothing[of] { Complex::default() } else { loads[of] })
    }

    /// What the masses of the crankshaft pull there with.
    pub(super) fn of_shaft(&self, theta: f64) -> Complex<f64> {
        self.shaft * Complex::cis(self.turns * theta)
    }
}

/// What a bearing carries: these parts of the pins, and those of the masses of the crankshaft itself.
pub(super) fn carried_by(
    (engine, classes): (&Engine, &[Class]),
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
    let shaft: Vec<Term> =
        turning.map(|mass| Term { angle: mass.angle, weight: &mass.mass_radius * part(&mass.position) }).collect();
    let nothing = nothing(engine, classes, parts, &shaft);
    let pulls =
        shaft.iter().map(|term| numbers::direction(&term.angle) * numbers::float(&term.weight) * newtons * speed);
    Carried { shaft: pulls.sum(), turns, parts: parts.iter().map(numbers::float).collect(), nothing }
}

/// Whether what is carried of the masses, and of the gas, is 0 at every angle: pistons of a class that are at one place of their motion at one
/// time have loads that differ by their masses and their axes alone, and what turns has one sum. Nothing is proved but of rods.
pub(super) fn nothing(engine: &Engine, classes: &[Class], parts: &[BigRational], shaft: &[Term]) -> [bool; 2] {
    // By class, turns of the crank, and when the cylinder fires: a law of the angle.
    let (mut gas, mut pistons, mut turning) = (Vec::new(), Vec::new(), shaft.to_vec());
    for (index, (cylinder, part)) in engine.cylinders().iter().zip(parts).enumerate().filter(|(_, of)| !of.1.is_zero())
    {
        let found = classes.iter().enumerate().find_map(|(number, class)| {
            let place = class.cylinders.iter().position(|one| *one == index)?;
            Some((number, class.gas.revolutions(), &class.fires[place]))
        });
        let (Some((class, revolutions, fires)), Some(_)) = (found, cylinder.rod()) else { return [false; 2] };
        let within = |turns: u32| {
            let turns = BigRational::from_integer(turns.into());
            fires - (fires / &turns).floor() * turns
        };
        let turns = turns_of(engine, cylinder.crank).to_bits();
        let term = |angle: &Turn, weight: BigRational| Term { angle: angle.clone(), weight };
        gas.push(((class, turns, within(revolutions)), term(&cylinder.bank, part.clone())));
        pistons.push(((class, turns, within(1)), term(&cylinder.bank, part * &cylinder.reciprocating_mass)));
        turning.push(term(&engine.pin_angle(cylinder), part * order::big_end(engine, cylinder)));
    }
    [vanish_apart(pistons) && PhasorSum::new(turning).vanishes(), vanish_apart(gas)]
}

/// How many times a crankshaft turns while the reference turns once; below 0 against it.
pub(super) fn turns_of(engine: &Engine, crank: usize) -> f64 {
    engine.geared_cranks().get(crank).map_or(1.0, |crank| crank.sense.signed(f64::from(crank.speed)))
}
