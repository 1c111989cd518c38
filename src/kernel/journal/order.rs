//! What is each order of a load, and which vanish whatever the pressure is?
//!
//! Order κ of the gas of a class turns with the crank as `−½ (f_κ − i h_κ) Σ ρ_j e^{i(α_j − κφ_j)}` and against it as
//! `−½ (f_κ* − i h_κ*) Σ ρ_j e^{i(α_j + κφ_j)}`, f and h the harmonics of force and side force, ρ_j the parts that are carried: exact stars
//! (theory, section 12).

use std::f64::consts::TAU;

use num_complex::Complex;
use num_rational::BigRational;

use super::force_history::ForceHistory;
use crate::engine::{CycleOrder, Engine};
use crate::exact::{PhasorSum, Term, Turn};
use crate::gas::points_short;
use crate::loads::Swing;
use crate::numbers;
use crate::proof::Sense;
use crate::torque::{self, Class};

/// One order of a load: `direct · e^{iκθ} + reverse · e^{−iκθ}`, in newtons.
#[derive(Clone, Debug)]
pub struct JournalOrder {
    /// The order κ: a half, or whole.
    pub order: CycleOrder,
    /// Both vectors of the gas.
    pub gas: [Complex<f64>; 2],
    /// Both vectors of the masses: zero at halves.
    pub inertia: [Complex<f64>; 2],
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

/// A load by orders of the cycle.
#[derive(Clone, Debug)]
pub struct Series {
    /// The force that stays.
    pub mean: CycleMean,
    /// The orders, rising, up to [`HIGHEST`](crate::torque::HIGHEST); halves in a four-stroke engine.
    pub orders: Vec<JournalOrder>,
}

impl Series {
    /// The sum of mean and orders at a crank angle.
    pub fn at(&self, theta: f64) -> Complex<f64> {
        self.orders.iter().fold(self.mean.total(), |sum, order| sum + order.at(theta))
    }
}

impl CycleMean {
    /// Gas and masses together.
    pub fn total(&self) -> Complex<f64> {
        if self.vanishes { Complex::default() } else { self.gas + self.inertia }
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

/// Equal cylinders whose gas loads their crankpins alike: those of a class on crankshafts that turn the same way.
pub(super) struct HandedOn {
    /// Which cylinders, by index, and where each fires in turns of the cycle.
    cylinders: Vec<(usize, BigRational)>,
    /// For each order, twice what turns with the crank and against it, towards the crank in the frame of the axis; once for the mean.
    vectors: Vec<[Complex<f64>; 2]>,
    revolutions: u32,
}

/// What the gas of each cylinder hands on to its crankpin, by orders.
pub(super) fn handed_on(engine: &Engine, course: &ForceHistory) -> Vec<HandedOn> {
    let mut all = Vec::new();
    for class in course.classes() {
        for sense in Sense::BOTH {
            let known = class.cylinders.iter().copied().zip(class.fires.iter().cloned());
            let of_sense = |(index, _): &(usize, BigRational)| engine.sense_of(&engine.cylinders()[*index]) == sense;
            let cylinders: Vec<(usize, BigRational)> = known.filter(of_sense).collect();
            let Some((first, fires)) = cylinders.first() else { continue };
            let vectors = match engine.cylinders()[*first].link() {
                Some(_) => by_forces(course, class, *first, numbers::float(fires)),
                None => by_harmonics(class, sense),
            };
            all.push(HandedOn { cylinders, vectors, revolutions: class.harmonics.revolutions });
        }
    }
    all
}

/// From the harmonics of force and side force; of a crank that turns against the reference the side force has the other sign.
fn by_harmonics(class: &Class, sense: Sense) -> Vec<[Complex<f64>; 2]> {
    let sign = sense.signed(1.0);
    let both = class.harmonics.force.iter().zip(&class.harmonics.side);
    let vectors = |(force, side): (&Complex<f64>, &Complex<f64>)| {
        [(*force, *side), (force.conj(), side.conj())].map(|(force, side)| force - quarter_turned(side) * sign)
    };
    both.map(vectors).collect()
}

/// From the forces themselves: what a link hands on by its master rod has no harmonics of its own. Between kinks, and half degrees, all is smooth.
fn by_forces(course: &ForceHistory, class: &Class, index: usize, fires: f64) -> Vec<[Complex<f64>; 2]> {
    let (period, start) = (course.period(), fires * TAU);
    let axis = course.axis(index);
    let mut grid = torque::angles_with(course.kinks(), period);
    grid.extend(grid.first().map(|first| first + period));
    let mut vectors = vec![[Complex::default(); 2]; class.harmonics.force.len()];
    for (theta, weight) in grid.windows(2).flat_map(|ends| points_short(ends[0], ends[1])) {
        let [_, gas] = course.pin_parts(index, theta);
        let part = -gas * axis.conj() * (2.0 * weight / period);
        let step = Complex::cis((start - theta) * TAU / period);
        let mut turned = Complex::new(1.0, 0.0);
        for both in &mut vectors {
            both[0] += part * turned;
            both[1] += part * turned.conj();
            turned *= step;
        }
    }
    vectors.iter_mut().take(1).flatten().for_each(|mean| *mean /= 2.0);
    vectors
}

/// The series of a load that carries these parts of the pins, with what the masses add.
pub(super) fn series<'a>(
    engine: &Engine,
    classes: &[HandedOn],
    part: impl Fn(usize) -> BigRational,
    inertia: impl Iterator<Item = (u32, &'a Swing)>,
    newtons: f64,
) -> Series {
    let known: Vec<(u32, &Swing)> = inertia.collect();
    let swing = |order: u32| known.iter().find(|(k, _)| *k == order).map(|(_, swing)| *swing);
    let vectors =
        |order: u32| swing(order).map_or_else(Default::default, |swing| swing.amplitudes().map(|one| one * newtons));
    let vanishes = |order: u32| swing(order).is_none_or(Swing::vanishes);
    let revolutions = classes.first().map_or(1, |class| class.revolutions);
    let count = classes.first().map_or(0, |class| class.vectors.len());
    let mean = {
        let stars: Vec<PhasorSum> = classes.iter().map(|class| star(engine, class, &part, |_| Turn::zero())).collect();
        let gas = classes.iter().zip(&stars).map(|(class, star)| -class.vectors[0][0] * numbers::evaluate(star)).sum();
        let [direct, reverse]: [Complex<f64>; 2] = vectors(0);
        CycleMean { gas, inertia: direct + reverse, vanishes: vanishes(0) && stars.iter().all(PhasorSum::vanishes) }
    };
    let order = |index: usize| {
        let order = CycleOrder::of_halves(u32::try_from(2 * index).ok()? / revolutions)?;
        let turned = |class: &HandedOn, sense: Sense| {
            star(engine, class, &part, |fires| match sense {
                Sense::Direct => order.phase(fires),
                Sense::Reverse => order.times(fires),
            })
        };
        // `Σ ρ_j e^{i(α_j − κφ_j)}` of each class, and `Σ ρ_j e^{i(α_j + κφ_j)}`.
        let stars: Vec<[PhasorSum; 2]> =
            classes.iter().map(|class| Sense::BOTH.map(|sense| turned(class, sense))).collect();
        let gas = [0, 1].map(|way: usize| {
            let part = |(class, stars): (&HandedOn, &[PhasorSum; 2])| {
                -class.vectors[index][way] / 2.0 * numbers::evaluate(&stars[way])
            };
            classes.iter().zip(&stars).map(part).sum()
        });
        let whole = order.is_whole().then(|| order.halves() / 2);
        Some(JournalOrder {
            gas,
            inertia: whole.map_or_else(Default::default, vectors),
            gas_vanishes: stars.iter().flatten().all(PhasorSum::vanishes),
            inertia_vanishes: whole.is_none_or(vanishes),
            order,
        })
    };
    Series { mean, orders: (1..count).filter_map(order).collect() }
}

/// A vector times i.
fn quarter_turned(vector: Complex<f64>) -> Complex<f64> {
    Complex::new(-vector.im, vector.re)
}

/// The parts of a class along the axes of its cylinders, each turned.
fn star(
    engine: &Engine,
    class: &HandedOn,
    part: impl Fn(usize) -> BigRational,
    turned: impl Fn(&BigRational) -> Turn,
) -> PhasorSum {
    let term = |(index, fires): &(usize, BigRational)| Term {
        angle: &engine.cylinders()[*index].bank + &turned(fires),
        weight: part(*index),
    };
    PhasorSum::new(class.cylinders.iter().map(term).collect())
}
