//! How does one cylinder move, and which forces act in it at a crank angle? By the rooms that know, letter by letter.
//!
//! What moves, and the inertia of it, needs no gas; what the gas has a part in is read from the history of its forces.

use num_complex::Complex;

use super::formula::{Letter, Measured};
use crate::engine::Engine;
use crate::journal::{self, ForceHistory, PistonForces};
use crate::loads::Missing;
use crate::motion::SliderCrank;
use crate::numbers;
use crate::torque::{Class, Inertia};

/// The first cylinder of an engine. What the layout does not tell is known by why it does not.
pub(super) struct Parts {
    crank: SliderCrank,
    radius: f64,
    ratio: f64,
    offset: f64,
    /// ω in radians a second.
    omega: Option<f64>,
    /// Reciprocating and rotating mass in kilograms.
    masses: Option<[f64; 2]>,
    gas: Result<WithGas, Missing>,
}

/// What is known of it where the engine has gas.
struct WithGas {
    course: ForceHistory,
    /// Its place among the classes of the course.
    class: usize,
    fires: f64,
    /// The mass of its piston in multiples of the engine's.
    multiple: f64,
    axis: Complex<f64>,
    bore: f64,
}

/// The cylinder that formulas are said of: the first one of the layout.
const CYLINDER: usize = 0;

const NO_CRANK: &str = "a formula needs a slider crank of known size; give crank_radius and the rods, rod_ratio or rod_length, below [mechanism]";

impl Parts {
    /// The first cylinder of an engine.
    pub fn new(engine: &Engine) -> Result<Self, String> {
        let cylinder = &engine.cylinders()[CYLINDER];
        let dimensions = engine.dimensions();
        let (Some(rod), Some(radius)) = (cylinder.rod(), &dimensions.crank_radius) else {
            return Err(NO_CRANK.to_owned());
        };
        let crank = SliderCrank::new(rod.ratio.clone(), rod.offset.clone()).map_err(|_| NO_CRANK.to_owned())?;
        let [ratio, offset] = [&rod.ratio, &rod.offset].map(numbers::float);
        let masses = dimensions.mass.as_ref();
        let masses = masses.map(|unit| [unit * &cylinder.reciprocating_mass, cylinder.rotating_mass.clone()]);
        Ok(Parts {
            crank,
            radius: numbers::float(&(radius * &cylinder.crank_radius)),
            ratio,
            offset,
            omega: dimensions.speed.as_ref().map(|speed| numbers::angular_speed(numbers::float(speed))),
            masses: masses.map(|masses| masses.map(|mass| numbers::float(&mass))),
            gas: WithGas::new(engine),
        })
    }

    /// Length of the cycle in radians; a revolution where no gas tells another.
    pub fn period(&self) -> f64 {
        self.gas.as_ref().map_or(std::f64::consts::TAU, |gas| gas.course.period())
    }

    fn omega(&self) -> Result<f64, String> {
        self.omega.ok_or_else(|| Missing::MassesOrSpeed.to_string())
    }

    fn masses(&self) -> Result<[f64; 2], String> {
        self.masses.ok_or_else(|| Missing::MassesOrSpeed.to_string())
    }

    fn gas(&self) -> Result<&WithGas, String> {
        self.gas.as_ref().map_err(ToString::to_string)
    }

    /// `r ω²`.
    fn centrifugal(&self) -> Result<f64, String> {
        Ok(self.radius * self.omega()?.powi(2))
    }

    /// `sin β = λ sin θ − δ`.
    fn rod_sine(&self, psi: f64) -> f64 {
        self.ratio * psi.sin() - self.offset
    }

    fn rod(&self) -> f64 {
        self.radius / self.ratio
    }

    /// The way from the outermost place, where `sin ψ = δ/(1 + λ)`.
    fn displacement(&self, psi: f64) -> f64 {
        let outermost = (self.offset / (1.0 + self.ratio)).asin();
        self.radius * (self.crank.position(outermost) - self.crank.position(psi))
    }

    /// Towards the crank, in metres a second squared.
    fn acceleration(&self, psi: f64) -> Result<f64, String> {
        Ok(-self.centrifugal()? * self.crank.acceleration(psi))
    }

