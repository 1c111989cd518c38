//! What is asked at crank angles? Motion, forces and torque of every piston, the loads of pins and main bearings.

mod data;
mod page;
mod tables;

use num_complex::Complex;

use super::question::question;
use crate::engine::Engine;
use crate::journal::{Instants, PistonAt};
use crate::loads::Missing;

/// So many rows are computed at most: an angle of a cylinder is one.
const MOST_ROWS: f64 = 100_000.0;
/// Farther angles than this are not what anybody means.
const FARTHEST: f64 = 1e6;
/// Steps in degrees where nothing else is asked for.
const USUAL_STEP: f64 = 10.0;

/// Which angles, and with which weight.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct AnglesAsked {
    /// Crank angles in degrees.
    pub at: Vec<f64>,
    /// Step in degrees from 0 to the end of the cycle; where neither this nor an angle is asked for, 10.
    pub every: Option<f64>,
    /// Gravity in metres a square second, towards the direction 180°; none leaves the weight out.
    pub gravity: Option<f64>,
}

/// Why there are no values at angles.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum NoAngles {
    /// An angle that is none.
    #[error("{0} is no crank angle; write degrees between -1000000 and 1000000, such as 30")]
    Angle(f64),
    /// A step that leads nowhere, or to too many rows.
    #[error(
        "{0} is no step between crank angles; write degrees above 0, such as 10, so that angles and cylinders make at most {MOST_ROWS} rows"
    )]
    Step(f64),
    /// A gravity that is none.
    #[error("{0} is no gravity; write metres a square second from 0 to 1000, such as 9.81")]
    Gravity(f64),
    /// A gravity, and nothing that weighs.
    #[error(
        "a weight needs masses: below [mechanism], add reciprocating_mass = \"450 g\" or piston_mass; or omit the gravity"
    )]
    NoMass,
    /// What the layout lacks.
    #[error("{0}")]
    Missing(Missing),
}

/// The values of an engine at one crank angle.
#[derive(Clone, Debug)]
pub struct Instant {
    /// The crank angle θ in degrees.
    pub theta: f64,
    /// What each piston does.
    pub pistons: Vec<PistonAt>,
    /// What each main bearing feels, as a continuous beam; none where that is not known.
    pub bearings: Vec<Complex<f64>>,
}

impl Instant {
    /// A sum over the cylinders; none where one lacks it.
    pub fn sum(&self, of: impl Fn(&PistonAt) -> Option<f64>) -> Option<f64> {
        self.pistons.iter().map(of).collect::<Option<Vec<f64>>>().map(sum)
    }

    /// The torque of the inertia of all pistons, and of the masses at knuckle pins.
    pub fn torque_of_inertia(&self) -> Option<f64> {
        let of_piston = |piston: &PistonAt| Some(piston.inertia? * piston.lever);
        let pistons: Vec<f64> = self.pistons.iter().map(of_piston).collect::<Option<_>>()?;
        Some(sum(pistons.into_iter().chain(self.pistons.iter().filter_map(|piston| piston.knuckle)).collect()))
    }

    /// The torque of one kind of force, of all cylinders.
    pub fn torque_of(&self, force: impl Fn(&PistonAt) -> Option<f64>) -> Option<f64> {
        self.sum(|piston| Some(force(piston)? * piston.lever))
    }
}

/// Each part is rounded so many times at most.
const ROUNDINGS: f64 = 4.0;

/// The sum of parts; 0 where it is no more than their roundings leave of parts that cancel.
fn sum(parts: Vec<f64>) -> f64 {
    let sizes: f64 = parts.iter().map(|part| part.abs()).sum();
    let sum: f64 = parts.iter().sum();
    if sum.abs() <= ROUNDINGS * f64::EPSILON * sizes { 0.0 } else { sum }
}

/// The values of an engine at crank angles.
#[derive(Clone, Debug)]
pub struct AngleStudy {
    /// The engine.
    pub engine: Engine,
    /// The angles, as they were asked for.
    pub instants: Vec<Instant>,
    /// What makes more of them.
    pub law: Instants,
}

impl AngleStudy {
    /// Each piston at each angle.
    pub fn pistons(&self) -> impl Iterator<Item = (f64, &PistonAt)> {
        self.instants.iter().flat_map(|instant| instant.pistons.iter().map(move |piston| (instant.theta, piston)))
    }

    /// The force on each main bearing, by its number from 1, at each angle.
    pub fn bearings(&self) -> impl Iterator<Item = (f64, usize, Complex<f64>)> {
        self.instants
            .iter()
            .flat_map(|instant| (1..).zip(&instant.bearings).map(|(number, force)| (instant.theta, number, *force)))
    }

    /// The crankshaft of a main bearing, from 0, by its number.
    fn crank_of(&self, bearing: usize) -> usize {
        (bearing - 1) / self.engine.bearings().len().max(1)
    }

    /// What a main bearing is called: its number, beside the name of its crankshaft where there are several.
    fn bearing_name(&self, bearing: usize) -> String {
        let place = (bearing - 1) % self.engine.bearings().len().max(1) + 1;
        match self.engine.geared_cranks().get(self.crank_of(bearing)) {
            Some(shaft) => format!("{} {place}", shaft.name),
            None => place.to_string(),
        }
    }

    /// The values at these angles.
    ///
    /// # Errors
    /// See [`NoAngles`].
    pub fn new(engine: &Engine, asked: &AnglesAsked) -> Result<Self, NoAngles> {
        if let Some(&wrong) = asked.at.iter().find(|angle| !(-FARTHEST..=FARTHEST).contains(*angle)) {
            return Err(NoAngles::Angle(wrong));
        }
        if let Some(wrong) = asked.gravity.filter(|gravity| !(0.0..=1000.0).contains(gravity)) {
            return Err(NoAngles::Gravity(wrong));
        }
        if asked.gravity.is_some() && engine.dimensions().mass.is_none() {
            return Err(NoAngles::NoMass);
        }
        let law = Instants::new(engine, asked.gravity).map_err(NoAngles::Missing)?;
        let step = asked.every.or_else(|| asked.at.is_empty().then_some(USUAL_STEP));
        let mut angles = asked.at.clone();
        if let Some(step) = step {
            let count = (law.period() / step).ceil();
            if !(step > 0.0 && count * engine.cylinders().len() as f64 <= MOST_ROWS) {
                return Err(NoAngles::Step(step));
            }
            angles.extend((0..count as u32).map(|place| f64::from(place) * step));
        }
        if (angles.len() * engine.cylinders().len()) as f64 > MOST_ROWS {
            return Err(NoAngles::Step(step.unwrap_or_default()));
        }
        let at = |theta: f64| {
            let pistons = law.pistons(theta);
            Instant { theta, bearings: law.bearings(theta, &pistons), pistons }
        };
        Ok(AngleStudy { engine: engine.clone(), instants: angles.into_iter().map(at).collect(), law })
    }
}

question!(AngleStudy, "angle", |study| Some(study.engine.title()));
