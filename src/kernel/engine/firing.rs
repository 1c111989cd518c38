//! When do the cylinders fire, and how evenly? Exact intervals from throws, banks and the firing order.
//!
//! A cylinder fires at a top dead centre of its own, so `τ_i ≡ (α_i − β_i) − (α_1 − β_1)` modulo a revolution:
//! who fires later has the throw further behind (theory, section 1).

use num_rational::BigRational;
use num_traits::{One, ToPrimitive, Zero};

use super::cycle::Cycle;
use super::cylinder::{Cylinder, firing_pistons};
use crate::exact::fraction;
use crate::text::counted;

/// One firing of the cycle.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Shot {
    /// Which cylinder, counted from 0.
    pub cylinder: usize,
    /// Crank angle after the first cylinder of the firing order, in turns, within the cycle.
    pub angle: BigRational,
}

/// The firings of one cycle, in the order in which they happen.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Firing {
    /// Two-stroke or four-stroke.
    pub cycle: Cycle,
    /// One firing a cylinder, angles rising from 0.
    pub shots: Vec<Shot>,
    /// The revolution of the cycle in which the first of them fires, from 0: 1 where the angles that are given say so.
    pub first_revolution: BigRational,
}

/// What is wrong with so many firing angles, and what would be right.
pub fn not_one_each(angles: usize, cylinders: usize) -> (String, String) {
    let message = format!("{} for {}", counted(angles, "firing angle"), counted(cylinders, "cylinder"));
    (message, "one per cylinder, in the order of the cylinders".to_owned())
}

impl Firing {
    /// The first major order: as high as the engine fires often in a revolution, up to the next whole one.
    pub fn first_major_order(&self) -> u32 {
        let in_a_turn = BigRational::from_integer(self.shots.len().into()) / self.cycle.turns();
        in_a_turn.ceil().to_integer().to_u32().unwrap_or(0)
    }

    /// Crank angle from each firing to the next, in turns, the last back to the first.
    pub fn intervals(&self) -> Vec<BigRational> {
        let next = self.shots.iter().skip(1).map(|shot| shot.angle.clone()).chain([self.cycle.turns()]);
        self.shots.iter().zip(next).map(|(shot, next)| next - &shot.angle).collect()
    }

    /// Whether all intervals are equal.
    pub fn is_even(&self) -> bool {
        self.intervals().windows(2).all(|pair| pair[0] == pair[1])
    }

    /// A two-stroke engine fires at every top dead centre; where two pistons share a cylinder, at that of the first.
    pub fn two_stroke(cylinders: &[Cylinder]) -> Self {
        let fired = firing_pistons(cylinders).into_iter();
        Firing::sorted(fired.map(|index| (index, top_dead_centre(cylinders, index, 0))).collect(), Cycle::TwoStroke)
    }

    /// The firings that a firing order and the throws leave; the error says what is wrong, and what would be right.
    pub fn from_order(order: &[usize], cycle: Cycle, cylinders: &[Cylinder]) -> Result<Self, (String, String)> {
        let mut shots = Vec::with_capacity(order.len());
        let mut angle = BigRational::zero();
        for (position, &cylinder) in order.iter().enumerate() {
            shots.push(Shot { cylinder, angle: angle.clone() });
            let next = order[(position + 1) % order.len()];
            let step = top_dead_centre(cylinders, next, cylinder);
            angle += if step.is_zero() { BigRational::one() } else { step };
        }
        if order.len() == 1 {
            angle = cycle.turns();
        }
        if angle == cycle.turns() {
            return Ok(Firing { cycle, shots, first_revolution: BigRational::zero() });
        }
        let names: Vec<&str> = order.iter().map(|&index| cylinders[index].name.as_str()).collect();
        let needed = degrees(&angle);
        let cycle_degrees = degrees(&cycle.turns());
        Err(if angle < cycle.turns() {
            let angles = format!("give firing_angles instead: degrees within {cycle_degrees}, one per cylinder");
            let right = match every_second(cylinders) {
                Some(usual) => {
                    format!("a row of a radial engine fires every second cylinder, {}; or {angles}", usual.join("-"))
                }
                None => angles,
            };
            (format!("the order {} does not say which interval is a revolution longer", names.join("-")), right)
        } else {
            (
                format!("these throws need {needed}° to fire in the order {}", names.join("-")),
                format!("the cycle has {cycle_degrees}°; a cylinder that fires later has its throw behind"),
            )
        })
    }

    /// The firings at given crank angles, one per cylinder.
    pub fn from_angles(angles: &[BigRational], cycle: Cycle, cylinders: &[Cylinder]) -> Result<Self, (String, String)> {
        let fired = firing_pistons(cylinders);
        if angles.len() != fired.len() {
            return Err(not_one_each(angles.len(), fired.len()));
        }
        let first = &angles[0];
        let revolutions = cycle.turns();
        let within_cycle = |angle: &BigRational| angle - (angle / &revolutions).floor() * &revolutions;
        // Angles that count as the throws are drawn say in which revolution the first cylinder fires too.
        let revolution = fired.first().map(|&index| first - cylinders[index].top_dead_centre().turns());
        let first_revolution =
            revolution.filter(BigRational::is_integer).map_or_else(BigRational::zero, |turns| within_cycle(&turns));
        let mut within = Vec::with_capacity(angles.len());
        for (index, angle) in fired.into_iter().zip(angles) {
            let angle = angle - first;
            let right = top_dead_centre(cylinders, index, 0);
            if !(&angle - &right).is_integer() {
                let name = &cylinders[index].name;
                let message = format!("cylinder {name} cannot fire {}° after the first", degrees(&angle));
                return Err((message, format!("it reaches top dead centre at {}°, and every 360°", degrees(&right))));
            }
            within.push((index, within_cycle(&angle)));
        }
        Ok(Firing { first_revolution, ..Firing::sorted(within, cycle) })
    }

    fn sorted(angles: Vec<(usize, BigRational)>, cycle: Cycle) -> Self {
        let shot = |(cylinder, angle)| Shot { cylinder, angle };
        let mut shots: Vec<Shot> = angles.into_iter().map(shot).collect();
        shots.sort_by(|a, b| (&a.angle, a.cylinder).cmp(&(&b.angle, b.cylinder)));
        Firing { cycle, shots, first_revolution: BigRational::zero() }
    }
}

/// Crank angle from a top dead centre of cylinder `from` to the next one of cylinder `to`, in `[0, 1)`.
fn top_dead_centre(cylinders: &[Cylinder], to: usize, from: usize) -> BigRational {
    (&cylinders[to].top_dead_centre() - &cylinders[from].top_dead_centre()).turns().clone()
}

/// Turns in degrees, not reduced, for a message.
pub(super) fn degrees(turns: &BigRational) -> String {
    fraction::written(&(turns * BigRational::from_integer(360.into())), fraction::MOST_PLACES)
}

/// The order of an odd number of cylinders on one crankpin that fire every second one, by their names; none of other engines.
fn every_second(cylinders: &[Cylinder]) -> Option<Vec<&str>> {
    let first = cylinders.first()?;
    let is_row = cylinders.len() > 1 && cylinders.len() % 2 == 1;
    let is_on_one_pin = |one: &Cylinder| (&one.throw, &one.position) == (&first.throw, &first.position);
    let places = 0..cylinders.len();
    (is_row && cylinders.iter().all(is_on_one_pin))
        .then(|| places.map(|place| cylinders[2 * place % cylinders.len()].name.as_str()).collect())
}
