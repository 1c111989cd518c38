//! How does one cylinder move, and which forces act in it at a crank angle? By the rooms that know, letter by letter.

use num_complex::Complex;

use super::formula::{Letter, Measured};
use crate::engine::{Engine, Mechanism};
use crate::journal::{self, Course, NoCycleLoads};
use crate::numbers;
use crate::torque::{Class, Inertia};

/// The first cylinder of an engine, with its course.
pub(super) struct Parts {
    course: Course,
    /// Its place among the classes of the course.
    class: usize,
    fires: f64,
    /// The mass of its piston in multiples of the engine's.
    multiple: f64,
    axis: Complex<f64>,
    omega: f64,
    ratio: f64,
    offset: f64,
    bore: f64,
}

/// The cylinder that formulas are said of: the first one of the layout.
const CYLINDER: usize = 0;

impl Parts {
    /// The first cylinder of an engine.
    pub fn new(engine: &Engine) -> Result<Self, NoCycleLoads> {
        let course = journal::course(engine)?;
        let known = course.classes().iter().enumerate().find_map(|(class, of)| {
            let place = of.cylinders.iter().position(|cylinder| *cylinder == CYLINDER)?;
            Some((class, numbers::float(&of.fires[place]) * std::f64::consts::TAU))
        });
        let (Some((class, fires)), Some(cylinder)) = (known, engine.cylinders().first()) else {
            return Err(NoCycleLoads::Masses);
        };
        let (Some(Mechanism::SliderCrank(rod)), Some(speed)) = (&cylinder.mechanism, &engine.dimensions().speed) else {
            return Err(NoCycleLoads::Masses);
        };
        let area = course.classes()[class].gas.geometry().area;
        Ok(Parts {
            class,
            fires,
            multiple: numbers::float(&cylinder.reciprocating_mass),
            axis: numbers::direction(&cylinder.bank),
            omega: numbers::float(speed) / 60.0 * std::f64::consts::TAU,
            ratio: numbers::float(&rod.ratio),
            offset: numbers::float(&rod.offset),
            bore: (4.0 * area / std::f64::consts::PI).sqrt(),
            course,
        })
    }

    /// Length of the cycle in radians.
    pub fn period(&self) -> f64 {
        self.course.period()
    }

    fn known(&self) -> &Class {
        &self.course.classes()[self.class]
    }

    /// What the inertia gives, in proportion to the mass; 0 where there is none.
    fn of_inertia(&self, value: impl Fn(&Inertia) -> f64) -> f64 {
        self.known().inertia.as_ref().map_or(0.0, |inertia| self.multiple * value(inertia))
    }

    fn mass(&self) -> f64 {
        self.of_inertia(|inertia| inertia.weight / (inertia.radius * inertia.radius))
    }

    fn radius(&self) -> f64 {
        self.known().gas.geometry().radius
    }

    fn rotating_mass(&self) -> f64 {
        self.course.rotating(CYLINDER) / (self.radius() * self.omega * self.omega)
    }

    /// Head, cylinder and bearings, in the frame of the axis: outward, and across in the sense of rotation.
    fn frame(&self, psi: f64) -> Complex<f64> {
        let forces = self.course.forces(CYLINDER, psi + self.fires);
        let pin = self.course.pin(CYLINDER, psi + self.fires) * self.axis.conj();
        Complex::new(forces.gas, -forces.side()) + pin
    }

    /// A letter at the cylinder's own crank angle, by its definition.
    pub fn letter(&self, letter: Letter, psi: f64) -> f64 {
        let sine = self.ratio * psi.sin() - self.offset;
        let rod = self.radius() / self.ratio;
        match letter {
            Letter::Theta => psi,
            Letter::Beta => sine.asin(),
            Letter::Lambda => self.ratio,
            Letter::Delta => self.offset,
            Letter::Radius => self.radius(),
            Letter::Rod => rod,
            Letter::Height => self.radius() * psi.cos() + rod * sine.asin().cos(),
            Letter::Omega => self.omega,
            Letter::Bore => self.bore,
            Letter::Pressure => self.known().gas.pressure(psi),
            Letter::Crankcase => self.known().gas.crankcase(),
            Letter::Reciprocating => self.mass(),
            Letter::Rotating => self.rotating_mass(),
            Letter::Gas => self.measured(Measured::GasForce, psi),
            Letter::Alternating => self.measured(Measured::InertiaForce, psi),
            Letter::Effort => self.measured(Measured::PistonEffort, psi),
            Letter::AlongTheRod => self.measured(Measured::RodForce, psi),
            Letter::Thrust => self.measured(Measured::SideForce, psi),
            Letter::AcrossTheCrank => self.measured(Measured::CrankEffort, psi),
            Letter::Centrifugal => self.measured(Measured::CentrifugalForce, psi),
            Letter::Torque => self.measured(Measured::Torque, psi),
        }
    }

    /// What the program finds of the cylinder at its own crank angle.
    pub fn measured(&self, what: Measured, psi: f64) -> f64 {
        let theta = psi + self.fires;
        let class = self.known();
        let geometry = class.gas.geometry();
        let forces = self.course.forces(CYLINDER, theta);
        let on_the_crank = || self.course.pin_on_the_crank(CYLINDER, theta);
        let torque = || class.gas.torque(psi) + self.of_inertia(|inertia| inertia.torque(psi));
        match what {
            Measured::RodSine => forces.slope / forces.slope.hypot(1.0),
            Measured::Displacement => (geometry.volume(psi) - geometry.clearance) / geometry.area,
            Measured::Velocity => self.omega * geometry.volume_slope(psi) / geometry.area,
            Measured::Acceleration => forces.inertia / self.mass(),
            Measured::GasForce => forces.gas,
            Measured::InertiaForce => -forces.inertia,
            Measured::CentrifugalForce => self.course.rotating(CYLINDER),
            Measured::PistonEffort => forces.effort(),
            Measured::SideForce => forces.side(),
            Measured::RodForce => forces.rod(),
            Measured::RadialForce => self.course.rotating(CYLINDER) - on_the_crank().re,
            Measured::CrankEffort => on_the_crank().im,
            Measured::FrameAlong => self.frame(psi).re,
            Measured::FrameAcross => self.frame(psi).im,
            Measured::Torque => torque(),
            Measured::ReactionTorque => torque() + self.of_inertia(|inertia| inertia.sideways(psi)),
            Measured::ReciprocatingMass => self.mass(),
            Measured::RotatingMass => self.rotating_mass(),
            Measured::RodLength => self.radius() / self.ratio,
        }
    }
}
