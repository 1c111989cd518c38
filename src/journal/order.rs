//! What is each order of a load, and which vanish whatever the pressure is?
//!
//! Order κ of the gas of a class turns with the crank as `−½ (f_κ − i h_κ) Σ ρ_j e^{i(α_j − κφ_j)}` and against it as
//! `−½ (f_κ* − i h_κ*) Σ ρ_j e^{i(α_j + κφ_j)}`, f and h the harmonics of force and side force, ρ_j the parts that are carried: exact stars
//! (theory, section 12).

use num_complex::Complex;
use num_rational::BigRational;

use super::Series;
use crate::engine::{CycleOrder, Engine};
use crate::exact::{PhasorSum, Term, Turn};
use crate::loads::Swing;
use crate::numbers;
use crate::proof::Sense;
use crate::torque::Class;

/// The stars of one class of equal cylinders: what turns with the crank, and against it.
#[derive(Clone, Debug)]
pub struct GasStars {
    /// `Σ ρ_j e^{i(α_j − κφ_j)}`.
    pub direct: PhasorSum,
    /// `Σ ρ_j e^{i(α_j + κφ_j)}`.
    pub reverse: PhasorSum,
}

/// One order of a load: `direct · e^{iκθ} + reverse · e^{−iκθ}`, in newtons.
#[derive(Clone, Debug)]
pub struct JournalOrder {
    /// The order κ: a half, or whole.
    pub order: CycleOrder,
    /// Both vectors of the gas.
    pub gas: [Complex<f64>; 2],
    /// Both vectors of the masses: zero at halves.
    pub inertia: [Complex<f64>; 2],
    /// The exact stars of the gas, one pair a class of equal cylinders.
    pub stars: Vec<GasStars>,
    /// Whether the gas leaves nothing of it, proved, for every pressure that the cylinders of a class share.
    pub gas_vanishes: bool,
    /// Whether the masses leave nothing of it, proved.
    pub inertia_vanishes: bool,
}

/// The force that stays, in newtons.
#[derive(Clone, Debug)]
pub struct CycleMean {
    /// Of the gas.
    pub gas: Complex<f64>,
    /// Of the masses: that of pistons whose axis misses the crankshaft.
    pub inertia: Complex<f64>,
    /// Whether both vanish, proved, for every pressure that the cylinders of a class share.
    pub vanishes: bool,
}

impl CycleMean {
    /// Gas and masses together.
    pub fn total(&self) -> Complex<f64> {
        self.gas + self.inertia
    }
}

impl JournalOrder {
    /// Gas and masses together: their vectors add.
    pub fn total(&self) -> [Complex<f64>; 2] {
        [0, 1].map(|sense| self.gas[sense] + self.inertia[sense])
    }

    /// Whether nothing is left of it, proved.
    pub fn vanishes(&self) -> bool {
        self.gas_vanishes && self.inertia_vanishes
    }

    /// The largest value in a cycle.
    pub fn largest(&self) -> f64 {
        self.total().iter().map(|vector| vector.norm()).sum()
    }

    /// Its value at a crank angle.
    pub fn at(&self, theta: f64) -> Complex<f64> {
        let turning = Complex::cis(self.order.value() * theta);
        let [direct, reverse] = self.total();
        direct * turning + reverse * turning.conj()
    }
}

/// The series of a load that carries these parts of the pins, with what the masses add.
pub(super) fn series<'a>(
    engine: &Engine,
    classes: &[Class],
    part: impl Fn(usize) -> BigRational,
    inertia: impl Iterator<Item = (u32, &'a Swing)>,
    newtons: f64,
) -> Series {
    let known: Vec<(u32, &Swing)> = inertia.collect();
    let swing = |order: u32| known.iter().find(|(k, _)| *k == order).map(|(_, swing)| *swing);
    let vectors =
        |order: u32| swing(order).map_or_else(Default::default, |swing| swing.amplitudes().map(|one| one * newtons));
    let vanishes = |order: u32| swing(order).is_none_or(Swing::vanishes);
    let revolutions = classes.first().map_or(1, |class| class.harmonics.revolutions);
    let count = classes.first().map_or(0, |class| class.harmonics.force.len());
    let mean = {
        let stars: Vec<PhasorSum> = classes.iter().map(|class| star(engine, class, &part, |_| Turn::zero())).collect();
        let gas = classes.iter().zip(&stars).map(|(class, star)| -pushed(class, 0) * numbers::evaluate(star)).sum();
        let [direct, reverse]: [Complex<f64>; 2] = vectors(0);
        CycleMean { gas, inertia: direct + reverse, vanishes: vanishes(0) && stars.iter().all(PhasorSum::vanishes) }
    };
    let order = |index: usize| {
        let order = CycleOrder::of_halves(u32::try_from(2 * index).ok()? / revolutions)?;
        let turned = |class: &Class, sense: Sense| {
            star(engine, class, &part, |fires| match sense {
                Sense::Direct => order.phase(fires),
                Sense::Reverse => order.times(fires),
            })
        };
        let stars: Vec<GasStars> = classes
            .iter()
            .map(|class| GasStars { direct: turned(class, Sense::Direct), reverse: turned(class, Sense::Reverse) })
            .collect();
        let with = |value: &dyn Fn(&Class, &GasStars) -> Complex<f64>| {
            classes.iter().zip(&stars).map(|(class, stars)| value(class, stars)).sum()
        };
        let whole = order.is_whole().then(|| order.halves() / 2);
        Some(JournalOrder {
            gas: [
                with(&|class, stars| -pushed(class, index) / 2.0 * numbers::evaluate(&stars.direct)),
                with(&|class, stars| -pulled(class, index) / 2.0 * numbers::evaluate(&stars.reverse)),
            ],
            inertia: whole.map_or_else(Default::default, vectors),
            gas_vanishes: stars.iter().all(|stars| stars.direct.vanishes() && stars.reverse.vanishes()),
            inertia_vanishes: whole.is_none_or(vanishes),
            stars,
            order,
        })
    };
    Series { mean, orders: (1..count).filter_map(order).collect() }
}

/// `f_κ − i h_κ`.
fn pushed(class: &Class, index: usize) -> Complex<f64> {
    class.harmonics.force[index] - quarter_turned(class.harmonics.side[index])
}

/// `f_κ* − i h_κ*`.
fn pulled(class: &Class, index: usize) -> Complex<f64> {
    class.harmonics.force[index].conj() - quarter_turned(class.harmonics.side[index].conj())
}

/// A vector times i.
fn quarter_turned(vector: Complex<f64>) -> Complex<f64> {
    Complex::new(-vector.im, vector.re)
}

/// The parts of a class along the axes of its cylinders, each turned.
fn star(
    engine: &Engine,
    class: &Class,
    part: impl Fn(usize) -> BigRational,
    turned: impl Fn(&BigRational) -> Turn,
) -> PhasorSum {
    let term = |(&index, fires): (&usize, &BigRational)| Term {
        angle: &engine.cylinders()[index].bank + &turned(fires),
        weight: part(index),
    };
    PhasorSum::new(class.cylinders.iter().zip(&class.fires).map(term).collect())
}
