//! When do the cylinders fire, and how evenly? Exact intervals from throws, banks and the firing order.
//!
//! A cylinder fires at a top dead centre of its own, so `τ_i ≡ (α_i − β_i) − (α_1 − β_1)` modulo a revolution:
//! who fires later has the throw further behind (theory, section 1).

use std::ops::Range;

use num_rational::BigRational;
use num_traits::{One, Zero};
use serde::Deserialize;
use serde::de::{Deserializer, Error, SeqAccess, Visitor};

use super::engine::Cylinder;
use super::error::LayoutError;
use super::forms::MOST_CYLINDERS;
use super::written::Written;
use crate::exact::Turn;

/// How many revolutions it takes until a cylinder fires again.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Cycle {
    /// One revolution.
    TwoStroke,
    /// Two revolutions.
    FourStroke,
}

impl Cycle {
    /// Length of the cycle in turns of the crank.
    pub fn turns(self) -> BigRational {
        BigRational::from_integer(match self {
            Cycle::TwoStroke => 1.into(),
            Cycle::FourStroke => 2.into(),
        })
    }
}

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
}

impl Firing {
    /// Crank angle from each firing to the next, in turns, the last back to the first.
    pub fn intervals(&self) -> Vec<BigRational> {
        let next = self.shots.iter().skip(1).map(|shot| shot.angle.clone()).chain([self.cycle.turns()]);
        self.shots.iter().zip(next).map(|(shot, next)| next - &shot.angle).collect()
    }

    /// Whether all intervals are equal.
    pub fn is_even(&self) -> bool {
        self.intervals().windows(2).all(|pair| pair[0] == pair[1])
    }

    /// A two-stroke engine fires at every top dead centre.
    pub(super) fn two_stroke(cylinders: &[Cylinder]) -> Self {
        let angles = (0..cylinders.len()).map(|index| top_dead_centre(cylinders, index, 0)).collect();
        Firing::sorted(angles, Cycle::TwoStroke)
    }

    /// The firings that a firing order and the throws leave; the error says what is wrong, and what would be right.
    pub(super) fn from_order(order: &[usize], cycle: Cycle, cylinders: &[Cylinder]) -> Result<Self, (String, String)> {
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
            return Ok(Firing { cycle, shots });
        }
        let names: Vec<&str> = order.iter().map(|&index| cylinders[index].name.as_str()).collect();
        let needed = degrees(&angle);
        let cycle_degrees = degrees(&cycle.turns());
        Err(if angle < cycle.turns() {
            (
                format!("the order {} does not say which interval is a revolution longer", names.join("-")),
                format!("give firing_angles instead: degrees within {cycle_degrees}, one a cylinder"),
            )
        } else {
            (
                format!("these throws need {needed}° to fire in the order {}", names.join("-")),
                format!("the cycle has {cycle_degrees}°; a cylinder that fires later has its throw behind"),
            )
        })
    }

    /// The firings at given crank angles, one a cylinder.
    pub(super) fn from_angles(
        angles: &[BigRational],
        cycle: Cycle,
        cylinders: &[Cylinder],
    ) -> Result<Self, (String, String)> {
        if angles.len() != cylinders.len() {
            let message = format!("{} firing angles for {} cylinders", angles.len(), cylinders.len());
            return Err((message, "one a cylinder, in the order of the cylinders".into()));
        }
        let first = &angles[0];
        let revolutions = cycle.turns();
        let mut within = Vec::with_capacity(angles.len());
        for (index, angle) in angles.iter().enumerate() {
            let angle = angle - first;
            let right = top_dead_centre(cylinders, index, 0);
            if !(&angle - &right).is_integer() {
                let name = &cylinders[index].name;
                let message = format!("cylinder {name} cannot fire {}° after the first", degrees(&angle));
                return Err((message, format!("it reaches top dead centre at {}°, and every 360°", degrees(&right))));
            }
            within.push(&angle - (&angle / &revolutions).floor() * &revolutions);
        }
        Ok(Firing::sorted(within, cycle))
    }

    fn sorted(angles: Vec<BigRational>, cycle: Cycle) -> Self {
        let shot = |(cylinder, angle)| Shot { cylinder, angle };
        let mut shots: Vec<Shot> = angles.into_iter().enumerate().map(shot).collect();
        shots.sort_by(|a, b| (&a.angle, a.cylinder).cmp(&(&b.angle, b.cylinder)));
        Firing { cycle, shots }
    }
}

