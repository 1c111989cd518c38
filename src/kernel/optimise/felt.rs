//! What do the bearings feel of the crankshaft without counterweights: of its masses, by orders, or of gas and masses through the cycle?

use std::f64::consts::TAU;

use num_complex::Complex;

use super::error::OptimiseError;
use super::first::Turning;
use crate::engine::Engine;
use crate::journal::{self, Carried, ForceHistory};
use crate::loads::{BearingLoads, Circle, Harmonic, Scale, Waveform};
use crate::proof::Sense;
use crate::torque;

/// Crank angles of a revolution at which a solution of the masses is searched for peaks.
const STEPS: usize = 720;

/// The loads of the bearings, in multiples of m r ω².
pub(super) enum Felt {
    /// Of the masses, at the orders that were asked for, with how the crankshaft of each bearing turns.
    Masses(Vec<(Waveform, Turning)>),
    /// Of gas and masses, where the layout asks for the gas.
    All(Box<AllForces>),
}

/// Gas and masses through the cycle.
pub(super) struct AllForces {
    course: ForceHistory,
    carried: Vec<Carried>,
    /// How the crankshaft of each bearing turns.
    turning: Vec<Turning>,
    /// m r ω² in newtons.
    unit: f64,
    grid: Vec<f64>,
    /// The loads of each bearing at the angles of the grid, seen from the crank.
    known: Vec<Vec<Complex<f64>>>,
}

impl AllForces {
    fn at(&self, bearing: usize, theta: f64) -> Complex<f64> {
        self.course.carried(&self.carried[bearing], theta) * self.turning[bearing].seen_from(theta) / self.unit
    }
}

impl Felt {
    /// Those of an engine without counterweights; `loads` are of its masses.
    pub fn new(bare: &Engine, loads: BearingLoads) -> Result<Self, OptimiseError> {
        let unit = loads.scale.as_ref().map_or(1.0, Scale::force);
        if loads.scale.as_ref().is_some_and(Scale::is_at_rest) {
            return Err(OptimiseError::Still);
        }
        let turning = loads.bearings.iter().map(|bearing| Turning::of(bare, bearing.crank)).collect::<Vec<_>>();
        if !bare.effects().gas {
            let waveforms = loads.bearings.into_iter().map(|bearing| bearing.waveform);
            return Ok(Felt::Masses(waveforms.zip(turning).collect()));
        }
        let course = journal::course(bare).map_err(|lack| OptimiseError::Gas(lack.to_string()))?;
        let carried = journal::carried_by_bearings(bare).map_err(|lack| OptimiseError::Gas(lack.to_string()))?;
        let grid: Vec<f64> = torque::angles(course.period()).collect();
        let mut all = AllForces { course, carried, turning, unit, grid, known: Vec::new() };
        let of_bearing = |bearing: usize| all.grid.iter().map(|theta| all.at(bearing, *theta)).collect();
        all.known = (0..all.carried.len()).map(of_bearing).collect();
        Ok(Felt::All(Box::new(all)))
    }

    /// How many bearings there are.
    pub fn bearings(&self) -> usize {
        match self {
            Felt::Masses(waveforms) => waveforms.len(),
            Felt::All(all) => all.carried.len(),
        }
    }

    /// How many revolutions go by until all begins anew.
    pub fn revolutions(&self) -> usize {
        match self {
            Felt::Masses(_) => 1,
            Felt::All(all) => (all.course.period() / TAU).round() as usize,
        }
    }

    /// What a bearing feels at a crank angle, seen from the crank.
    pub fn at(&self, bearing: usize, theta: f64) -> Complex<f64> {
        match self {
            Felt::Masses(waveforms) => {
                let (waveform, turning) = &waveforms[bearing];
                waveform.at(theta) * turning.seen_from(theta)
            }
            Felt::All(all) => all.at(bearing, theta),
        }
    }

    /// Where a bearing feels more than the limit, with what counterweights add to it: at the tops of a grid, and at the largest of all.
    pub fn tops(&self, bearing: usize, added: Complex<f64>, limit: f64) -> Vec<f64> {
        match self {
            Felt::Masses(waveforms) => {
                let (waveform, Turning { speed: order, sense }) = &waveforms[bearing];
                let none = Complex::new(0.0, 0.0);
                let [direct, reverse] = if *sense == Sense::Direct { [added, none] } else { [none, added] };
                let added = Harmonic { order: *order, direct, reverse };
                let waveform = Waveform::new(waveform.harmonics().iter().copied().chain([added]));
                let sizes: Vec<f64> = waveform.sample(&Circle::new(STEPS)).iter().map(|force| force.norm()).collect();
                let peak = waveform.peak();
                let highest = peak.angle.filter(|_| peak.value > limit).map(f64::to_radians);
                tops(&sizes, limit).map(|step| TAU * step as f64 / STEPS as f64).chain(highest).collect()
            }
            Felt::All(all) => {
                let sizes: Vec<f64> = all.known[bearing].iter().map(|load| (load + added).norm()).collect();
                let size = |theta: f64| (all.at(bearing, theta) + added).norm();
                let peak = torque::largest(all.course.period(), &all.grid, &sizes, size);
                let highest = (peak.value > limit).then(|| peak.angle.to_radians());
                tops(&sizes, limit).map(|step| all.grid[step]).chain(highest).collect()
            }
        }
    }
}

/// The places of a grid that are above the limit and no lower than both beside them.
fn tops(sizes: &[f64], limit: f64) -> impl Iterator<Item = usize> {
    let count = sizes.len();
    let is_top = move |&step: &usize| {
        let (last, next) = (sizes[(step + count - 1) % count], sizes[(step + 1) % count]);
        sizes[step] > limit && sizes[step] >= last && sizes[step] >= next
    };
    (0..count).filter(is_top)
}
