//! What does each piston do at a crank angle, and what feels it? Place, velocity, acceleration, forces, torque, loads of pins and bearings.
//!
//! Directions are those of textbooks: ways, velocities, accelerations and forces are positive towards the crankshaft. What the layout does
//! not give is omitted: without a speed there is no velocity, without masses no inertia, without [gas] no gas.

use num_complex::Complex;

use super::{Carried, PistonForces};
use crate::engine::{Cylinder, Engine, Mechanism};
use crate::gas::{CylinderGas, NoGas};
use crate::loads::{self, Method, Missing};
use crate::motion::PistonMotion;
use crate::numbers;
use crate::order::{self, Source};
use crate::proof::Sense;
use crate::torque::{self, Bodies, Inertia};

/// An engine whose values are asked for at crank angles.
#[derive(Clone, Debug)]
pub struct Instants {
    cylinders: Vec<Moving>,
    bearings: Vec<Carried>,
    omega: Option<f64>,
    period: f64,
}

/// One cylinder in SI units.
#[derive(Clone, Debug)]
struct Moving {
    motion: PistonMotion,
    /// How far out the piston comes, in crank radii.
    outermost: f64,
    /// λ of a rod on an axis without an offset, for what textbooks put.
    ratio: Option<f64>,
    /// The mass at the knuckle pin of a link, where it is known.
    knuckle: Option<Inertia>,
    /// Whether links hang on its rod, which then is no strut between two pins.
    carries: bool,
    /// Whether it is a link.
    hangs: bool,
    radius: f64,
    mass: Option<f64>,
    gas: Option<CylinderGas>,
    /// The crank angle at which ψ is 0, in degrees: where it fires; its dead centre where there is no gas.
    zero: f64,
    /// The weight along the axis, towards the crankshaft.
    weight: Option<f64>,
    axis: Complex<f64>,
    throw: Complex<f64>,
    /// 1 where its crank turns with the first one, −1 where against it.
    sense: f64,
    /// What the rotating part of its rod pulls the pin outward with.
    rotating: f64,
}

/// What one piston does at a crank angle.
#[derive(Clone, Debug, PartialEq)]
pub struct PistonAt {
    /// The cylinder, by its index.
    pub cylinder: usize,
    /// ψ in degrees, from the dead centre at which it fires.
    pub psi: f64,
    /// How far the piston is from its outermost place, in metres.
    pub way: f64,
    /// Velocity in metres a second.
    pub velocity: Option<f64>,
    /// Acceleration in metres a square second.
    pub acceleration: Option<f64>,
    /// What textbooks put for both: `rω (sin ψ + λ/2 sin 2ψ)` and `rω² (cos ψ + λ cos 2ψ)`; none for an axis with an offset.
    pub textbook: Option<[f64; 2]>,
    /// Force of the gas on the piston, in newtons.
    pub gas: Option<f64>,
    /// Force of the inertia of the reciprocating mass.
    pub inertia: Option<f64>,
    /// Weight of the reciprocating mass, where it is asked for.
    pub weight: Option<f64>,
    /// tan β, the slope of the rod.
    pub slope: f64,
    /// Torque of the mass at the knuckle pin of a link, in newton-metres; none where there is none.
    pub knuckle: Option<f64>,
    /// Whether its rod is loaded at its two ends alone: no links hang on it.
    pub is_strut: bool,
    /// What the effort turns the crank with, in metres: `−ds/dψ`.
    pub lever: f64,
    /// Load of the crankpin by rod and piston, seen from the engine, in newtons; none where no force is known.
    pub pin: Option<Complex<f64>>,
    /// The same seen from the crank: the real part is outward along the throw, the imaginary part in the sense of rotation.
    pub pin_on_the_crank: Option<Complex<f64>>,
}

impl PistonAt {
    /// The forces that are known together; none where none is.
    fn forces(&self) -> Option<PistonForces> {
        let known = [self.gas, self.inertia, self.weight];
        known.iter().any(Option::is_some).then(|| PistonForces {
            gas: self.gas.unwrap_or_default() + self.weight.unwrap_or_default(),
            inertia: -self.inertia.unwrap_or_default(),
            slope: self.slope,
        })
    }

