//! What does each piston do at a crank angle, and what feels it? Place, velocity, acceleration, forces, torque, loads of pins and bearings.
//!
//! Directions are those of textbooks: ways, velocities, accelerations and forces are positive towards the crankshaft. What the layout does
//! not give is omitted: without a speed there is no velocity, without masses no inertia, without [gas] no gas.

use num_complex::Complex;

use super::{Carried, PistonForces};
use crate::engine::Engine;
use crate::gas::{CylinderGas, NoGas};
use crate::loads::{self, HungRod, Method, Missing};
use crate::motion::PistonMotion;
use crate::numbers;
use crate::order;
use crate::torque::{self, Bodies, Inertia};

/// An engine whose values are asked for at crank angles.
#[derive(Clone, Debug)]
pub struct Instants {
    cylinders: Vec<Moving>,
    /// The links on master rods.
    links: Vec<HungRod>,
    /// One m r ω² in newtons, where it is known.
    newtons: Option<f64>,
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

impl Moving {
    /// The direction of its crankpin at a crank angle in degrees.
    fn throw_at(&self, theta: f64) -> Complex<f64> {
        self.throw * Complex::cis(self.sense * theta.to_radians())
    }
}

/// What one piston does at a crank angle.
#[derive(Clone, Debug, PartialEq)]
pub struct PistonAt {
    /// The cylinder, by its index.
    pub cylinder: usize,
    /// ψ in degrees, 0 where its crank points along its axis; with gas, at the dead centre at which it fires.
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
    /// tan β, the slope of the rod, anticlockwise.
    pub slope: f64,
    /// Torque of the mass at the knuckle pin of a link, in newton-metres; none where there is none.
    pub knuckle: Option<f64>,
    /// The side force that links put on it which hang on its rod.
    pub side_of_links: f64,
    /// What the effort turns the crank with, in metres: `−ds/dψ`.
    pub lever: f64,
    /// Load of the pin that its big end is on, seen from the engine, in newtons; none where no force is known. That is the crankpin, by the rod
    /// with all links that hang on it; of a link the knuckle pin, with the mass there.
    pub pin: Option<Complex<f64>>,
    /// The same seen from the crank: the real part is outward along the throw, the imaginary part in the sense of rotation. Of a link seen from
    /// the master rod: away from the crankpin, and a quarter turn anticlockwise from there.
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

    /// The force along the rod, positive where it is pressed; of a rod on which links hang, in its small end.
    pub fn rod(&self) -> Option<f64> {
        // The part along the rod of effort and side force: the effort over cos β where no links put a side force on the piston.
        let across = self.side_of_links * self.slope / self.slope.hypot(1.0);
        self.forces().map(|forces| forces.rod() + across)
    }

    /// The side force of the wall on the piston, anticlockwise from the axis outward, with what links put on it.
    pub fn side(&self) -> Option<f64> {
        self.forces().map(|forces| forces.side() + self.side_of_links)
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
            cylinders.push(Moving {
                outermost: motion.position(motion.dead_centres()[0]),
                ratio,
                knuckle: knuckles.iter().find_map(|of| of.of_cylinder(index)),
                radius: numbers::float(&(radius * &cylinder.crank_radius)),
                weight: gravity.and_then(|gravity| Some(mass? * gravity * axis.re)),
                mass,
                gas: class.map(|(gas, _)| gas),
                zero: numbers::float(&zero) * 360.0,
                throw: numbers::direction(&engine.pin_angle(cylinder)),
                sense: engine.sense_of(cylinder).signed(1.0),
                rotating: numbers::float(&order::big_end(engine, cylinder)) * newtons.unwrap_or_default(),
                motion,
                axis,
            });
        }
        let bearings = match newtons.filter(|_| !engine.bearings().is_empty()) {
            None => Vec::new(),
            Some(newtons) => {
                let all = super::carried(engine, &classes, (Method::Continuous, newtons))?;
                all.into_iter().map(|(_, carried)| carried).collect()
            }
        };
        let period = classes.first().map_or(360.0, |class| class.gas.period().to_degrees().round());
        let omega = dimensions.speed.as_ref().map(|speed| numbers::angular_speed(numbers::float(speed)));
        Ok(Instants { cylinders, links: HungRod::all(engine), newtons, bearings, omega, period })
    }

    /// Length of the cycle in degrees.
    pub fn period(&self) -> f64 {
        self.period
    }

    /// What every piston does at a crank angle in degrees.
    pub fn pistons(&self, theta: f64) -> Vec<PistonAt> {
        let mut pistons: Vec<PistonAt> = (0..self.cylinders.len()).map(|index| self.piston(index, theta)).collect();
        for rod in &self.links {
            self.hang(rod, theta.to_radians(), &mut pistons);
        }
        for (piston, own) in pistons.iter_mut().zip(&self.cylinders) {
            let throw = own.throw_at(theta);
            let seen = |pin: Complex<f64>| Complex::new((pin * throw.conj()).re, own.sense * (pin * throw.conj()).im);
            piston.pin_on_the_crank = piston.pin_on_the_crank.or(piston.pin.map(seen));
        }
        pistons
    }

    /// What a link does to its knuckle pin, and to the piston and the crankpin of its master rod; θ is in radians.
    fn hang(&self, rod: &HungRod, theta: f64, pistons: &mut [PistonAt]) {
        let Some(effort) = pistons[rod.cylinder].effort() else { return };
        let knuckle = rod.on_the_knuckle(theta, -effort, self.newtons.unwrap_or_default());
        pistons[rod.cylinder].pin = Some(knuckle);
        pistons[rod.cylinder].pin_on_the_crank = Some(knuckle * rod.outward(theta).conj());
        pistons[rod.master].side_of_links += rod.side(theta, knuckle);
        if let Some(pin) = &mut pistons[rod.master].pin {
            *pin += rod.on_the_crankpin(theta, knuckle);
        }
    }

    /// What every main bearing feels of these, as a continuous beam: none without bearings, masses or a speed.
    pub fn bearings(&self, theta: f64, pistons: &[PistonAt]) -> Vec<Complex<f64>> {
        let felt = |carried: &Carried| {
            // The load of a crankpin is that of the rod on it, with its links.
            let is_link = |piston: &PistonAt| self.links.iter().any(|rod| rod.cylinder == piston.cylinder);
            let pins = carried.parts.iter().zip(pistons).filter(|(_, piston)| !is_link(piston));
            let shaft = carried.of_shaft(theta.to_radians());
            let all = pins.fold(shaft, |sum, (part, piston)| sum + piston.pin.unwrap_or_default() * *part);
            if carried.nothing == [true; 2] { Complex::default() } else { all }
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
            slope: calm(own.motion.slope(psi), 1.0) * own.sense,
            knuckle: own.knuckle.as_ref().map(|mass| mass.torque(psi)),
            side_of_links: 0.0,
            lever,
            pin: None,
            pin_on_the_crank: None,
        };
        let along = own.axis * Complex::new(1.0, -piston.slope);
        piston.pin = piston.effort().map(|effort| own.throw_at(theta) * own.rotating - along * effort);
        piston
    }
}
