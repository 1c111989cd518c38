//! How far does a sum of orders swing through the cycle?

use std::f64::consts::TAU;

use num_complex::Complex;

use super::highest;
use crate::engine::CycleOrder;

/// Points of a cycle between which the largest and the smallest value are looked for: this many in each period of the highest order.
const POINTS: usize = 20;
/// But this many at least.
const LEAST: usize = 480;
/// A top of the points that is lower than the highest by more than this part of the range is no largest value: with so many points the
/// largest is less than an eightieth above the highest of them (Bernstein).
const LOWER: f64 = 0.0125;

/// Half of the largest less the smallest value of `Σ Re(v_κ e^{iκθ})`, as class rules count the stress of all orders together.
pub fn half_range(orders: &[(CycleOrder, Complex<f64>)]) -> f64 {
    match orders {
        [] => return 0.0,
        [(_, only)] => return only.norm(),
        _ => {}
    }
    let at = |half_angle: f64| -> f64 {
        orders.iter().map(|(order, value)| (value * Complex::cis(f64::from(order.halves()) * half_angle)).re).sum()
    };
    // The half angles of a cycle, in which every order repeats.
    let highest_order = orders.iter().map(|(order, _)| order.halves() as usize).max().unwrap_or(0);
    let points = LEAST.max(POINTS * highest_order);
    let turns: Vec<Complex<f64>> = (0..points).map(|index| Complex::cis(TAU * index as f64 / points as f64)).collect();
    let sample = |index: usize| -> f64 {
        let one = |(order, value): &(CycleOrder, Complex<f64>)| {
            let turn = turns[index * order.halves() as usize % points];
            value.re * turn.re - value.im * turn.im
        };
        orders.iter().map(one).sum()
    };
    let samples: Vec<f64> = (0..points).map(sample).collect();
    let range = [1.0, -1.0].map(|sign| samples.iter().map(|sample| sign * sample).fold(f64::NEG_INFINITY, f64::max));
    let step = TAU / points as f64;
    let extreme = |sign: f64, most: f64| {
        let value = |index: usize| sign * samples[index % points];
        let is_top = |&index: &usize| {
            let own = value(index);
            own >= value(index + points - 1) && own >= value(index + 1) && own >= most - LOWER * (range[0] + range[1])
        };
        let top = |index: usize| {
            let (low, high) = ((index as f64 - 1.0) * step, (index as f64 + 1.0) * step);
            highest(low, high, 2, &|angle| sign * at(angle)).1
        };
        (0..points).filter(is_top).map(top).fold(most, f64::max)
    };
    0.5 * (extreme(1.0, range[0]) + extreme(-1.0, range[1]))
}
