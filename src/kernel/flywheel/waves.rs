//! How large is the fluctuation of energy of a torque in harmonics? Of one it is `2R/κ`, exactly; of several the range of the integral.

use std::f64::consts::TAU;

use num_rational::BigRational;
use num_traits::Zero;

use super::drawn::Drawn;
use super::with_pi::WithPi;
use crate::file::{Diagram, Harmonic, Torque};
use crate::numbers::{self, Form};
use crate::torque;

/// Steps of a period of the highest order in which extremes are looked for.
const STEPS: usize = 32;

/// The sum of harmonics at an angle in radians.
pub(super) fn at(harmonics: &[Harmonic], theta: f64) -> f64 {
    let one = |wave: &Harmonic| {
        let (sin, cos) = (wave.order.value() * theta).sin_cos();
        numbers::float(&wave.cos) * cos + numbers::float(&wave.sin) * sin
    };
    harmonics.iter().map(one).sum()
}

/// The harmonics of the load; none where it is the mean.
pub(super) fn load(diagram: &Diagram) -> &[Harmonic] {
    match &diagram.load {
        Some(Torque::Harmonics(_, load)) => load,
        Some(Torque::Lines(_) | Torque::Areas(_)) | None => &[],
    }
}

/// Torque less load, each order once.
fn excess(torque: &[Harmonic], load: &[Harmonic]) -> Vec<Harmonic> {
    let mut sum: Vec<Harmonic> = Vec::new();
    let negative = load.iter().map(|wave| Harmonic { order: wave.order, cos: -&wave.cos, sin: -&wave.sin });
    for wave in torque.iter().cloned().chain(negative) {
        match sum.iter_mut().find(|known| known.order == wave.order) {
            Some(known) => {
                known.cos += wave.cos;
                known.sin += wave.sin;
            }
            None => sum.push(wave),
        }
    }
    sum.retain(|wave| !(wave.cos.is_zero() && wave.sin.is_zero()));
    sum
}

pub(super) fn drawn(mean: &BigRational, torque: &[Harmonic], load: &[Harmonic]) -> Drawn {
    let excess = excess(torque, load);
    let all = || torque.iter().chain(load);
    let turns = if all().all(|wave| wave.order.is_whole()) { 1 } else { 2 };
    let energy = |theta: f64| -> f64 {
        let one = |wave: &Harmonic| {
            let kappa = wave.order.value();
            let (sin, cos) = (kappa * theta).sin_cos();
            (numbers::float(&wave.cos) * sin - numbers::float(&wave.sin) * cos) / kappa
        };
        excess.iter().map(one).sum()
    };
    let highest = excess.iter().map(|wave| wave.order.halves()).max().unwrap_or(1) as usize;
    let period = f64::from(turns) * TAU;
    let count = STEPS * highest * turns as usize;
    let grid: Vec<f64> = (0..count).map(|step| period * step as f64 / count as f64).collect();
    let values: Vec<f64> = grid.iter().map(|&theta| energy(theta)).collect();
    let [fastest, slowest] = torque::extremes(period, &grid, &values, energy);
    let energy = match excess.as_slice() {
        [] => WithPi::rational(BigRational::zero(), 0),
        [wave] => {
            let root = Form::rational(&wave.cos * &wave.cos + &wave.sin * &wave.sin).square_root();
            WithPi::new(root.scaled(&(BigRational::from_integer(2.into()) / wave.order.exact())), 0)
        }
        _ => WithPi::decimal(fastest.value - slowest.value),
    };
    Drawn {
        mean: Some(WithPi::rational(mean.clone(), 0)),
        cycle: Some(BigRational::from_integer(turns.into())),
        fastest_and_slowest: (!excess.is_empty()).then_some([fastest.angle, slowest.angle]),
        energy,
        lobes: Vec::new(),
    }
}
