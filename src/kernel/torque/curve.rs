//! How does the torque go through the cycle, and which work has it done? By the time law, not by the series.

use std::f64::consts::TAU;

use super::bodies::{Bodies, Inertia};
use super::class::Class;
use super::extreme::{self, Extreme};
use crate::engine::{AxisLeftOut, Engine};
use crate::gas::{CylinderGas, integrate, integrate_short};
use crate::numbers;

/// The torque over the crank angle θ, in radians: on the only crankshaft, or of all that are geared together at the first.
#[derive(Clone, Debug)]
pub struct TorqueCurve {
    pistons: Vec<Piston>,
    masses: Vec<Mass>,
    classes: Vec<ClassCourse>,
    inertias: Vec<Option<Inertia>>,
    /// The sense of each crankshaft, 1 with the first and −1 against it, and the mean torque on it; one where there is one.
    shafts: Vec<Shaft>,
    /// Whether it is known where the axes of all crankshafts stand on which the roll moment depends.
    has_arms: bool,
    period: f64,
}

#[derive(Clone, Debug)]
struct Piston {
    class: usize,
    fires: f64,
    shaft: usize,
}

/// A mass that moves.
#[derive(Clone, Debug)]
struct Mass {
    inertia: usize,
    top: f64,
    /// In multiples of the engine's.
    weight: f64,
    shaft: usize,
    /// Arm of the cylinder's axis about the middle of the engine, in metres, its own offset apart.
    arm: f64,
}

#[derive(Clone, Copy, Debug)]
struct Shaft {
    sense: f64,
    mean: f64,
}

#[derive(Clone, Debug)]
struct ClassCourse {
    gas: CylinderGas,
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
        ClassCourse { gas, mean, work }
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
    pub(super) fn new(engine: &Engine, classes: &[Class], bodies: &[Bodies]) -> Self {
        let cylinder = |index: &usize| &engine.cylinders()[*index];
        let turned = |turns| numbers::float(turns) * TAU;
        let pistons = classes.iter().enumerate().flat_map(|(class, of)| {
            let piston = move |(index, turns)| Piston { class, fires: turned(turns), shaft: cylinder(index).crank };
            of.cylinders.iter().zip(&of.fires).map(piston)
        });
        let pistons: Vec<Piston> = pistons.collect();
        let radius = engine.dimensions().crank_radius.as_ref().map_or(0.0, numbers::float);
        let masses = bodies.iter().enumerate().flat_map(|(inertia, of)| {
            let places = of.cylinders.iter().zip(&of.tops).zip(&of.weights);
            places.map(move |((index, turns), weight)| {
                let axes = engine.crank_of(cylinder(index)).into_iter().flat_map(|crank| &crank.axis);
                let across = |axis: &crate::exact::Term| {
                    numbers::direction(&(&cylinder(index).bank - &axis.angle)).im * numbers::float(&axis.weight)
                };
                Mass {
                    inertia,
                    top: turned(turns),
                    weight: numbers::float(weight),
                    shaft: cylinder(index).crank,
                    arm: if of.is_of_pistons { axes.map(across).sum::<f64>() * radius } else { 0.0 },
                }
            })
        });
        let senses = engine.geared_cranks().iter().map(|crank| crank.sense.signed(1.0));
        let senses: Vec<f64> = if engine.geared_cranks().is_empty() { vec![1.0] } else { senses.collect() };
        let of_shaft = |(shaft, sense)| {
            let own = pistons.iter().filter(|piston| piston.shaft == shaft);
            Shaft { sense, mean: own.map(|piston| classes[piston.class].harmonics.torque[0].re).sum() }
        };
        TorqueCurve {
            masses: masses.collect(),
            inertias: bodies.iter().map(|of| of.inertia.clone()).collect(),
            shafts: senses.into_iter().enumerate().map(of_shaft).collect(),
            has_arms: engine.geared_cranks().iter().all(|crank| crank.left_out != Some(AxisLeftOut::Place)),
            classes: classes.iter().map(ClassCourse::new).collect(),
            period: classes.first().map_or(TAU, |class| class.gas.period()),
            pistons,
        }
    }

    /// Length of the cycle in radians.
    pub fn period(&self) -> f64 {
        self.period
    }

