//! What is each order of the torque, and which vanish whatever the pressure is?

use num_complex::Complex;
use num_rational::BigRational;

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
    /// Whether that of the inertia is zero, proved: its stars are, with those of cylinders that only the gas tells apart as one.
    pub inertia_vanishes: bool,
    /// The exact stars `Σ e^{−iκφ_j}`, one a class of equal cylinders.
    pub stars: Vec<PhasorSum>,
    /// Whether every star is zero: then the order is, proved, for every pressure that the cylinders of a class share.
    pub vanishes: bool,
}

impl TorqueOrder {
    /// Gas and inertia together: their phasors add.
    pub fn total(&self) -> Complex<f64> {
        self.gas + self.inertia.unwrap_or_default()
    }
}

/// The stars of an order, each cylinder weighed: `Σ w_j e^{−iκφ_j}`.
pub(super) fn star(class: &Class, order: CycleOrder, weight: impl Fn(usize) -> BigRational) -> PhasorSum {
    let terms = class.cylinders.iter().zip(&class.fires);
    PhasorSum::new(terms.map(|(&index, fires)| Term { angle: order.phase(fires), weight: weight(index) }).collect())
}

/// The orders of these classes, from the first on.
pub fn orders(classes: &[Class]) -> Vec<TorqueOrder> {
    let Some(first) = classes.first() else { return Vec::new() };
    let revolutions = first.harmonics.revolutions;
    (1..first.harmonics.torque.len()).filter_map(|index| order(classes, index, revolutions as usize)).collect()
}

fn order(classes: &[Class], index: usize, revolutions: usize) -> Option<TorqueOrder> {
    let order = CycleOrder::of_halves(u32::try_from(2 * index / revolutions).ok()?)?;
    let one = BigRational::from_integer(1.into());
    let stars: Vec<PhasorSum> = classes.iter().map(|class| star(class, order, |_| one.clone())).collect();
    // Stars of equal inertia are added before they are judged.
    let moving: Vec<(&Class, PhasorSum)> = (0..classes.len())
        .filter(|&first| classes[first].same_inertia == first)
        .map(|first| {
            let alike = classes.iter().zip(&stars).filter(|(class, _)| class.same_inertia == first);
            (&classes[first], alike.fold(PhasorSum::new(Vec::new()), |sum, (_, star)| sum.plus(star)))
        })
        .collect();
    let inertia =
        moving.iter().map(|(class, star)| Some(class.inertia_at(index, revolutions)? * numbers::evaluate(star))).sum();
    let gas =
        classes.iter().zip(&stars).map(|(class, star)| class.harmonics.torque[index] * numbers::evaluate(star)).sum();
    Some(TorqueOrder {
        gas,
        inertia,
        inertia_vanishes: !order.is_whole() || moving.iter().all(|(_, star)| star.vanishes()),
        vanishes: stars.iter().all(PhasorSum::vanishes),
        order,
        stars,
    })
}

impl Class {
    /// Order κ of the torque of one of its cylinders, by its own angle: gas, and inertia where that is known.
    pub fn torque_of_one(&self, order: CycleOrder) -> Complex<f64> {
        let revolutions = self.harmonics.revolutions as usize;
        let index = order.halves() as usize * revolutions / 2;
        let gas = self.harmonics.torque.get(index).copied().unwrap_or_default();
        gas + self.inertia_at(index, revolutions).unwrap_or_default()
    }

    /// The inertia's harmonic at the n-th of the cycle: zero at halves.
    pub(super) fn inertia_at(&self, index: usize, revolutions: usize) -> Option<Complex<f64>> {
        let inertia = self.inertia.as_ref()?;
        Some(match index % revolutions {
            0 => inertia.harmonics.get(index / revolutions - 1).copied().unwrap_or_default(),
            _ => Complex::new(0.0, 0.0),
        })
    }
}
