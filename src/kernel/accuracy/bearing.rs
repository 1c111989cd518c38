//! What is the largest load of a main bearing by the first orders of inertia, or at this many angles, and how far off is that?
//!
//! The closed form is the load of each crankpin, `F_in (1 − i tan β) e^{iα}`, shared among the bearings by the exact parts of the beam.

use std::f64::consts::TAU;
use std::time::Duration;

use num_complex::Complex;
use num_rational::BigRational;

use super::method::all_turn_with_the_crank;
use super::sample::{Piston, pistons};
use super::timing::{Timing, measured};
use crate::engine::{CycleOrder, Engine};
use crate::loads::{self, BearingLoads, Missing, PeakMethod};
use crate::motion::golden_section;
use crate::numbers;
use crate::order::turning_masses;

/// What a method finds of a largest value.
#[derive(Clone, Debug)]
pub struct PeakRow {
    /// Which method.
    pub method: PeakMethod,
    /// The largest value: a bearing load of inertia in multiples of m r ω², what there is of gas in newtons or newton-metres.
    pub value: f64,
    /// It is off by this part of the reference, [`PeakMethod::Refined`].
    pub error: f64,
    /// The largest distance from the reference anywhere in the cycle, as a part of that; none where it is not looked for.
    pub farthest: Option<f64>,
    /// Guaranteed, as a part of that: no value by these orders is further off, roundings apart. None without a guarantee.
    pub bound: Option<f64>,
    /// Median time of one evaluation, all numbers of the engine at hand; none where it was not asked for.
    pub time: Option<Duration>,
}

/// Orders that are kept: one more each up to 4, then some higher ones.
const ORDERS: [u32; 8] = [1, 2, 3, 4, 6, 8, 12, 24];
/// Steps of a revolution.
const STEPS: [u32; 3] = [36, 360, 3600];
/// Golden sections of the step beside the largest of the finest angles.
const SECTIONS: u32 = 60;

/// The largest load of all main bearings of a continuous beam, by all methods; none where the engine has no main bearings, several
/// crankshafts, or nothing moves.
///
/// # Errors
/// What the engine lacks for numbers.
pub fn bearings(engine: &Engine, timing: Timing) -> Result<Option<Vec<PeakRow>>, Missing> {
    if engine.bearings().is_empty() || engine.mechanisms().is_empty() || !engine.geared_cranks().is_empty() {
        return Ok(None);
    }
    all_turn_with_the_crank(engine)?;
    let by_orders =
        |highest: u32| loads::bearing_loads(engine, &(1..=highest).collect::<Vec<u32>>(), loads::Method::Continuous);
    let closed = Closed::new(engine, &by_orders(1)?);
    let (peak, time) = measured(timing, || closed.peak());
    if peak <= 0.0 {
        return Ok(None);
    }
    let row = |method, (value, time): (f64, Option<Duration>), bound: Option<f64>| {
        let error = (value - peak).abs() / peak;
        PeakRow { method, value, error, farthest: None, bound: bound.map(|bound| bound / peak), time }
    };
    let mut rows = Vec::new();
    for highest in ORDERS {
        let loads = by_orders(highest)?;
        let bound = loads::left_out_of_bearings(engine, &loads)?.map_or(0.0, |bound| bound.most);
        let largest = || loads.bearings.iter().map(|bearing| bearing.waveform.peak().value).fold(0.0, f64::max);
        let order = CycleOrder::of_halves(2 * highest).map(PeakMethod::Orders);
        rows.extend(order.map(|method| row(method, measured(timing, largest), Some(bound))));
    }
    for steps in STEPS {
        rows.push(row(PeakMethod::Samples(steps), measured(timing, || closed.largest(steps).0), None));
    }
    rows.push(row(PeakMethod::Refined, (peak, time), None));
    Ok(Some(rows))
}

/// The loads of the bearings without any series.
struct Closed {
    /// With its part in the load of each bearing, along the cylinder.
    pistons: Vec<Piston<Vec<Complex<f64>>>>,
    /// By bearing: what turns with the crank, at crank angle 0.
    rotating: Vec<Complex<f64>>,
}

impl Closed {
    fn new(engine: &Engine, loads: &BearingLoads) -> Self {
        let shared = |position: &BigRational, load: Complex<f64>| -> Vec<Complex<f64>> {
            let parts = loads.parts.get(position);
            (0..loads.bearings.len())
                .map(|index| load * parts.map_or(0.0, |parts| numbers::float(&parts[index])))
                .collect()
        };
        let pistons =
            pistons(engine, |cylinder, weight| shared(&cylinder.position, numbers::direction(&cylinder.bank) * weight));
        let mut rotating = vec![Complex::new(0.0, 0.0); loads.bearings.len()];
        for mass in turning_masses(engine) {
            let load = numbers::direction(&mass.angle) * numbers::float(&mass.mass_radius);
            rotating.iter_mut().zip(shared(&mass.position, load)).for_each(|(sum, part)| *sum += part);
        }
        Closed { pistons, rotating }
    }

    /// The load of the bearing that feels most at a crank angle.
    fn at(&self, theta: f64) -> f64 {
        let mut sums: Vec<Complex<f64>> = self.rotating.iter().map(|mass| mass * Complex::cis(theta)).collect();
        for piston in &self.pistons {
            let psi = theta + piston.phase;
            let push = Complex::new(1.0, -piston.crank.rod_slope(psi)) * -piston.crank.acceleration(psi);
            sums.iter_mut().zip(&piston.part).for_each(|(sum, part)| *sum += part * push);
        }
        sums.iter().map(|sum| sum.norm()).fold(0.0, f64::max)
    }

    /// The largest load at this many angles, and where it is.
    fn largest(&self, steps: u32) -> (f64, f64) {
        let angles = (0..steps).map(|place| TAU * f64::from(place) / f64::from(steps));
        angles
            .map(|theta| (self.at(theta), theta))
            .fold((0.0, 0.0), |best, one| if one.0 > best.0 { one } else { best })
    }

    /// The largest load, by golden sections beside the largest of the finest angles.
    fn peak(&self) -> f64 {
        let steps = STEPS[STEPS.len() - 1];
        let (value, theta) = self.largest(steps);
        let step = TAU / f64::from(steps);
        value.max(self.at(golden_section(theta - step, theta + step, SECTIONS, |theta| self.at(theta))))
    }
}
