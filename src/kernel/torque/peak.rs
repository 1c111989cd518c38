//! What is the largest torque, in size, by the first orders of the gas, or at this many angles, and how far off is that?
//!
//! The torque has kinks where a valve opens or the burning ends, so that its orders fall as 1/κ² and the error of a peak as 1/κ: the peak
//! is shown by the time law, in which the inertia is closed and needs no orders at all.

use std::f64::consts::TAU;

use num_complex::Complex;
use num_traits::One;

use super::class::Class;
use super::order::Stars;
use super::{EngineTorque, Extreme, TorqueOrder, orders, series};
use crate::engine::{CycleOrder, HIGHEST_ORDER};
use crate::loads::PeakMethod;

/// The torque that is largest in size, with its sign, by several methods.
#[derive(Clone, Debug)]
pub struct Peak<'a> {
    torque: &'a EngineTorque,
    /// By the time law: the reference of the others. They look for theirs at the same end, the highest torque or the lowest.
    pub largest: Extreme,
    orders: Vec<TorqueOrder>,
    /// All orders above those together are at most this, in newton-metres.
    rest: f64,
}

impl<'a> Peak<'a> {
    /// Finds the orders of the gas as far as they are compared.
    pub fn new(torque: &'a EngineTorque) -> Self {
        let mut classes = torque.classes.clone();
        for class in &mut classes {
            let revolutions = class.gas.revolutions() as usize;
            class.harmonics = class.gas.harmonics(PeakMethod::HIGHEST * revolutions);
        }
        let rest = classes.iter().map(rest).sum();
        Peak { largest: torque.largest(), torque, orders: orders(&classes, &[]), rest }
    }

    /// The methods that are compared: every order that is left up to 6, some higher ones, and samples.
    pub fn methods(&self) -> Vec<PeakMethod> {
        PeakMethod::of_gas(|asked| self.orders.iter().any(|order| order.order == asked && !order.gas_vanishes))
    }

    /// This end of the torque by a method, in newton-metres.
    pub fn value(&self, method: PeakMethod) -> f64 {
        let course = &self.torque.course;
        let sign = self.largest.value.signum();
        let largest = |torque: &dyn Fn(f64) -> f64| sign * course.extremes(|theta| sign * torque(theta))[0].value;
        match method {
            PeakMethod::Orders(highest) => {
                let kept = self.kept(highest);
                largest(&|theta| self.torque.mean + series(kept, theta) + course.inertia(theta))
            }
            PeakMethod::Samples(steps) => {
                let revolutions = (course.period() / TAU).round() as u32;
                let at = |place: u32| sign * course.total(TAU * f64::from(place) / f64::from(steps));
                sign * (0..steps * revolutions).map(at).fold(f64::NEG_INFINITY, f64::max)
            }
            PeakMethod::Refined => largest(&|theta| course.total(theta)),
        }
    }

    /// The largest distance of the torque by these orders from the time law anywhere in the cycle, in newton-metres; none for samples.
    pub fn farthest(&self, method: PeakMethod) -> Option<f64> {
        let course = &self.torque.course;
        match method {
            PeakMethod::Orders(highest) => {
                let kept = self.kept(highest);
                let off = |theta: f64| (course.gas(theta) - self.torque.mean - series(kept, theta)).abs();
                Some(course.extremes(off)[0].value)
            }
            PeakMethod::Samples(_) | PeakMethod::Refined => None,
        }
    }

    /// The torque by these orders is nowhere further off, in newton-metres, roundings apart; none for samples.
    pub fn bound(&self, method: PeakMethod) -> Option<f64> {
        match method {
            PeakMethod::Orders(highest) => {
                let left_out = self.orders.iter().filter(|order| order.order > highest);
                Some(left_out.map(|order| order.gas.norm()).sum::<f64>() + self.rest)
            }
            PeakMethod::Samples(_) | PeakMethod::Refined => None,
        }
    }

    /// By which part of the peak of the time law a value differs from it.
    pub fn error(&self, value: f64) -> f64 {
        self.part(value - self.largest.value)
    }

    /// A torque as a part of the peak of the time law; 0 where nothing turns the crank at all.
    pub fn part(&self, torque: f64) -> f64 {
        let part = torque.abs() / self.largest.value.abs();
        if part.is_nan() { 0.0 } else { part }
    }

    /// The orders of the gas, rising, up to this one.
    fn kept(&self, highest: CycleOrder) -> &[TorqueOrder] {
        &self.orders[..self.orders.partition_point(|order| order.order <= highest)]
    }
}

/// What the orders of a class above those that were computed add at most: each bounded times its star, then all cylinders alike.
fn rest(class: &Class) -> f64 {
    let revolutions = class.harmonics.revolutions;
    let halves = 2 / revolutions;
    let computed = u32::try_from(class.harmonics.torque.len()).unwrap_or(u32::MAX);
    let last = 2 * HIGHEST_ORDER / halves;
    let bound = |index: u32| class.harmonics.bound(f64::from(index) / f64::from(revolutions));
    let star = |index: u32| {
        let stars =
            CycleOrder::of_halves(index * halves).map(|order| Stars::each_once(std::slice::from_ref(class), order));
        let known = stars.and_then(|stars| stars.sum(|_| Some(Complex::one())));
        known.map_or(class.cylinders.len() as f64, |star| star.norm())
    };
    // Σ 1/n² over n > N is below 1/N.
    let above = bound(last) * f64::from(last) * class.cylinders.len() as f64;
    (computed..=last).map(|index| bound(index) * star(index)).sum::<f64>() + above
}