/// Crank angle from a top dead centre of cylinder `from` to the next one of cylinder `to`, in `[0, 1)`.
fn top_dead_centre(cylinders: &[Cylinder], to: usize, from: usize) -> BigRational {
    (&cylinders[to].top_dead_centre() - &cylinders[from].top_dead_centre()).turns().clone()
}

fn degrees(turns: &BigRational) -> BigRational {
    turns * BigRational::from_integer(360.into())
}

/// A firing order as written: `"1-3-4-2"` or `[1, 3, 4, 2]`.
pub(super) struct Order(Vec<String>);

impl<'de> Deserialize<'de> for Order {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        struct Names;
        impl<'de> Visitor<'de> for Names {
            type Value = Order;
            fn expecting(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
                f.write_str("a firing order such as \"1-3-4-2\" or [1, 3, 4, 2]")
            }
            fn visit_str<E: Error>(self, text: &str) -> Result<Order, E> {
                Ok(Order(text.split(['-', ',', ' ', '–']).filter(|name| !name.is_empty()).map(str::to_owned).collect()))
            }
            fn visit_seq<A: SeqAccess<'de>>(self, mut list: A) -> Result<Order, A::Error> {
                let mut names = Vec::new();
                while let Some(Written(name)) = list.next_element()? {
                    names.push(name);
                }
                Ok(Order(names))
            }
        }
        deserializer.deserialize_any(Names)
    }
}

impl Order {
    /// The cylinders by index; each has to fire once.
    pub fn indices(&self, cylinders: &[Cylinder], span: Option<Range<usize>>) -> Result<Vec<usize>, LayoutError> {
        let names: Vec<&str> = cylinders.iter().map(|cylinder| cylinder.name.as_str()).collect();
        self.permutation(&names, span)
    }

    /// The throws of an in-line engine that fires evenly in this order; cylinder 1 stands at 0.
    pub fn even_throws(&self, cycle: Cycle, span: Option<Range<usize>>) -> Result<Vec<Turn>, LayoutError> {
        if self.0.len() > MOST_CYLINDERS {
            let message = format!("a firing order of {} cylinders", self.0.len());
            return Err(LayoutError::new(message, format!("up to {MOST_CYLINDERS} are read"), span));
        }
        let names: Vec<String> = (1..=self.0.len()).map(|number| number.to_string()).collect();
        let order = self.permutation(&names.iter().map(String::as_str).collect::<Vec<_>>(), span)?;
        let interval = cycle.turns() / BigRational::from_integer(order.len().into());
        let mut throws = vec![Turn::zero(); order.len()];
        for (position, &cylinder) in order.iter().enumerate() {
            throws[cylinder] = Turn::new(-&interval * BigRational::from_integer(position.into()));
        }
        let first = throws.first().cloned().unwrap_or_else(Turn::zero);
        Ok(throws.iter().map(|throw| throw - &first).collect())
    }

    fn permutation(&self, names: &[&str], span: Option<Range<usize>>) -> Result<Vec<usize>, LayoutError> {
        if self.0.is_empty() {
            return Err(LayoutError::new("the firing order is empty", "such as \"1-3-4-2\" or [1, 3, 4, 2]", span));
        }
        let mistake = |message: String| {
            LayoutError::new(message, format!("each of the {} cylinders once", names.len()), span.clone())
        };
        let mut order = Vec::with_capacity(names.len());
        for name in &self.0 {
            let index = names.iter().position(|known| known == name);
            let index =
                index.ok_or_else(|| mistake(format!("the firing order names `{name}`, which is no cylinder")))?;
            if order.contains(&index) {
                return Err(mistake(format!("cylinder {name} fires twice in the firing order")));
            }
            order.push(index);
        }
        match names.iter().enumerate().find(|(index, _)| !order.contains(index)) {
            Some((_, name)) => Err(mistake(format!("cylinder {name} is missing from the firing order"))),
            None => Ok(order),
        }
    }
}
