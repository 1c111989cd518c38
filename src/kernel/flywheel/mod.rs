//! How far does a torque that is drawn swing the speed, and which flywheel holds it?
//!
//! Between two angles at which the torque crosses the load it gives an area of work. `ΔE` is the largest less the smallest running sum of these areas,
//! `C_s = ΔE/(I ω²)` (theory, section 12). Of straight lines and rational areas all of it is a rational number times a power of π.

mod drawn;
mod lobes;
mod waves;
mod with_pi;

use std::f64::consts::{FRAC_1_PI, TAU};

use num_rational::BigRational;

use crate::file::{Diagram, Harmonic, Line, Torque};
use crate::numbers;
use drawn::Drawn;
pub use drawn::{Lobe, NoFluctuation};
pub use with_pi::WithPi;

/// Values at an angle.
#[derive(Clone, Debug)]
pub struct AtAngle {
    /// The crank angle in turns.
    pub angle: BigRational,
    /// The torque in N m.
    pub torque: f64,
    /// The load in N m.
    pub load: f64,
    /// The angular acceleration in rad/s², where there is an inertia.
    pub acceleration: Option<f64>,
}

/// What a diagram tells of energy and speed.
#[derive(Clone, Debug)]
pub struct Fluctuation {
    /// Mean torque in N m; none of areas, which do not tell it.
    pub mean: Option<WithPi>,
    /// Length of the cycle in turns.
    pub cycle: Option<BigRational>,
    /// Work of a cycle in joules.
    pub work: Option<WithPi>,
    /// ΔE in joules.
    pub energy: WithPi,
    /// ΔE over the work of a cycle; none where that is 0.
    pub energy_coefficient: Option<WithPi>,
    /// Crank angles in degrees where the speed is largest and smallest; none of areas.
    pub fastest_and_slowest: Option<[f64; 2]>,
    /// Areas between the crossings, with the running sums.
    pub lobes: Vec<Lobe>,
    /// `C_s` with the inertia of the file, at its speed.
    pub irregularity: Option<WithPi>,
    /// The inertia that the wanted `C_s` needs at the speed.
    pub inertia: Option<WithPi>,
    /// Its mass at the radius of gyration.
    pub mass: Option<WithPi>,
    /// Power in watts.
    pub power: Option<WithPi>,
    /// Values at the angles that are asked for.
    pub angles: Vec<AtAngle>,
}

/// What a diagram tells.
///
/// # Errors
/// A load that does not fit the torque; angles of areas.
pub fn fluctuation(diagram: &Diagram) -> Result<Fluctuation, NoFluctuation> {
    let Drawn { mean, cycle, energy, fastest_and_slowest, lobes } = match &diagram.torque {
        Torque::Harmonics(mean, torque) => waves::drawn(mean, torque, waves::load(diagram)),
        Torque::Lines(_) | Torque::Areas(_) => lobes::drawn(diagram)?,
    };
    let two = BigRational::from_integer(2.into());
    let work = mean.as_ref().zip(cycle.as_ref()).map(|(mean, cycle)| mean.times(&(cycle * &two), 1));
    // ω = π n/30.
    let squared = diagram.speed.as_ref().map(|speed| {
        let part = speed / BigRational::from_integer(30.into());
        WithPi::rational(&part * &part, 2)
    });
    let per_speed = squared.map(|squared| energy.over(&squared));
    let known = |value: &BigRational| WithPi::rational(value.clone(), 0);
    let irregularity =
        per_speed.as_ref().zip(diagram.inertia.as_ref()).map(|(part, inertia)| part.over(&known(inertia)));
    let needed = per_speed.as_ref().zip(diagram.irregularity.as_ref()).map(|(part, wanted)| part.over(&known(wanted)));
    let mass = needed.as_ref().zip(diagram.radius_of_gyration.as_ref());
    let mass = mass.map(|(inertia, radius)| inertia.over(&known(&(radius * radius))));
    let power = mean.as_ref().zip(diagram.speed.as_ref());
    let power = power.map(|(mean, speed)| mean.times(&(speed / BigRational::from_integer(30.into())), 1));
    // The given inertia turns the excess into an acceleration; without one that which is needed.
    let inertia = diagram.inertia.as_ref().map(numbers::float).or(needed.as_ref().map(|one| one.decimal));
    let inertia = inertia.filter(|inertia| *inertia > 0.0);
    let course = if diagram.angles.is_empty() { None } else { Some(TorqueCurve::new(diagram)?) };
    let at = |(angle, course): (&BigRational, &TorqueCurve<'_>)| {
        let [torque, load] = course.at(angle);
        let acceleration = inertia.map(|inertia| (torque - load) / inertia);
        AtAngle { angle: angle.clone(), torque, load, acceleration }
    };
    let angles = diagram.angles.iter().zip(course.iter().cycle()).map(at).collect();
    Ok(Fluctuation {
        energy_coefficient: work.as_ref().filter(|work| work.decimal != 0.0).map(|work| energy.over(work)),
        angles,
        mean,
        cycle,
        work,
        energy,
        fastest_and_slowest,
        lobes,
        irregularity,
        inertia: needed,
        mass,
        power,
    })
}

/// Torque and load through the cycle.
#[derive(Clone, Debug)]
pub enum TorqueCurve<'a> {
    /// Straight lines of all cylinders, the load, and what both are multiplied by.
    Lines(Vec<Line>, Vec<Line>, f64),
    /// A mean, and harmonics of torque and load.
    Waves(f64, [&'a [Harmonic]; 2]),
}

impl<'a> TorqueCurve<'a> {
    /// That of a diagram.
    ///
    /// # Errors
    /// Areas, which have none.
    pub fn new(diagram: &'a Diagram) -> Result<Self, NoFluctuation> {
        match &diagram.torque {
            Torque::Harmonics(mean, torque) => {
                Ok(TorqueCurve::Waves(numbers::float(mean), [torque, waves::load(diagram)]))
            }
            Torque::Areas(_) => Err(NoFluctuation::NoAngles),
            Torque::Lines(_) => {
                let torque = lobes::all_cylinders(diagram)?;
                let load = match &diagram.load {
                    Some(Torque::Lines(load)) => load.clone(),
                    Some(Torque::Harmonics(..) | Torque::Areas(_)) | None => vec![lobes::mean_line(&torque)],
                };
                Ok(TorqueCurve::Lines(torque, load, if diagram.over_pi { FRAC_1_PI } else { 1.0 }))
            }
        }
    }

    /// Torque and load in N m at an angle in turns; at a step the values behind it.
    pub fn at(&self, angle: &BigRational) -> [f64; 2] {
        match self {
            TorqueCurve::Lines(torque, load, by) => {
                [torque, load].map(|lines| numbers::float(&lobes::at_any(lines, angle)) * by)
            }
            TorqueCurve::Waves(mean, both) => {
                let theta = numbers::float(angle) * TAU;
                both.map(|waves| mean + waves::at(waves, theta))
            }
        }
    }
}