    /// The piston effort: gas, inertia and weight together.
    pub fn effort(&self) -> Option<f64> {
        self.forces().map(|forces| forces.effort())
    }

    /// The force along the rod, positive where it is pressed; none of a rod on which links hang.
    pub fn rod(&self) -> Option<f64> {
        self.forces().filter(|_| self.is_strut).map(|forces| forces.rod())
    }

    /// The side force of the wall on the piston; none where links hang on its rod.
    pub fn side(&self) -> Option<f64> {
        self.forces().filter(|_| self.is_strut).map(|forces| forces.side())
    }

    /// What it turns the crank with, in newton-metres, the mass at its knuckle pin with it.
    pub fn torque(&self) -> Option<f64> {
        self.effort().map(|effort| effort * self.lever + self.knuckle.unwrap_or_default())
    }
}

/// A value that is nothing but rounding, beside what it is measured by, is 0.
fn calm(value: f64, size: f64) -> f64 {
    if value.abs() <= 1e-13 * size { 0.0 } else { value }
}

/// Whether the link of a cylinder hangs on the rod of another.
fn hangs_on(cylinder: &Cylinder, master: &Cylinder) -> bool {
    let on_it = |link: &crate::engine::Link| {
        master.mechanism.as_ref() == Some(&Mechanism::SliderCrank(link.master_rod()))
            && (cylinder.pin, &cylinder.throw, &cylinder.position) == (master.pin, &master.throw, &master.position)
            && &master.bank + &link.angle == cylinder.bank
    };
    cylinder.link().is_some_and(on_it)
}

impl Instants {
    /// An engine whose crankshafts turn equally fast; with the weight of the reciprocating mass where a gravity is given, in metres a
    /// square second, direction 0 being up.
    ///
    /// # Errors
    /// What the layout lacks.
    pub fn new(engine: &Engine, gravity: Option<f64>) -> Result<Self, Missing> {
        if engine.faster_crank().is_some() {
            return Err(Missing::FasterCrank("values at an angle"));
        }
        let classes = if engine.gas().is_some() { torque::classes(engine)? } else { Vec::new() };
        let scale = loads::scale(engine);
        let newtons = scale.as_ref().map(loads::Scale::force);
        if newtons.is_some_and(|newtons| !newtons.is_finite() || newtons.abs() > 1e150) {
            return Err(Missing::TooLarge);
        }
        let dimensions = engine.dimensions();
        let radius = dimensions.crank_radius.as_ref().ok_or(NoGas::Radius)?;
        let turning = order::turning_masses(engine);
        let knuckles: Vec<Bodies> = torque::bodies(engine).into_iter().filter(|of| !of.is_of_pistons).collect();
        let mut cylinders = Vec::new();
        for (index, cylinder) in engine.cylinders().iter().enumerate() {
            let mechanism = cylinder.mechanism.as_ref().ok_or(Missing::Rods)?;
            let motion = mechanism.piston();
            let ratio = cylinder.rod().filter(|rod| rod.is_centric()).map(|rod| numbers::float(&rod.ratio));
            let class = classes.iter().find_map(|class| {
                let place = class.cylinders.iter().position(|&of| of == index)?;
                Some((class.gas.clone(), &class.fires[place]))
            });
            let zero =
                class.as_ref().map_or_else(|| cylinder.top_dead_centre().turns().clone(), |(_, at)| (*at).clone());
            let mass = dimensions.mass.as_ref().map(|mass| numbers::float(&(mass * &cylinder.reciprocating_mass)));
            let axis = numbers::direction(&cylinder.bank);
            let own = turning.iter().filter(|mass| mass.source == Source::BigEnd(index));
            cylinders.push(Moving {
                outermost: motion.position(motion.dead_centres()[0]),
                ratio,
                knuckle: knuckles.iter().find_map(|of| of.of_cylinder(index)),
                carries: engine.cylinders().iter().any(|other| hangs_on(other, cylinder)),
                hangs: cylinder.link().is_some(),
                radius: numbers::float(&(radius * &cylinder.crank_radius)),
                weight: gravity.and_then(|gravity| Some(mass? * gravity * axis.re)),
                mass,
                gas: class.map(|(gas, _)| gas),
                zero: numbers::float(&zero) * 360.0,
                throw: numbers::direction(&engine.pin_angle(cylinder)),
                sense: if engine.sense_of(cylinder) == Sense::Direct { 1.0 } else { -1.0 },
                rotating: own.map(|mass| numbers::float(&mass.mass_radius) * newtons.unwrap_or_default()).sum(),
                motion,
                axis,
            });
        }
        let is_plain = engine.geared_cranks().is_empty() && !engine.has_links();
        let bearings = match newtons.filter(|_| !engine.bearings().is_empty() && is_plain) {
            None => Vec::new(),
            Some(newtons) => {
                let all = super::carried(engine, Method::Continuous, newtons)?;
                all.into_iter().map(|(_, carried)| carried).collect()
            }
        };
        let period = classes.first().map_or(360.0, |class| class.gas.period().to_degrees().round());
        let omega = dimensions.speed.as_ref().map(|speed| numbers::angular_speed(numbers::float(speed)));
        Ok(Instants { cylinders, bearings, omega, period })
    }

