//! What is each order of the torque, and which vanish whatever the pressure is?

use num_complex::Complex;
use num_rational::BigRational;
use num_traits::One;

use super::bodies::Bodies;
use super::class::Class;
use crate::engine::{CycleOrder, Engine};
use crate::exact::{PhasorSum, Term};
use crate::numbers;

/// One order: `Re(vector · e^{iκθ})`, in newton-metres.
#[derive(Clone, Debug)]
pub struct TorqueOrder {
    /// The order κ: a half, or whole.
    pub order: CycleOrder,
    /// That of the gas.
    pub gas: Complex<f64>,
    /// That of the inertia: zero at halves; none where it is not known.
    pub inertia: Option<Complex<f64>>,
    /// The exact stars `Σ e^{−iκφ_j}` of the gas, one a class of equal cylinders.
    pub stars: Vec<PhasorSum>,
    /// Whether all of these are zero: then that of the gas is, proved, for every pressure that the cylinders of a class share.
    pub gas_vanishes: bool,
    /// Whether that of the inertia is zero, proved: its stars `Σ m_j e^{−iκφ_j}` are, one for all masses that move alike.
    pub inertia_vanishes: bool,
}

impl TorqueOrder {
    /// Gas and inertia together: their phasors add.
    pub fn total(&self) -> Complex<f64> {
        self.gas + self.inertia.unwrap_or_default()
    }

    /// Whether the gas, and the inertia where it is known, leave nothing of it, proved.
    pub fn vanishes(&self) -> bool {
        self.gas_vanishes && (self.inertia.is_none() || self.inertia_vanishes)
    }
}

/// The stars of an order of what is alike in several cylinders, each weighed: `Σ w_j e^{−iκφ_j}`.
pub(super) struct Stars<'a, T>(Vec<(&'a T, PhasorSum)>);

impl<'a> Stars<'a, Class> {
    /// Those of the gas, one a class; a weight by the cylinder.
    pub fn of_gas(classes: &'a [Class], order: CycleOrder, weight: impl Fn(usize) -> BigRational) -> Self {
        let star = |class: &Class| {
            let cylinders = class.cylinders.iter().zip(&class.fires);
            let term = |(&cylinder, fires)| Term { angle: order.phase(fires), weight: weight(cylinder) };
            PhasorSum::new(cylinders.map(term).collect())
        };
        Stars(classes.iter().map(|class| (class, star(class))).collect())
    }

    /// Those of the gas, each cylinder with the weight 1.
    pub fn each_once(classes: &'a [Class], order: CycleOrder) -> Self {
        Stars::of_gas(classes, order, |_| BigRational::one())
    }
}

impl<'a> Stars<'a, Bodies> {
    /// Those of the inertia, one for all masses that move alike and have the order: each is weighed by itself as well.
    pub fn of_inertia(bodies: &'a [Bodies], order: CycleOrder, weight: impl Fn(usize) -> BigRational) -> Self {
        let star = |of: &Bodies| {
            let masses = of.cylinders.iter().zip(&of.tops).zip(&of.weights);
            let term = |((&cylinder, top), mass): ((&usize, &BigRational), &BigRational)| Term {
                angle: order.phase(top),
                weight: weight(cylinder) * mass,
            };
            PhasorSum::new(masses.map(term).collect())
        };
        let has_it = |of: &&Bodies| !of.has_second_alone || order.halves() == 4;
        Stars(bodies.iter().filter(has_it).map(|of| (of, star(of))).collect())
    }
}

impl<T> Stars<'_, T> {
    /// Whether all are zero.
    pub fn vanish(&self) -> bool {
        self.0.iter().all(|(_, star)| star.vanishes())
    }

    /// The sum of a value of each times its star: exactly 0 where the star is. None where one has no value.
    pub fn sum(&self, value: impl Fn(&T) -> Option<Complex<f64>>) -> Option<Complex<f64>> {
        let product = |(one, star): &(&T, PhasorSum)| {
            let value = value(one)?;
            Some(if star.vanishes() { Complex::default() } else { value * numbers::evaluate(star) })
        };
        self.0.iter().map(product).sum()
    }
}

/// The orders of these classes and moving masses, from the first on.
pub fn orders(classes: &[Class], bodies: &[Bodies]) -> Vec<TorqueOrder> {
    let Some(first) = classes.first() else { return Vec::new() };
    let revolutions = first.harmonics.revolutions as usize;
    let order = |index: usize| {
        let order = CycleOrder::of_halves(u32::try_from(2 * index / revolutions).ok()?)?;
        let gas = Stars::each_once(classes, order);
        let inertia = Stars::of_inertia(bodies, order, |_| BigRational::one());
        Some(TorqueOrder {
            gas: gas.sum(|class| Some(class.harmonics.torque[index])).unwrap_or_default(),
            inertia: inertia.sum(|of| Some(of.inertia.as_ref()?.at(order)[0])),
            gas_vanishes: gas.vanish(),
            inertia_vanishes: !order.is_whole() || inertia.vanish(),
            stars: gas.0.into_iter().map(|(_, star)| star).collect(),
            order,
        })
    };
    (1..first.harmonics.torque.len()).filter_map(order).collect()
}

/// An order of the roll moment of these masses on the frame over ω², in kilograms times square metres: the opposite of their torque, and what
/// changes their angular momentum. None where it vanishes, proved, or no scale is known.
pub fn roll_of(bodies: &[Bodies], order: CycleOrder) -> Option<Complex<f64>> {
    let stars = Stars::of_inertia(bodies, order, |_| BigRational::one());
    let felt = |of: &Bodies| Some(of.inertia.as_ref()?.over_square(order).iter().sum());
    stars.sum(felt).filter(|_| !stars.vanish()).map(|moment: Complex<f64>| -moment)
}

/// An order of the roll moment of the gas on the frame, in newton-metres: the opposite of the torque on each crankshaft, in the sense in which
/// that turns. None where it vanishes, proved.
pub fn roll_of_gas(engine: &Engine, classes: &[Class], order: CycleOrder) -> Option<Complex<f64>> {
    let sense = |cylinder: usize| engine.sense_of(&engine.cylinders()[cylinder]).signed(-BigRational::one());
    let stars = Stars::of_gas(classes, order, sense);
    stars.sum(|class| Some(class.harmonics.torque_at(order))).filter(|_| !stars.vanish())
}