    /// A letter at the cylinder's own crank angle, by its definition.
    pub fn letter(&self, letter: Letter, psi: f64) -> Result<f64, String> {
        Ok(match letter {
            Letter::Theta => psi,
            Letter::Beta => self.rod_sine(psi).asin(),
            Letter::Lambda => self.ratio,
            Letter::Delta => self.offset,
            Letter::Radius => self.radius,
            Letter::Height => self.radius * psi.cos() + self.rod() * self.rod_sine(psi).asin().cos(),
            Letter::Omega => self.omega()?,
            Letter::Bore => self.gas()?.bore,
            Letter::Pressure => self.gas()?.known().gas.pressure(psi),
            Letter::Crankcase => self.gas()?.known().gas.crankcase(),
            Letter::Of(what) => self.measured(what, psi)?,
        })
    }

    /// What the program finds of the cylinder at its own crank angle.
    pub fn measured(&self, what: Measured, psi: f64) -> Result<f64, String> {
        let rotating = || Ok::<_, String>(self.masses()?[1] * self.centrifugal()?);
        Ok(match what {
            Measured::RodSine => self.rod_sine(psi),
            Measured::Displacement => self.displacement(psi),
            Measured::Velocity => -self.radius * self.omega()? * self.crank.velocity(psi),
            Measured::Acceleration => self.acceleration(psi)?,
            Measured::InertiaForce => -self.masses()?[0] * self.acceleration(psi)?,
            Measured::CentrifugalForce => rotating()?,
            Measured::ReciprocatingMass => self.masses()?[0],
            Measured::RotatingMass => self.masses()?[1],
            Measured::RodLength => self.rod(),
            Measured::GasForce => self.gas()?.forces(psi).gas,
            Measured::PistonEffort => self.gas()?.forces(psi).effort(),
            Measured::SideForce => self.gas()?.forces(psi).side(),
            Measured::RodForce => self.gas()?.forces(psi).rod(),
            Measured::RadialForce => rotating()? - self.gas()?.on_the_crank(psi).re,
            Measured::CrankEffort => self.gas()?.on_the_crank(psi).im,
            Measured::FrameAlong => self.gas()?.frame(psi).re,
            Measured::FrameAcross => self.gas()?.frame(psi).im,
            Measured::Torque => self.gas()?.torque(psi),
            Measured::ReactionTorque => {
                let gas = self.gas()?;
                gas.torque(psi) + gas.of_inertia(|inertia| inertia.sideways(psi))
            }
        })
    }
}

impl WithGas {
    fn new(engine: &Engine) -> Result<Self, Missing> {
        let course = journal::course(engine)?;
        let known = course.classes().iter().enumerate().find_map(|(class, of)| {
            let place = of.cylinders.iter().position(|cylinder| *cylinder == CYLINDER)?;
            Some((class, numbers::float(&of.fires[place]) * std::f64::consts::TAU))
        });
        let (Some((class, fires)), Some(cylinder)) = (known, engine.cylinders().first()) else {
            return Err(Missing::MassesOrSpeed);
        };
        let area = course.classes()[class].gas.geometry().area;
        let multiple = numbers::float(&cylinder.reciprocating_mass);
        let bore = (4.0 * area / std::f64::consts::PI).sqrt();
        Ok(WithGas { class, fires, multiple, axis: numbers::direction(&cylinder.bank), bore, course })
    }

    fn known(&self) -> &Class {
        &self.course.classes()[self.class]
    }

    /// What the inertia gives, in proportion to the mass; 0 where there is none.
    fn of_inertia(&self, value: impl Fn(&Inertia) -> f64) -> f64 {
        self.known().inertia.as_ref().map_or(0.0, |inertia| self.multiple * value(inertia))
    }

    /// Head, cylinder and bearings, in the frame of the axis: outward, and across in the sense of rotation.
    fn frame(&self, psi: f64) -> Complex<f64> {
        let forces = self.forces(psi);
        let pin = self.course.pin(CYLINDER, psi + self.fires) * self.axis.conj();
        Complex::new(forces.gas, -forces.side()) + pin
    }

    fn forces(&self, psi: f64) -> PistonForces {
        self.course.forces(CYLINDER, psi + self.fires)
    }

    fn on_the_crank(&self, psi: f64) -> Complex<f64> {
        self.course.pin_on_the_crank(CYLINDER, psi + self.fires)
    }

    fn torque(&self, psi: f64) -> f64 {
        self.known().gas.torque(psi) + self.of_inertia(|inertia| inertia.torque(psi))
    }
}
