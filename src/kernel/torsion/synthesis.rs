//! How far does a sum of orders swing through the cycle?

use std::f64::consts::TAU;

use num_complex::Complex;

use super::highest;
use crate::engine::CycleOrder;

/// Points of a cycle between which the largest and the smallest value are looked for: this many in each period of the highest order.
const POINTS: usize = 20;
/// But this many at least.
const LEAST: usize = 480;

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
    let extreme = |sign: f64| {
        let top = (0..points).max_by(|one, other| (sign * samples[*one]).total_cmp(&(sign * samples[*other])));
        let step = TAU / points as f64;
        let middle = top.unwrap_or(0) as f64 * step;
        sign * highest(middle - step, middle + step, 2, &|angle| sign * at(angle)).1
    };
    0.5 * (extreme(1.0) - extreme(-1.0))
}
