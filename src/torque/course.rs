//! How does the torque go through the cycle, and which work has it done? By the time law, not by the series.

use std::f64::consts::TAU;

use num_traits::ToPrimitive;

use super::class::{Class, Inertia};
use crate::gas::{CylinderGas, integrate, integrate_short};

/// The torque over the crank angle θ, in radians.
#[derive(Clone, Debug)]
pub struct Course {
    pistons: Vec<Piston>,
    classes: Vec<ClassCourse>,
    period: f64,
}

#[derive(Clone, Debug)]
struct Piston {
    class: usize,
    fires: f64,
}

#[derive(Clone, Debug)]
struct ClassCourse {
    gas: CylinderGas,
    inertia: Option<Inertia>,
    mean: f64,
    /// Angles ψ through a cycle, and the work of the gas less its mean up to each.
    work: Vec<(f64, f64)>,
}

/// A largest or smallest value, and where it first stands.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Extreme {
    /// The value.
    pub value: f64,
    /// The crank angle θ in degrees, within the cycle.
    pub angle: f64,
}

/// Steps of a revolution in which the largest value is looked for: half a degree each.
const STEPS: usize = 720;
/// Parts of the gas work are at most so wide, in radians.
const WIDEST: f64 = 0.05;
/// A top of the grid lower than the highest by more than this part of the range is no highest value.
const NEAR_TOP: f64 = 0.02;
/// Two tops closer than this part of their size are one, by roundings.
const EQUAL: f64 = 1e-9;

impl ClassCourse {
    fn new(class: &Class) -> Self {
        let gas = class.gas.clone();
        let mean = class.harmonics.torque[0].re;
        let mut kinks: Vec<f64> = gas.kinks().collect();
        kinks.extend(kinks.first().map(|first| first + gas.period()));
        let mut work = vec![(kinks[0], 0.0)];
        for pair in kinks.windows(2) {
            let count = ((pair[1] - pair[0]) / WIDEST).ceil().max(1.0) as usize;
            for step in 1..=count {
                let (from, sum) = work[work.len() - 1];
                let to = pair[0] + (pair[1] - pair[0]) * step as f64 / count as f64;
                work.push((to, sum + integrate(0.0, from, to, |psi| gas.torque(psi) - mean)));
            }
        }
        ClassCourse { gas, inertia: class.inertia.clone(), mean, work }
    }

    /// `∫ (T − t₀) dψ` of the gas, from the first kink on.
    fn work(&self, psi: f64) -> f64 {
        let first = self.work[0].0;
        let psi = first + (psi - first).rem_euclid(self.gas.period());
        let place = self.work.partition_point(|(at, _)| *at <= psi).saturating_sub(1);
        let (from, sum) = self.work[place];
        sum + integrate_short(from, psi, |psi| self.gas.torque(psi) - self.mean)
    }
}

impl Course {
    pub(super) fn new(classes: &[Class]) -> Self {
        let pistons = classes.iter().enumerate().flat_map(|(class, of)| {
            of.fires.iter().map(move |turns| Piston { class, fires: turns.to_f64().unwrap_or(f64::NAN) * TAU })
        });
        let period = classes.first().map_or(TAU, |class| class.gas.period());
        Course { pistons: pistons.collect(), classes: classes.iter().map(ClassCourse::new).collect(), period }
    }

    /// Length of the cycle in radians.
    pub fn period(&self) -> f64 {
        self.period
    }

    fn sum(&self, theta: f64, of: impl Fn(&ClassCourse, f64) -> f64) -> f64 {
        self.pistons.iter().map(|piston| of(&self.classes[piston.class], theta - piston.fires)).sum()
    }

    /// The torque of the gas.
    pub fn gas(&self, theta: f64) -> f64 {
        self.sum(theta, |class, psi| class.gas.torque(psi))
    }

    /// The inertia torque; zero where it is not known.
    pub fn inertia(&self, theta: f64) -> f64 {
        self.sum(theta, |class, psi| class.inertia.as_ref().map_or(0.0, |inertia| inertia.torque(psi)))
    }