    /// Length of the cycle in degrees.
    pub fn period(&self) -> f64 {
        self.period
    }

    /// What every piston does at a crank angle in degrees.
    pub fn pistons(&self, theta: f64) -> Vec<PistonAt> {
        (0..self.cylinders.len()).map(|index| self.piston(index, theta)).collect()
    }

    /// What every main bearing feels of these, as a continuous beam: none without bearings, masses or a speed.
    pub fn bearings(&self, theta: f64, pistons: &[PistonAt]) -> Vec<Complex<f64>> {
        let felt = |carried: &Carried| {
            let pins = carried.parts.iter().zip(pistons);
            let turned = Complex::cis(carried.turns * theta.to_radians());
            pins.fold(carried.shaft * turned, |sum, (part, piston)| sum + piston.pin.unwrap_or_default() * *part)
        };
        self.bearings.iter().map(felt).collect()
    }

    fn piston(&self, index: usize, theta: f64) -> PistonAt {
        let own = &self.cylinders[index];
        let degrees = (theta - own.zero).rem_euclid(self.period);
        let (psi, r) = (degrees.to_radians(), own.radius);
        let lever = calm(-own.motion.velocity(psi) * r, r);
        let towards = -own.motion.acceleration(psi);
        let acceleration = self.omega.map(|omega| calm(towards * r * omega * omega, r * omega * omega));
        let mut piston = PistonAt {
            cylinder: index,
            psi: degrees,
            way: calm((own.outermost - own.motion.position(psi)) * r, r),
            velocity: self.omega.map(|omega| lever * omega),
            acceleration,
            textbook: self.omega.zip(own.ratio).map(|(omega, ratio)| {
                let [v, a] = [psi.sin() + ratio / 2.0 * (2.0 * psi).sin(), psi.cos() + ratio * (2.0 * psi).cos()];
                [calm(r * omega * v, r * omega), calm(r * omega * omega * a, r * omega * omega)]
            }),
            gas: own.gas.as_ref().map(|gas| gas.force(psi)),
            inertia: own.mass.zip(acceleration).map(|(mass, acceleration)| -mass * acceleration),
            weight: own.weight,
            slope: calm(own.motion.slope(psi), 1.0),
            knuckle: own.knuckle.as_ref().map(|mass| mass.torque(psi)),
            is_strut: !own.carries,
            lever,
            pin: None,
            pin_on_the_crank: None,
        };
        // What links hand on to the crankpin is no single force along its master rod.
        if own.carries || own.hangs {
            return piston;
        }
        let turned = own.throw * Complex::cis(own.sense * theta.to_radians());
        let across = Complex::new(1.0, -own.sense * piston.slope);
        piston.pin = piston.effort().map(|effort| turned * own.rotating - own.axis * across * effort);
        piston.pin_on_the_crank = piston.pin.map(|pin| {
            let seen = pin * turned.conj();
            Complex::new(seen.re, own.sense * seen.im)
        });
        piston
    }
}
