//! Which moving masses are alike, and what does the inertia of one turn the crank with?
//!
//! A connecting rod is two masses, at its eyes: pistons move along their axes, the mass at a knuckle pin with the master rod, and what is at
//! the crankpin turns evenly. A mass m at the place s(ψ) has the energy `½ m |s'|² ω²`, so that at constant speed it turns the crank with
//! `T = −½ m (|s'|²)' ω²`, and its angular momentum about the shaft changes by the moment `m Im(s̄ s'') ω²`.

use num_complex::Complex;
use num_rational::BigRational;
use num_traits::Zero;

use crate::engine::{CycleOrder, Engine};
use crate::motion::{LinkMotion, PistonMotion, harmonic};
use crate::numbers;
use crate::proof::Quantity;

/// Orders of the torque are computed up to this one, unless a question asks for more.
pub const HIGHEST: u32 = 12;

/// Masses that move alike, each by the angle of its own cylinder.
#[derive(Clone, Debug)]
pub struct Bodies {
    /// Whether they are pistons; else masses at knuckle pins.
    pub is_of_pistons: bool,
    /// Whether they have the second order of the torque alone: pistons on infinitely long rods.
    pub has_second_alone: bool,
    /// The inertia of one whose mass is 1 in the engine's multiples; none where mass or speed is not known.
    pub inertia: Option<Inertia>,
    /// Whose they are, by index.
    pub cylinders: Vec<usize>,
    /// The crank angle θ at which ψ is 0, in turns: every whole order has the same phase a revolution later.
    pub tops: Vec<BigRational>,
    /// The masses in those multiples.
    pub weights: Vec<BigRational>,
}

/// The inertia of a moving mass, in proportion to it.
#[derive(Clone, Debug)]
pub struct Inertia {
    body: Body,
    /// Crank radius r in metres.
    pub radius: f64,
    /// Offset e over crank radius r: 0 where the axis meets the crankshaft.
    pub lever: f64,
    /// `m r²` in kilograms times square metres.
    pub weight: f64,
    /// `m r² ω²` in newton-metres.
    pub scale: f64,
    /// `t_k`, k from 1, in `m r² ω²`.
    harmonics: Vec<Complex<f64>>,
    /// The moment of its angular momentum about the shaft likewise: what the frame feels of it besides −t_k.
    spin: Vec<Complex<f64>>,
}

/// What moves.
#[derive(Clone, Debug)]
enum Body {
    /// A piston, along its axis.
    Piston(PistonMotion),
    /// The mass at the knuckle pin of a link.
    Knuckle(LinkMotion),
}

impl Bodies {
    /// The inertia of the mass of a cylinder, with that mass; none of another cylinder, or where it is not known.
    pub fn of_cylinder(&self, index: usize) -> Option<Inertia> {
        let place = self.cylinders.iter().position(|cylinder| *cylinder == index)?;
        let (inertia, mass) = (self.inertia.clone()?, numbers::float(&self.weights[place]));
        Some(Inertia { weight: inertia.weight * mass, scale: inertia.scale * mass, ..inertia })
    }
}

/// Points of a turn for the harmonics of a link, at first and at most: doubled until nothing changes.
const POINTS: [usize; 2] = [64, 1 << 14];
/// Harmonics below this part of m r² ω² are roundings.
const ROUNDING: f64 = 1e-14;

impl Body {
    /// `T/(m r² ω²)`.
    fn torque(&self, psi: f64) -> f64 {
        match self {
            Body::Piston(motion) => -motion.velocity(psi) * motion.acceleration(psi),
            Body::Knuckle(link) => -link.knuckle(psi).iter().map(|part| part.first * part.second).sum::<f64>(),
        }
    }

    /// `|s'|²/r²`.
    fn square(&self, psi: f64) -> f64 {
        match self {
            Body::Piston(motion) => motion.velocity(psi).powi(2),
            Body::Knuckle(link) => link.knuckle(psi).iter().map(|part| part.first * part.first).sum(),
        }
    }

    /// The moment `Im(s̄ s'')/r²` about the shaft, of an axis at this lever.
    fn spin(&self, psi: f64, lever: f64) -> f64 {
        match self {
            Body::Piston(motion) => -lever * motion.acceleration(psi),
            Body::Knuckle(link) => {
                let [along, across] = link.knuckle(psi);
                (along.value + link.constant()) * across.second - across.value * along.second
            }
        }
    }
}

impl Inertia {
    fn new(engine: &Engine, body: Body, cylinder: usize, highest: u32) -> Option<Self> {
        let dimensions = engine.dimensions();
        let own = &engine.cylinders()[cylinder];
        let radius = dimensions.crank_radius.as_ref()? * &own.crank_radius;
        let weight = numbers::float(&(dimensions.mass.as_ref()? * &radius * &radius));
        let scale = weight * omega(engine)?.powi(2);
        // An endless rod has no offset in metres: its pistons roll nothing but by their torque.
        let rod = own.rod().filter(|rod| !rod.ratio.is_zero());
        let lever = rod.map_or(0.0, |rod| numbers::float(&(&rod.offset / &rod.ratio)));
        let [harmonics, spin] = match &body {
            Body::Piston(PistonMotion::Crank(crank)) => [
                (1..=highest).map(|order| crank.torque_coefficient(order).to_complex()).collect(),
                (1..=highest).map(|order| crank.coefficient(order).to_complex() * lever).collect(),
            ],
            _ => [of_a_turn(highest, |psi| body.torque(psi)), of_a_turn(highest, |psi| body.spin(psi, lever))],
        };
        let radius = numbers::float(&radius);
        Some(Inertia { radius, lever, weight, scale, harmonics, spin, body })
    }

