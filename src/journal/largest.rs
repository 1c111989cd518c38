//! What is largest in a cycle: the load of a bearing, of a pin, of a rod, of a wall?

use num_complex::Complex;

use super::Carried;
use super::course::Course;
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
    /// The largest and the smallest force of the wall on the piston, a quarter turn anticlockwise from the axis outward.
    pub side: [Extreme; 2],
    /// The largest load of the crankpin.
    pub pin: CyclePeak,
    /// The largest load of the crankpin by the masses alone.
    pub pin_of_inertia: CyclePeak,
}

/// Angles closer than this in radians are one.
const SAME: f64 = 1e-9;

/// The loads of the pins at rising angles through a cycle, kinks of the pressures among them: from one to the next all is smooth.
pub(super) struct Samples {
    grid: Vec<f64>,
    /// Of masses and gas, a row a cylinder.
    pins: Vec<Vec<[Complex<f64>; 2]>>,
}

impl Samples {
    pub fn new(course: &Course) -> Self {
        let mut grid: Vec<f64> = torque::angles(course.period()).chain(course.kinks()).collect();
        grid.sort_unstable_by(f64::total_cmp);
        grid.dedup_by(|next, before| *next - *before < SAME);
        let row = |index: usize| grid.iter().map(|&theta| course.pin_parts(index, theta)).collect();
        Samples { pins: (0..course.cylinders()).map(row).collect(), grid }
    }

    /// The largest load of a place: of all, of the masses alone, of the gas alone.
    pub fn peaks_of(&self, course: &Course, carried: &Carried) -> [CyclePeak; 3] {
        let parts: Vec<[Complex<f64>; 2]> = self
            .grid
            .iter()
            .enumerate()
            .map(|(step, theta)| {
                let shaft = [carried.shaft * Complex::cis(*theta), Complex::new(0.0, 0.0)];
                carried.parts.iter().zip(&self.pins).fold(shaft, |[inertia, gas], (part, row)| {
                    let [of_inertia, of_gas] = row[step];
                    [inertia + of_inertia * part, gas + of_gas * part]
                })
            })
            .collect();
        self.three(course, &parts, |theta| course.carried_parts(carried, theta))
    }

    fn three(
        &self,
        course: &Course,
        known: &[[Complex<f64>; 2]],
        at: impl Fn(f64) -> [Complex<f64>; 2],
    ) -> [CyclePeak; 3] {
        let meant: [fn([Complex<f64>; 2]) -> Complex<f64>; 3] =
            [|[inertia, gas]| inertia + gas, |[inertia, _]| inertia, |[_, gas]| gas];
        meant.map(|meant| {
            let sizes: Vec<f64> = known.iter().map(|&parts| meant(parts).norm()).collect();
            let found = torque::largest(course.period(), &self.grid, &sizes, |theta| meant(at(theta)).norm());
            let parts = at(found.angle.to_radians());
            CyclePeak { value: found.value, angle: found.angle, vector: meant(parts), gas: parts[1] }
        })
    }
}

impl CylinderPeaks {
    pub(super) fn new(course: &Course, samples: &Samples, index: usize) -> Self {
        let extremes = |value: &dyn Fn(f64) -> f64| torque::extremes(course.period(), &samples.grid, value);
        let [pull, _] = extremes(&|theta| course.pull(index, theta).max(0.0));
        let [pin, pin_of_inertia, _] =
            samples.three(course, &samples.pins[index], |theta| course.pin_parts(index, theta));
        CylinderPeaks {
            rod: extremes(&|theta| course.forces(index, theta).rod()),
            pull,
            side: extremes(&|theta| course.forces(index, theta).side()),
            pin,
            pin_of_inertia,
        }
    }
}
