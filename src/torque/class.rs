//! Which cylinders are equal, but for when they fire and what their pistons weigh?

use num_rational::BigRational;
use num_traits::Zero;

use super::HIGHEST;
use crate::engine::{Engine, Mechanism};
use crate::gas::{CylinderGas, Harmonics, NoGas, Warning};
use crate::loads::Missing;
use crate::motion::SliderCrank;
use crate::numbers;
use crate::order;

/// Cylinders of one crank, rod, bore and pressure: their gas is the same, and their inertia in proportion to their masses.
#[derive(Clone, Debug)]
pub struct Class {
    /// The gas of each.
    pub gas: CylinderGas,
    /// Its harmonics.
    pub harmonics: Harmonics,
    /// The inertia of one whose mass is 1 in the engine's multiples; none where mass or speed is not known.
    pub inertia: Option<Inertia>,
    /// Which cylinders, by index.
    pub cylinders: Vec<usize>,
    /// The crank angle θ at which each fires, in turns of the cycle.
    pub fires: Vec<BigRational>,
    /// The mass of each piston in those multiples: [`crate::engine::Cylinder::reciprocating_mass`].
    pub masses: Vec<BigRational>,
    /// The first class with the same crank and rod, whatever its gas is.
    pub same_motion: usize,
}

/// The inertia of a cylinder, in proportion to the mass of its piston.
#[derive(Clone, Debug)]
pub struct Inertia {
    crank: SliderCrank,
    /// Crank radius r in metres.
    pub radius: f64,
    /// Offset e over crank radius r: 0 where the axis meets the crankshaft.
    pub lever: f64,
    /// `m r²` in kilograms times square metres.
    pub weight: f64,
    /// `m r² ω²` in newton-metres.
    pub scale: f64,
    /// `t_k`, k from 1, times `m r² ω²`.
    pub harmonics: Vec<num_complex::Complex<f64>>,
}

impl Inertia {
    /// The torque `−m s' s'' ω²` at an angle.
    pub fn torque(&self, psi: f64) -> f64 {
        self.scale * self.crank.torque(psi)
    }

    /// The force `F_in = −m s̈` along the axis, outward, in newtons.
    pub fn force(&self, psi: f64) -> f64 {
        -self.scale / self.radius * self.crank.acceleration(psi)
    }

    /// Moment `e F_in` of the shaking force at the offset of its axis.
    pub fn sideways(&self, psi: f64) -> f64 {
        self.lever * self.radius * self.force(psi)
    }

    /// `m s'²` in kilograms times square metres.
    pub fn reduced(&self, psi: f64) -> f64 {
        let velocity = self.crank.velocity(psi);
        self.weight * velocity * velocity
    }
}

/// ω in radians a second; none where the speed is not known.
pub(super) fn omega(engine: &Engine) -> Option<f64> {
    engine.dimensions().speed.as_ref().map(|speed| numbers::angular_speed(numbers::float(speed)))
}

/// The crank angle θ at which each cylinder fires, in turns of the cycle, from that of the first cylinder to fire.
fn fires(engine: &Engine) -> Result<Vec<BigRational>, Missing> {
    let cylinders = engine.cylinders();
    let top = |index: usize| cylinders[index].top_dead_centre().turns().clone();
    let Some(firing) = engine.firing() else {
        // A cylinder alone fires at its dead centre.
        return if cylinders.len() == 1 { Ok(vec![top(0)]) } else { Err(Missing::Firing) };
    };
    let first = firing.shots.first().map_or_else(|| top(0), |shot| top(shot.cylinder));
    let mut angles = vec![first.clone(); cylinders.len()];
    for shot in &firing.shots {
        angles[shot.cylinder] = &first + &shot.angle;
    }
    Ok(angles)
}

/// The classes of equal cylinders, in the order of their first ones.
///
/// # Errors
/// What the layout lacks.
pub fn classes(engine: &Engine) -> Result<Vec<Class>, Missing> {
    let Some(gas) = engine.gas() else { return Err(NoGas::Gas.into()) };
    let fires = fires(engine)?;
    let cylinders = engine.cylinders();
    let moves_alike = |one: usize, other: usize| {
        let (a, b) = (&cylinders[one], &cylinders[other]);
        a.mechanism == b.mechanism && a.crank_radius == b.crank_radius
    };
    let is_alike = |one: usize, other: usize| gas.chambers[one] == gas.chambers[other] && moves_alike(one, other);
    let mut classes: Vec<Class> = Vec::new();
    for (index, fires) in fires.into_iter().enumerate() {
        match classes.iter_mut().find(|class| is_alike(class.cylinders[0], index)) {
            Some(class) => {
                class.cylinders.push(index);
                class.fires.push(fires);
                class.masses.push(cylinders[index].reciprocating_mass.clone());
            }
            None => {
                let gas = CylinderGas::new(engine, index)?;
                let harmonics = gas.harmonics((HIGHEST * gas.revolutions()) as usize);
                let inertia = inertia(engine, index);
                let same_motion = classes.iter().position(|class| moves_alike(class.cylinders[0], index));
                classes.push(Class {
                    gas,
                    harmonics,
                    inertia,
                    cylinders: vec![index],
                    fires: vec![fires],
                    masses: vec![cylinders[index].reciprocating_mass.clone()],
                    same_motion: same_motion.unwrap_or(classes.len()),
                });
            }
        }
    }
    Ok(classes)
}

/// That of a cylinder, its mass 1 in the engine's multiples.
fn inertia(engine: &Engine, index: usize) -> Option<Inertia> {
    let cylinder = &engine.cylinders()[index];
    let mechanism: &Mechanism = cylinder.mechanism.as_ref()?;
    let mass = engine.dimensions().mass.as_ref()?;
    let radius = engine.dimensions().crank_radius.as_ref()? * &cylinder.crank_radius;
    let weight = numbers::float(&(mass * &radius * &radius));
    let radius = numbers::float(&radius);
    let scale = weight * omega(engine)?.powi(2);
    let crank = order::crank(mechanism)?;
    let harmonics = (1..=HIGHEST).map(|order| crank.torque_coefficient(order).to_complex() * scale).collect();
    let lever = match crank.offset().is_zero() {
        true => 0.0,
        // An endless rod has no offset in metres: its pistons roll nothing but by their torque.
        false if crank.ratio().is_zero() => 0.0,
        false => numbers::float(&(crank.offset() / crank.ratio())),
    };
    Some(Inertia { crank, radius, lever, weight, scale, harmonics })
}

/// What is odd about the pressures, by class.
pub fn warnings(engine: &Engine, classes: &[Class]) -> Vec<(usize, Warning)> {
    let (Some(gas), Some(cycle)) = (engine.gas(), engine.cycle()) else { return Vec::new() };
    let of_class = |(index, class): (usize, &Class)| {
        let law = &gas.laws[gas.chambers[class.cylinders[0]].law];
        class.gas.warnings(law, cycle).into_iter().map(move |warning| (index, warning)).collect::<Vec<_>>()
    };
    classes.iter().enumerate().flat_map(of_class).collect()
}
