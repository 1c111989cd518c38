//! How large is each order of a family, over its open angles? In floats, at the rod ratio of its rods or 2/7.

use std::f64::consts::TAU;

use num_complex::Complex;
use num_rational::BigRational;
use num_traits::{One, ToPrimitive};

use crate::engine::{DELTA, Family, PHI, Rods};
use crate::family::{OpenOrder, OpenVerdict, phase};
use crate::motion::coefficients_fast;
use crate::numbers::float;
use crate::page::{Text, phrase};
use crate::proof::{Planar, Sense};

/// λ of rods that are not given, as the drawings have it.
const USUAL: (i64, i64) = (2, 7);
/// The grid on which a largest value is looked for, in steps of a turn, and how finely it is then looked for. One unknown has eight points for each
/// turn of its fastest vector, up to as many as are quickly summed.
const STEPS: i32 = 72;
const MOST_STEPS: i32 = 2000;
const FINEST: f64 = 1e-7;
/// Orders below this part of the largest one are not drawn.
const ABOVE: f64 = 0.01;

/// How large a family is where its rods are centric and alike, or none is given.
pub(super) struct Sizes<'a> {
    family: &'a Family,
    ratio: BigRational,
    is_assumed: bool,
    coefficients: Vec<f64>,
}

/// The vectors of an order: multiples of φ and of δ, known angle in turns, weight.
type Terms = [Vec<([f64; 2], f64, f64)>; 2];

impl<'a> Sizes<'a> {
    /// None where the rods differ or their axes miss the crankshaft: no single coefficient tells the size of an order.
    pub fn new(family: &'a Family, highest: u32) -> Option<Self> {
        let known = match family.all_rods() {
            _ if family.faster_crank().is_some() => return None,
            Rods::Unknown => None,
            Rods::Alike(rod) if rod.is_centric() => Some(&rod.ratio),
            Rods::Alike(_) | Rods::Differ | Rods::Without(_) => return None,
        };
        let ratio = known.cloned().unwrap_or_else(|| BigRational::new(USUAL.0.into(), USUAL.1.into()));
        let coefficients = coefficients_fast(ratio.to_f64()?, highest);
        coefficients.iter().all(|number| number.is_finite()).then_some(())?;
        Some(Sizes { family, ratio, is_assumed: known.is_none(), coefficients })
    }

    /// `λ = 2/7 assumed`.
    pub fn circumstances(&self) -> Text {
        let words = if self.is_assumed { "λ = {} assumed" } else { "λ = {}" };
        phrase!(words, crate::page::number::number(&self.ratio))
    }

    /// |c_k|, 0 of an order that does not exist.
    pub fn coefficient(&self, order: u32) -> f64 {
        self.coefficients.get(order as usize).map_or(0.0, |number| number.abs())
    }

    /// The orders of a quantity that are at least a hundredth of the largest one, or of one piston's force, with the largest value of each over all angles, and the others.
    pub fn told(&self, quantity: Planar, orders: &[OpenOrder]) -> (Vec<(u32, f64)>, Vec<u32>) {
        let is_left = |order: &&OpenOrder| !order.verdicts(quantity).iter().all(OpenVerdict::always);
        let left = orders.iter().filter(is_left).map(|order| (order.order, self.most(quantity, order.order)));
        let left: Vec<(u32, f64)> = left.collect();
        // A force is beside that of one piston, too.
        let of_one = self.family.cylinders().iter().filter_map(|of| of.weight().to_f64()).fold(0.0, f64::max);
        let of_one = if quantity == Planar::Force { of_one } else { 0.0 };
        let largest = left.iter().map(|(_, size)| *size).fold(of_one, f64::max);
        let (told, small): (Vec<_>, Vec<_>) = left.into_iter().partition(|(_, size)| *size >= ABOVE * largest);
        (told, small.into_iter().map(|(order, _)| order).collect())
    }

    fn terms(&self, quantity: Planar, order: u32) -> Terms {
        Sense::BOTH.map(|sense| {
            let term = |cylinder: &_| {
                let phase = phase(cylinder, order, sense);
                let arm = self.family.arm(cylinder);
                let arm = arm.symbols().values().fold(arm.known().clone(), |sum, coefficient| sum + coefficient);
                let arm = if quantity == Planar::Moment { arm } else { BigRational::one() };
                let turns = [PHI, DELTA].map(|unknown| float(&phase.coefficient(unknown)));
                (turns, float(phase.known()), float(&(cylinder.weight() * arm)))
            };
            self.family.cylinders().iter().map(term).collect()
        })
    }

    /// The largest value of an order in a revolution, in m r ω² (times the unit of the arms), as a function of φ and δ in turns.
    pub fn size(&self, quantity: Planar, order: u32) -> impl Fn([f64; 2]) -> f64 + use<> {
        let (terms, coefficient) = (self.terms(quantity, order), self.coefficient(order));
        move |at| {
            let length = |terms: &Vec<([f64; 2], f64, f64)>| {
                let vector = |(times, known, weight): &([f64; 2], f64, f64)| {
                    Complex::from_polar(*weight, TAU * (known + times[0] * at[0] + times[1] * at[1]))
                };
                terms.iter().map(vector).sum::<Complex<f64>>().norm()
            };
            terms.iter().map(length).sum::<f64>() / 2.0 * coefficient
        }
    }

    /// The largest for angles from 0° to 360°: the best point of a grid, then ever smaller steps from it.
    pub fn most(&self, quantity: Planar, order: u32) -> f64 {
        let unknowns = self.family.unknowns();
        let is_open = [PHI, DELTA].map(|unknown| unknowns.contains(unknown));
        let count = match is_open {
            [true, true] => STEPS,
            _ => i32::try_from(8 * (order + 1)).unwrap_or(MOST_STEPS).clamp(STEPS, MOST_STEPS),
        };
        // Both ends: where half of an angle enters they are two engines.
        let steps = is_open.map(|is_open| if is_open { count } else { 0 });
        let size = self.size(quantity, order);
        let place = |step: i32| f64::from(step) / f64::from(count);
        let grid = (0..=steps[0]).flat_map(|one| (0..=steps[1]).map(move |other| [place(one), place(other)]));
        let Some(mut best) = grid.max_by(|one, other| size(*one).total_cmp(&size(*other))) else { return 0.0 };
        let mut step = 1.0 / f64::from(count);
        while step > FINEST {
            let [one, other] = best;
            let around = [[one - step, other], [one + step, other], [one, other - step], [one, other + step]];
            let is_meant = |at: &[f64; 2]| [0, 1].iter().all(|of| (0.0..=place(steps[*of])).contains(&at[*of]));
            match around.into_iter().filter(is_meant).max_by(|one, other| size(*one).total_cmp(&size(*other))) {
                Some(next) if size(next) > size(best) => best = next,
                _ => step /= 2.0,
            }
        }
        size(best)
    }
}