    /// The torque `−½ m (|s'|²)' ω²` at an angle.
    pub fn torque(&self, psi: f64) -> f64 {
        self.scale * self.body.torque(psi)
    }

    /// The force `F_in = −m s̈` of a piston along its axis, outward, in newtons; 0 of another mass.
    pub fn force(&self, psi: f64) -> f64 {
        match &self.body {
            Body::Piston(motion) => -self.scale / self.radius * motion.acceleration(psi),
            Body::Knuckle(_) => 0.0,
        }
    }

    /// The moment by which its angular momentum about the shaft changes: of a piston `e F_in`.
    pub fn sideways(&self, psi: f64) -> f64 {
        self.scale * self.body.spin(psi, self.lever)
    }

    /// `m |s'|²` in kilograms times square metres.
    pub fn reduced(&self, psi: f64) -> f64 {
        self.weight * self.body.square(psi)
    }

    /// An order of the torque, and of the moment of the angular momentum, in newton-metres.
    pub fn at(&self, order: CycleOrder) -> [Complex<f64>; 2] {
        self.of_unit(order).map(|one| one * self.scale)
    }

    /// Both over ω², in kilograms times square metres.
    pub fn over_square(&self, order: CycleOrder) -> [Complex<f64>; 2] {
        self.of_unit(order).map(|one| one * self.weight)
    }

    /// Zero at halves, and above the orders that are computed.
    fn of_unit(&self, order: CycleOrder) -> [Complex<f64>; 2] {
        let whole = if order.is_whole() { order.halves() as usize / 2 } else { 0 };
        let of =
            |all: &[Complex<f64>]| whole.checked_sub(1).and_then(|index| all.get(index)).copied().unwrap_or_default();
        [of(&self.harmonics), of(&self.spin)]
    }
}

/// ω in radians a second; none where the speed is not known.
pub(super) fn omega(engine: &Engine) -> Option<f64> {
    engine.dimensions().speed.as_ref().map(|speed| numbers::angular_speed(numbers::float(speed)))
}

/// The first harmonics of a smooth function of a turn: sums over this many points that twice as many change nothing.
fn of_a_turn(highest: u32, value: impl Fn(f64) -> f64) -> Vec<Complex<f64>> {
    let over = |points: usize| -> Vec<Complex<f64>> {
        let step = std::f64::consts::TAU / points as f64;
        let values: Vec<Complex<f64>> = (0..points).map(|point| value(point as f64 * step).into()).collect();
        (1..=highest as usize).map(|order| harmonic(&values, order) * 2.0).collect()
    };
    let [mut points, most] = POINTS;
    let mut found = over(points);
    while points < most {
        points *= 2;
        let finer = over(points);
        let change = found.iter().zip(&finer).map(|(a, b)| (a - b).norm()).fold(0.0, f64::max);
        found = finer;
        if change <= ROUNDING {
            break;
        }
    }
    found.into_iter().map(|one| if one.norm() <= ROUNDING { Complex::zero() } else { one }).collect()
}

/// The moving masses of an engine by what moves them; none of cylinders whose mechanism is not known.
pub fn bodies(engine: &Engine) -> Vec<Bodies> {
    up_to(engine, HIGHEST)
}

/// Those with harmonics up to this order.
pub fn up_to(engine: &Engine, highest: u32) -> Vec<Bodies> {
    let cylinders = engine.cylinders();
    let moves = |index: usize| (&cylinders[index].mechanism, &cylinders[index].crank_radius);
    let mut all: Vec<Bodies> = Vec::new();
    for (index, cylinder) in cylinders.iter().enumerate() {
        let Some(mechanism) = &cylinder.mechanism else { continue };
        let piston = Some((true, &cylinder.reciprocating_mass, Body::Piston(mechanism.piston())));
        let knuckle = cylinder.link().filter(|_| !cylinder.knuckle_mass.is_zero());
        let knuckle = knuckle.map(|link| (false, &cylinder.knuckle_mass, Body::Knuckle(link.motion())));
        for (is_of_pistons, weight, body) in piston.into_iter().chain(knuckle) {
            let is_alike = |of: &Bodies| of.is_of_pistons == is_of_pistons && moves(of.cylinders[0]) == moves(index);
            let place = match all.iter().position(is_alike) {
                Some(place) => place,
                None => {
                    let inertia = Inertia::new(engine, body, index, highest);
                    let has_second_alone = is_of_pistons && !mechanism.has_order(Quantity::TORQUE, 1);
                    let (cylinders, tops, weights) = Default::default();
                    all.push(Bodies { is_of_pistons, has_second_alone, inertia, cylinders, tops, weights });
                    all.len() - 1
                }
            };
            all[place].cylinders.push(index);
            all[place].tops.push(cylinder.top_dead_centre().turns().clone());
            all[place].weights.push(weight.clone());
        }
    }
    all
}