    /// Both together.
    pub fn total(&self, theta: f64) -> f64 {
        self.gas(theta) + self.inertia(theta)
    }

    /// The roll moment on the frame, `−T − Σ e F_in`: what answers the torque, and the shaking forces beside the shaft.
    pub fn roll(&self, theta: f64) -> f64 {
        let aside = self.sum(theta, |class, psi| class.inertia.as_ref().map_or(0.0, |inertia| inertia.sideways(psi)));
        -self.total(theta) - aside
    }

    /// `∫ (T_gas − mean) dθ`, but for a constant.
    pub fn gas_work(&self, theta: f64) -> f64 {
        self.sum(theta, ClassCourse::work)
    }

    /// `Σ m s'²`, the inertia of what goes back and forth, in kilograms times square metres.
    pub fn reduced_inertia(&self, theta: f64) -> f64 {
        self.sum(theta, |class, psi| class.inertia.as_ref().map_or(0.0, |inertia| inertia.reduced(psi)))
    }

    /// `∫ (T − mean) dθ`, but for a constant: `−½ m s'² ω²` is that of the inertia torque.
    pub fn work(&self, theta: f64) -> f64 {
        self.sum(theta, |class, psi| {
            let kinetic = class.inertia.as_ref().map_or(0.0, |inertia| {
                // m s'² times ω², which is the quotient of the two scales.
                let squared = if inertia.weight == 0.0 { 0.0 } else { inertia.scale / inertia.weight };
                0.5 * inertia.reduced(psi) * squared
            });
            class.work(psi) - kinetic
        })
    }

    /// Angles through the cycle, half a degree apart.
    pub fn angles(&self) -> impl Iterator<Item = f64> {
        let count = (self.period / TAU * STEPS as f64).round() as usize;
        let step = self.period / count as f64;
        (0..count).map(move |index| index as f64 * step)
    }

    /// The largest and the smallest value of a function in the cycle: on a grid, then by golden sections beside its tops.
    pub fn extremes(&self, value: impl Fn(f64) -> f64) -> [Extreme; 2] {
        let values: Vec<f64> = self.angles().map(&value).collect();
        let step = self.period / values.len() as f64;
        let opposite: Vec<f64> = values.iter().map(|value| -value).collect();
        let lowest = self.highest(&opposite, step, |theta| -value(theta));
        [self.highest(&values, step, value), Extreme { value: -lowest.value, ..lowest }]
    }

    fn highest(&self, values: &[f64], step: f64, value: impl Fn(f64) -> f64) -> Extreme {
        let count = values.len();
        let highest = values.iter().copied().fold(f64::NEG_INFINITY, f64::max);
        let lowest = values.iter().copied().fold(f64::INFINITY, f64::min);
        let is_top = |&index: &usize| {
            let beside = values[(index + count - 1) % count].max(values[(index + 1) % count]);
            values[index] >= beside && values[index] >= highest - NEAR_TOP * (highest - lowest)
        };
        let mut best = Extreme { value: f64::NEG_INFINITY, angle: 0.0 };
        // Where nothing changes one place is as good as all.
        let most = if highest > lowest { count } else { 1 };
        for index in (0..count).filter(is_top).take(most) {
            let place = index as f64 * step;
            let theta = refined(place - step, place + step, &value);
            let theta = if value(theta) > values[index] { theta } else { place };
            let found = value(theta);
            if found > best.value + EQUAL * (highest - lowest) || best.value == f64::NEG_INFINITY {
                best = Extreme { value: found, angle: theta.rem_euclid(self.period).to_degrees() };
            }
        }
        best
    }
}

/// Where a function is largest between two places, by golden sections.
fn refined(mut low: f64, mut high: f64, value: impl Fn(f64) -> f64) -> f64 {
    let golden = (5.0_f64.sqrt() - 1.0) / 2.0;
    for _ in 0..50 {
        let (left, right) = (high - golden * (high - low), low + golden * (high - low));
        if value(left) < value(right) {
            low = left;
        } else {
            high = right;
        }
    }
    (low + high) / 2.0
}
