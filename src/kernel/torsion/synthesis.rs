//! How far does a sum of orders swing through the cycle?

use std::f64::consts::TAU;

use num_complex::Complex;

use super::peak::{evenly, highest_beside};
use crate::engine::CycleOrder;

/// Points of a cycle between which the largest and the smallest value are looked for: this many in each period of the highest order.
const POINTS: usize = 20;
/// But this many at least.
const LEAST: usize = 480;
/// A top of the points that is lower than the highest by more than this part of their range is no largest value: with so many points no value
/// is farther above the nearest of them than an eighty-first of the largest size (Bernstein).
const LOWER: f64 = 0.013;

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
    // The last point is the first of the next cycle.
    let samples: Vec<f64> = (0..=points).map(sample).collect();
    let opposite: Vec<f64> = samples.iter().map(|sample| -sample).collect();
    let [most, least] = [&samples, &opposite].map(|all| all.iter().copied().fold(f64::NEG_INFINITY, f64::max));
    let within = LOWER * (most + least);
    let angles = evenly(0.0, TAU, points);
    let highest = highest_beside(&angles, &samples, most - within, &at).1;
    0.5 * (highest + highest_beside(&angles, &opposite, least - within, &|angle| -at(angle)).1)
}
