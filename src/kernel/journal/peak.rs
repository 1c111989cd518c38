//! What is the largest bearing load of gas and masses by the first orders of the gas, or at this many angles, and how far off is that?
//!
//! Where a valve opens the pressure has a kink, so that the orders of a load fall as those of the torque do. The masses stay in their closed
//! form, which needs no orders; the largest load is shown by the forces themselves, the reference of the others.

use std::f64::consts::TAU;

use num_complex::Complex;

use super::force_history::ForceHistory;
use super::largest::Samples;
use super::{Carried, carried_by_bearings, course};
use crate::engine::{CycleOrder, Engine};
use crate::gas::Harmonics;
use crate::loads::{Missing, PeakMethod};
use crate::torque;

/// The largest load of any main bearing by several methods.
pub struct LoadPeak {
    course: ForceHistory,
    bearings: Vec<Bearing>,
    revolutions: u32,
    /// The largest load by the forces themselves, in newtons.
    pub largest: f64,
}

struct Bearing {
    carried: Carried,
    /// The gas that stays, and for each order κ, rising, what turns with the crank and against it.
    mean: Complex<f64>,
    orders: Vec<(CycleOrder, [Complex<f64>; 2])>,
}

impl LoadPeak {
    /// Finds the orders of the gas as far as they are compared; none where the layout has no main bearings.
    ///
    /// # Errors
    /// What the layout lacks.
    pub fn new(engine: &Engine) -> Result<Option<Self>, Missing> {
        let (course, all) = (course(engine)?, carried_by_bearings(engine)?);
        let revolutions = (course.period() / TAU).round() as u32;
        let highest = PeakMethod::HIGHEST * revolutions as usize;
        let harmonics: Vec<Harmonics> = course.classes().iter().map(|class| class.gas.harmonics(highest)).collect();
        let bearing = |carried: Carried| {
            let [mean, _] = course.gas_order(&carried, &harmonics, 0, 0.0);
            let order = |index: usize| {
                let order = CycleOrder::of_halves(u32::try_from(2 * index).ok()? / revolutions)?;
                let kappa = order.value();
                Some((order, course.gas_order(&carried, &harmonics, index, kappa)))
            };
            Bearing { mean: mean * 2.0, orders: (1..=highest).filter_map(order).collect(), carried }
        };
        let bearings: Vec<Bearing> = all.into_iter().map(bearing).collect();
        let samples = Samples::new(&course);
        let peaks = bearings.iter().map(|bearing| samples.peaks_of(&course, &bearing.carried)[0].value);
        let largest = peaks.fold(0.0, f64::max);
        Ok((largest > 0.0).then_some(LoadPeak { largest, course, bearings, revolutions }))
    }

    /// The methods that are compared: each order up to 6, some higher ones, and samples.
    pub fn methods(&self) -> Vec<PeakMethod> {
        PeakMethod::of_gas(|order| self.revolutions == 2 || order.is_whole())
    }

    /// The largest load of any bearing by a method, in newtons.
    pub fn value(&self, method: PeakMethod) -> f64 {
        let most = |loads: &mut dyn Iterator<Item = f64>| loads.fold(0.0, f64::max);
        match method {
            PeakMethod::Orders(highest) => {
                let of = |bearing: &Bearing| self.top(|theta| self.by_orders(bearing, highest, theta).norm());
                most(&mut self.bearings.iter().map(of))
            }
            PeakMethod::Samples(steps) => {
                let at = |place: u32| {
                    let theta = TAU * f64::from(place) / f64::from(steps);
                    most(&mut self.bearings.iter().map(|bearing| self.course.carried(&bearing.carried, theta).norm()))
                };
                most(&mut (0..steps * self.revolutions).map(at))
            }
            PeakMethod::Refined => {
                let samples = Samples::new(&self.course);
                let of = |bearing: &Bearing| samples.peaks_of(&self.course, &bearing.carried)[0].value;
                most(&mut self.bearings.iter().map(of))
            }
        }
    }

    /// The largest distance of a load by these orders from that of the forces anywhere in the cycle, in newtons; none for samples.
    pub fn farthest(&self, method: PeakMethod) -> Option<f64> {
        match method {
            PeakMethod::Orders(highest) => {
                let off = |bearing: &Bearing, theta: f64| {
                    (self.course.carried(&bearing.carried, theta) - self.by_orders(bearing, highest, theta)).norm()
                };
                Some(self.bearings.iter().map(|one| self.top(|theta| off(one, theta))).fold(0.0, f64::max))
            }
            PeakMethod::Samples(_) | PeakMethod::Refined => None,
        }
    }

    fn top(&self, size: impl Fn(f64) -> f64) -> f64 {
        let grid = torque::angles_with(self.course.kinks(), self.course.period());
        let sizes: Vec<f64> = grid.iter().map(|&theta| size(theta)).collect();
        torque::largest(self.course.period(), &grid, &sizes, size).value
    }

    fn by_orders(&self, bearing: &Bearing, highest: CycleOrder, theta: f64) -> Complex<f64> {
        let kept = bearing.orders.iter().take_while(|(order, _)| *order <= highest);
        let masses = self.course.carried_of_inertia(&bearing.carried, theta);
        kept.fold(masses + bearing.mean, |sum, (order, [direct, reverse])| {
            let turning = Complex::cis(order.value() * theta);
            sum + direct * turning + reverse * turning.conj()
        })
    }
}
