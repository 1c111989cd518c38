//! What is each order of the torque, and which vanish whatever the pressure is?

use num_complex::Complex;
use num_rational::BigRational;
use num_traits::One;

use super::class::Class;
use crate::engine::CycleOrder;
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
    /// Whether that of the inertia is zero, proved: its stars `Σ m_j e^{−iκφ_j}` are, one for all cylinders of one crank and rod.
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

/// The stars of an order of a kind of force, each cylinder weighed: `Σ w_j e^{−iκφ_j}`.
pub(super) struct Stars<'a>(Vec<(&'a Class, PhasorSum)>);

impl<'a> Stars<'a> {
    /// Those of the gas, one a class; a weight by the class and the place of the cylinder in it.
    pub fn of_gas(classes: &'a [Class], order: CycleOrder, weight: impl Fn(&Class, usize) -> BigRational) -> Self {
        let star = |class: &Class| {
            let term = |(place, fires)| Term { angle: order.phase(fires), weight: weight(class, place) };
            PhasorSum::new(class.fires.iter().enumerate().map(term).collect())
        };
        Stars(classes.iter().map(|class| (class, star(class))).collect())
    }

    /// Those of the gas, each cylinder with the weight 1.
    pub fn each_once(classes: &'a [Class], order: CycleOrder) -> Self {
        Stars::of_gas(classes, order, |_, _| BigRational::one())
    }

    /// Those of the inertia, one for all classes that move alike: each cylinder is weighed by its mass as well.
    pub fn of_inertia(classes: &'a [Class], order: CycleOrder, weight: impl Fn(&Class, usize) -> BigRational) -> Self {
        let heavy = Stars::of_gas(classes, order, |class, place| weight(class, place) * &class.masses[place]);
        let moving = classes.iter().enumerate().filter(|(first, class)| class.same_motion == *first);
        let star = |first: usize| {
            let alike = heavy.0.iter().filter(|(class, _)| class.same_motion == first);
            alike.fold(PhasorSum::new(Vec::new()), |sum, (_, star)| sum.plus(star))
        };
        Stars(moving.map(|(first, class)| (class, star(first))).collect())
    }

    /// Whether all are zero.
    pub fn vanish(&self) -> bool {
        self.0.iter().all(|(_, star)| star.vanishes())
    }

    /// The sum of a value of each class times its star: exactly 0 where the star is. None where a class has no value.
    pub fn sum(&self, value: impl Fn(&Class) -> Option<Complex<f64>>) -> Option<Complex<f64>> {
        let product = |(class, star): &(&Class, PhasorSum)| {
            let value = value(class)?;
            Some(if star.vanishes() { Complex::default() } else { value * numbers::evaluate(star) })
        };
        self.0.iter().map(product).sum()
    }
}

/// The orders of these classes, from the first on.
pub fn orders(classes: &[Class]) -> Vec<TorqueOrder> {
    let Some(first) = classes.first() else { return Vec::new() };
    let revolutions = first.harmonics.revolutions;
    (1..first.harmonics.torque.len()).filter_map(|index| order(classes, index, revolutions as usize)).collect()
}

fn order(classes: &[Class], index: usize, revolutions: usize) -> Option<TorqueOrder> {
    let order = CycleOrder::of_halves(u32::try_from(2 * index / revolutions).ok()?)?;
    let gas = Stars::each_once(classes, order);
    let inertia = Stars::of_inertia(classes, order, |_, _| BigRational::one());
    Some(TorqueOrder {
        gas: gas.sum(|class| Some(class.harmonics.torque[index])).unwrap_or_default(),
        inertia: inertia.sum(|class| class.inertia_at(index, revolutions)),
        gas_vanishes: gas.vanish(),
        inertia_vanishes: !order.is_whole() || inertia.vanish(),
        stars: gas.0.into_iter().map(|(_, star)| star).collect(),
        order,
    })
}

impl Class {
    /// Order κ of the torque of the cylinder at this place of the class, by its own angle: gas, and inertia where that is known.
    pub fn torque_of_one(&self, place: usize, order: CycleOrder) -> Complex<f64> {
        let [gas, inertia] = self.torques_of_one(place, order);
        gas + inertia
    }

    /// The same, gas and inertia each by itself.
    pub fn torques_of_one(&self, place: usize, order: CycleOrder) -> [Complex<f64>; 2] {
        let revolutions = self.harmonics.revolutions as usize;
        let index = order.halves() as usize * revolutions / 2;
        let gas = self.harmonics.torque.get(index).copied().unwrap_or_default();
        [gas, self.inertia_at(index, revolutions).unwrap_or_default() * numbers::float(&self.masses[place])]
    }

    /// The inertia's harmonic at the n-th of the cycle, of a mass of 1: zero at halves.
    pub(super) fn inertia_at(&self, index: usize, revolutions: usize) -> Option<Complex<f64>> {
        let inertia = self.inertia.as_ref()?;
        Some(match index % revolutions {
            0 => inertia.harmonics.get(index / revolutions - 1).copied().unwrap_or_default(),
            _ => Complex::new(0.0, 0.0),
        })
    }
}
