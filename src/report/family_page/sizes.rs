//! How large is each order of a family, over its open angles? In floats, at the rod ratio of its rods or 2/7.

use std::f64::consts::TAU;

use num_complex::Complex;
use num_rational::BigRational;
use num_traits::{One, ToPrimitive};

use super::super::engine_page::assumed_ratio;
use crate::engine::{DELTA, Family, PHI, Rods};
use crate::family::{OpenOrder, OpenVerdict, phase};
use crate::motion::coefficients_fast;
use crate::numbers::float;
use crate::page::{Text, phrase};
use crate::proof::{Planar, Sense};

/// The fewest steps of the grid on which a largest value is looked for, in a turn of an unknown, and the most of one and of two unknowns, which are
/// quickly summed; how many steps there are while two vectors turn once against each other, and how finely it is looked for from the best ones.
const STEPS: i32 = 72;
const MOST_STEPS: [i32; 2] = [4000, 360];
const OF_A_TURN: f64 = 16.0;
const FINEST: f64 = 1e-7;
/// Between the points of such a grid a value is larger by less than this part of the largest.
const BETWEEN: f64 = 0.1;
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
        let ratio = known.cloned().unwrap_or_else(assumed_ratio);
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

    /// The largest for angles from 0° to 360°: from every point of a grid that may be near it, ever smaller steps.
    pub fn most(&self, quantity: Planar, order: u32) -> f64 {
        let unknowns = self.family.unknowns();
        let is_open = [PHI, DELTA].map(|unknown| unknowns.contains(unknown));
        let steps = self.steps(quantity, order, is_open);
        let size = self.size(quantity, order);
        let place = |[one, other]: [i32; 2]| {
            [(one, steps[0]), (other, steps[1])].map(|(step, of)| f64::from(step) / f64::from(of.max(1)))
        };
        // Both ends: where half of an angle enters they are two engines.
        let grid: Vec<[i32; 2]> =
            (0..=steps[0]).flat_map(|one| (0..=steps[1]).map(move |other| [one, other])).collect();
        let sizes: Vec<f64> = grid.iter().map(|at| size(place(*at))).collect();
        let largest = sizes.iter().copied().fold(0.0, f64::max);
        let at = |[one, other]: [i32; 2]| {
            let is_there = (0..=steps[0]).contains(&one) && (0..=steps[1]).contains(&other);
            is_there.then(|| sizes[(one * (steps[1] + 1) + other) as usize])
        };
        let is_top = |(at_step, value): &(&[i32; 2], &f64)| {
            let ([one, other], value) = (**at_step, **value);
            let around = [[one - 1, other], [one + 1, other], [one, other - 1], [one, other + 1]];
            value >= (1.0 - BETWEEN) * largest && around.into_iter().filter_map(at).all(|beside| value >= beside)
        };
        let tops = grid.iter().zip(&sizes).filter(is_top);
        let step = 1.0 / f64::from(steps[0].max(steps[1]).max(1));
        tops.map(|(top, _)| climbed(&size, place(*top), is_open, step)).fold(largest, f64::max)
    }

    /// How many steps of a grid each open angle has: none where it is known.
    fn steps(&self, quantity: Planar, order: u32, is_open: [bool; 2]) -> [i32; 2] {
        let terms = self.terms(quantity, order);
        let most = MOST_STEPS[usize::from(is_open == [true; 2])];
        [0, 1].map(|unknown| {
            // How often two vectors of a sum turn against each other.
            let apart = terms.iter().map(|vectors| {
                let times = || vectors.iter().map(|(times, _, _)| times[unknown]);
                times().fold(f64::NEG_INFINITY, f64::max) - times().fold(f64::INFINITY, f64::min)
            });
            let turns = apart.fold(0.0, f64::max);
            if is_open[unknown] { ((OF_A_TURN * turns).ceil() as i32).clamp(STEPS, most) } else { 0 }
        })
    }
}

/// What ever smaller steps come to from a place, within the range of the open angles.
fn climbed(size: &impl Fn([f64; 2]) -> f64, from: [f64; 2], is_open: [bool; 2], step: f64) -> f64 {
    let (mut best, mut step) = ((from, size(from)), step);
    while step > FINEST {
        let [one, other] = best.0;
        let around = [[one - step, other], [one + step, other], [one, other - step], [one, other + step]];
        let is_meant = |at: &[f64; 2]| {
            [0, 1].iter().all(|of| if is_open[*of] { (0.0..=1.0).contains(&at[*of]) } else { at[*of] == from[*of] })
        };
        let beside = around.into_iter().filter(is_meant).map(|at| (at, size(at)));
        match beside.max_by(|(_, one), (_, other)| one.total_cmp(other)) {
            Some(next) if next.1 > best.1 => best = next,
            _ => step /= 2.0,
        }
    }
    best.1
}