    fn sum(&self, theta: f64, of: impl Fn(&ClassCourse, f64, &Piston) -> f64) -> f64 {
        self.pistons.iter().map(|piston| of(&self.classes[piston.class], theta - piston.fires, piston)).sum()
    }

    fn sum_of_inertia(&self, theta: f64, of: impl Fn(&Inertia, f64, &Mass) -> f64) -> f64 {
        let of_one = |mass: &Mass| {
            let inertia = self.inertias[mass.inertia].as_ref();
            inertia.map_or(0.0, |inertia| mass.weight * of(inertia, theta - mass.top, mass))
        };
        self.masses.iter().map(of_one).sum()
    }

    /// The torque of the gas.
    pub fn gas(&self, theta: f64) -> f64 {
        self.sum(theta, |class, psi, _| class.gas.torque(psi))
    }

    /// The inertia torque; zero where it is not known.
    pub fn inertia(&self, theta: f64) -> f64 {
        self.sum_of_inertia(theta, |inertia, psi, _| inertia.torque(psi))
    }

    /// Both together.
    pub fn total(&self, theta: f64) -> f64 {
        self.gas(theta) + self.inertia(theta)
    }

    /// Both together on one of several crankshafts, positive in the sense in which it turns.
    pub fn on_shaft(&self, shaft: usize, theta: f64) -> f64 {
        let on_it = |one: usize, value: f64| if one == shaft { value } else { 0.0 };
        self.sum(theta, |class, psi, piston| on_it(piston.shaft, class.gas.torque(psi)))
            + self.sum_of_inertia(theta, |inertia, psi, mass| on_it(mass.shaft, inertia.torque(psi)))
    }

    /// The mean torque on one of several crankshafts.
    pub fn mean_on(&self, shaft: usize) -> f64 {
        self.shafts.get(shaft).map_or(0.0, |shaft| shaft.mean)
    }

    /// The roll moment on the frame, `−T − Σ e F_in`: what answers the torque, and the shaking forces beside the shaft. Of several
    /// crankshafts each with its own flywheel: −T of one that turns against the first turns the other way, the mean leaves at the first, and
    /// the shaking forces have arms about the middle of the engine. None where an arm is not known.
    pub fn roll(&self, theta: f64) -> Option<f64> {
        let sense = |shaft: usize| self.shafts[shaft].sense;
        let gas = self.sum(theta, |class, psi, piston| sense(piston.shaft) * class.gas.torque(psi));
        let masses = self.sum_of_inertia(theta, |inertia, psi, mass| {
            sense(mass.shaft) * (inertia.torque(psi) + inertia.sideways(psi)) - mass.arm * inertia.force(psi)
        });
        let carried: f64 = self.shafts.iter().map(|shaft| (1.0 - shaft.sense) * shaft.mean).sum();
        self.has_arms.then_some(-gas - masses - carried)
    }

    /// `∫ (T_gas − mean) dθ`, but for a constant.
    pub fn gas_work(&self, theta: f64) -> f64 {
        self.sum(theta, |class, psi, _| class.work(psi))
    }

    /// `Σ m s'²`, the inertia of the reciprocating mass, in kilograms times square metres.
    pub fn reduced_inertia(&self, theta: f64) -> f64 {
        self.sum_of_inertia(theta, |inertia, psi, _| inertia.reduced(psi))
    }

    /// `∫ (T − mean) dθ`, but for a constant: `−½ m s'² ω²` is that of the inertia torque.
    pub fn work(&self, theta: f64) -> f64 {
        let kinetic = |inertia: &Inertia, psi: f64, _: &Mass| {
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

    /// The largest and the smallest value of a function in the cycle that is smooth but for the kinks of the pressures.
    pub fn extremes(&self, value: impl Fn(f64) -> f64) -> [Extreme; 2] {
        let kinks =
            self.pistons.iter().flat_map(|piston| self.classes[piston.class].gas.kinks().map(|psi| psi + piston.fires));
        let grid = extreme::angles_with(kinks, self.period);
        let values: Vec<f64> = grid.iter().map(|&theta| value(theta)).collect();
        extreme::extremes(self.period, &grid, &values, value)
    }
}
