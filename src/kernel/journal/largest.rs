//! What is largest in a cycle: the load of a bearing, of a pin, of a rod, of a wall?

use num_complex::Complex;

use super::carried::Carried;
use super::force_history::{ForceHistory, PistonForces};
use crate::torque::{self, Extreme};

/// The largest load of a place in a cycle.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct CyclePeak {
    /// Its length in newtons.
    pub value: f64,
    /// The crank angle θ in degrees, within the cycle.
    pub angle: f64,
    /// The load there.
    pub vector: Complex<f64>,
    /// The gas in it.
    pub gas: Complex<f64>,
}

impl CyclePeak {
    /// What the gas adds along the direction of the peak, in newtons.
    pub fn gas_along(&self) -> f64 {
        if self.value > 0.0 { (self.gas * self.vector.conj()).re / self.value } else { 0.0 }
    }
}

/// The largest forces of one cylinder.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct CylinderPeaks {
    /// The largest and the smallest force along the rod: positive where it is pressed, negative where it is pulled.
    pub rod: [Extreme; 2],
    /// The largest pull of the big end on its pin along the rod, its rotating part with it; not below 0.
    pub pull: Extreme,
    /// The largest and the smallest force of the wall on the piston, a quarter turn anticlockwise from the axis outward; of a master's with
    /// what its links put on it.
    pub side: [Extreme; 2],
    /// The largest load of the crankpin.
    pub pin: CyclePeak,
    /// The largest load of the crankpin by the masses alone.
    pub pin_of_inertia: CyclePeak,
}

/// The forces at rising angles through a cycle, kinks of the pressures among them: from one to the next all is smooth.
pub(super) struct Samples {
    grid: Vec<f64>,
    /// A row a cylinder.
    forces: Vec<Vec<PistonForces>>,
    /// The loads of the pins, of masses and gas.
    pins: Vec<Vec<[Complex<f64>; 2]>>,
}

impl Samples {
    pub fn new(course: &ForceHistory) -> Self {
        let grid = torque::angles_with(course.kinks(), course.period());
        let row = |index: usize| grid.iter().map(|&theta| course.forces(index, theta)).collect();
        let forces: Vec<Vec<PistonForces>> = (0..course.cylinders()).map(row).collect();
        let pins = forces.iter().enumerate().map(|(index, row)| {
            let known = grid.iter().zip(row);
            known.map(|(&theta, &forces)| course.pin_parts_of(index, theta, forces)).collect()
        });
        Samples { pins: pins.collect(), forces, grid }
    }

    /// The largest load of a place: of all, and of the masses alone.
    pub fn peaks_of(&self, course: &ForceHistory, carried: &Carried) -> [CyclePeak; 2] {
        let at = |(step, theta): (usize, &f64)| {
            let shaft = [carried.of_shaft(*theta), Complex::new(0.0, 0.0)];
            carried.left(carried.parts.iter().zip(&self.pins).fold(shaft, |[inertia, gas], (part, row)| {
                let [of_inertia, of_gas] = row[step];
                [inertia + of_inertia * part, gas + of_gas * part]
            }))
        };
        let known: Vec<[Complex<f64>; 2]> = self.grid.iter().enumerate().map(at).collect();
        let of_inertia = |theta: f64| course.carried_of_inertia(carried, theta);
        self.two(course, &known, (|theta| course.carried_parts(carried, theta), of_inertia))
    }

    fn two(
        &self,
        course: &ForceHistory,
        known: &[[Complex<f64>; 2]],
        (parts, inertia): (impl Fn(f64) -> [Complex<f64>; 2], impl Fn(f64) -> Complex<f64>),
    ) -> [CyclePeak; 2] {
        let all = |[inertia, gas]: [Complex<f64>; 2]| inertia + gas;
        let sizes: Vec<f64> = known.iter().map(|&parts| all(parts).norm()).collect();
        let found = torque::largest(course.period(), &self.grid, &sizes, |theta| all(parts(theta)).norm());
        let there = parts(found.angle.to_radians());
        let sizes: Vec<f64> = known.iter().map(|[inertia, _]| inertia.norm()).collect();
        let of_inertia = torque::largest(course.period(), &self.grid, &sizes, |theta| inertia(theta).norm());
        [
            CyclePeak { value: found.value, angle: found.angle, vector: all(there), gas: there[1] },
            CyclePeak {
                value: of_inertia.value,
                angle: of_inertia.angle,
                vector: inertia(of_inertia.angle.to_radians()),
                gas: Complex::new(0.0, 0.0),
            },
        ]
    }

    /// The largest load of the knuckle pin of a link: of all, and of the masses alone; none where the rod is on the crankpin.
    pub fn knuckle_peaks(&self, course: &ForceHistory, index: usize) -> Option<[CyclePeak; 2]> {
        let known = self.grid.iter().map(|&theta| course.knuckle_parts(index, theta));
        let known: Vec<[Complex<f64>; 2]> = known.collect::<Option<_>>()?;
        let parts = |theta: f64| course.knuckle_parts(index, theta).unwrap_or_default();
        let inertia = |theta: f64| course.knuckle_of_inertia(index, theta).unwrap_or_default();
        Some(self.two(course, &known, (parts, inertia)))
    }
}

impl CylinderPeaks {
    pub(super) fn new(course: &ForceHistory, samples: &Samples, index: usize) -> Self {
        let extremes = |value: &dyn Fn(f64, PistonForces) -> f64| {
            let known = samples.grid.iter().zip(&samples.forces[index]);
            let known: Vec<f64> = known.map(|(&theta, &forces)| value(theta, forces)).collect();
            torque::extremes(course.period(), &samples.grid, &known, |theta| value(theta, course.forces(index, theta)))
        };
        let [pull, _] = extremes(&|theta, forces| course.pull_of(index, theta, forces).max(0.0));
        let laws = (|theta: f64| course.pin_parts(index, theta), |theta: f64| course.pin_of_inertia(index, theta));
        let [pin, pin_of_inertia] = samples.two(course, &samples.pins[index], laws);
        CylinderPeaks {
            rod: extremes(&|_, forces| forces.rod()),
            pull,
            side: extremes(&|theta, forces| course.side_of(index, theta, forces)),
            pin,
            pin_of_inertia,
        }
    }
}
