//! How does the torque go through the cycle, and which work has it done? By the time law, not by the series.

use std::f64::consts::TAU;

use super::class::{Class, Inertia};
use super::extreme::{self, Extreme};
use crate::gas::{CylinderGas, integrate, integrate_short};
use crate::numbers;

/// The torque over the crank angle θ, in radians.
#[derive(Clone, Debug)]
pub struct TorqueCurve {
    pistons: Vec<Piston>,
    classes: Vec<ClassCourse>,
    period: f64,
}

#[derive(Clone, Debug)]
struct Piston {
    class: usize,
    fires: f64,
    /// In multiples of the engine's.
    mass: f64,
}

#[derive(Clone, Debug)]
struct ClassCourse {
    gas: CylinderGas,
    inertia: Option<Inertia>,
    mean: f64,
    /// Angles ψ through a cycle, and the work of the gas less its mean up to each.
    work: Vec<(f64, f64)>,
}

/// Parts of the gas work are at most so wide, in radians.
const WIDEST: f64 = 0.05;

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

impl TorqueCurve {
    pub(super) fn new(classes: &[Class]) -> Self {
        let pistons = classes.iter().enumerate().flat_map(|(class, of)| {
            let piston =
                move |(turns, mass)| Piston { class, fires: numbers::float(turns) * TAU, mass: numbers::float(mass) };
            of.fires.iter().zip(&of.masses).map(piston)
        });
        let period = classes.first().map_or(TAU, |class| class.gas.period());
        TorqueCurve { pistons: pistons.collect(), classes: classes.iter().map(ClassCourse::new).collect(), period }
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

    fn sum_of_inertia(&self, theta: f64, of: impl Fn(&Inertia, f64) -> f64) -> f64 {
        let of_one = |piston: &Piston| {
            let inertia = self.classes[piston.class].inertia.as_ref();
            inertia.map_or(0.0, |inertia| piston.mass * of(inertia, theta - piston.fires))
        };
        self.pistons.iter().map(of_one).sum()
    }

    /// The inertia torque; zero where it is not known.
    pub fn inertia(&self, theta: f64) -> f64 {
        self.sum_of_inertia(theta, Inertia::torque)
    }

    /// Both together.
    pub fn total(&self, theta: f64) -> f64 {
        self.gas(theta) + self.inertia(theta)
    }

    /// The roll moment on the frame, `−T − Σ e F_in`: what answers the torque, and the shaking forces beside the shaft.
    pub fn roll(&self, theta: f64) -> f64 {
        -self.total(theta) - self.sum_of_inertia(theta, Inertia::sideways)
    }

    /// `∫ (T_gas − mean) dθ`, but for a constant.
    pub fn gas_work(&self, theta: f64) -> f64 {
        self.sum(theta, ClassCourse::work)
    }

    /// `Σ m s'²`, the inertia of the reciprocating mass, in kilograms times square metres.
    pub fn reduced_inertia(&self, theta: f64) -> f64 {
        self.sum_of_inertia(theta, Inertia::reduced)
    }

    /// `∫ (T − mean) dθ`, but for a constant: `−½ m s'² ω²` is that of the inertia torque.
    pub fn work(&self, theta: f64) -> f64 {
        let kinetic = |inertia: &Inertia, psi: f64| {
            // m s'² times ω², which is the quotient of the two scales.
            let squared = if inertia.weight == 0.0 { 0.0 } else { inertia.scale / inertia.weight };
            0.5 * inertia.reduced(psi) * squared
        };
        self.gas_work(theta) - self.sum_of_inertia(theta, kinetic)
    }

    /// Angles through the cycle, half a degree apart.
    pub fn angles(&self) -> impl Iterator<Item = f64> {
        extreme::angles(self.period)
    }

    /// The largest and the smallest value of a function in the cycle.
    pub fn extremes(&self, value: impl Fn(f64) -> f64) -> [Extreme; 2] {
        let grid: Vec<f64> = self.angles().collect();
        let values: Vec<f64> = grid.iter().map(|&theta| value(theta)).collect();
        extreme::extremes(self.period, &grid, &values, value)
    }
}
