//! How much can the orders above the K-th add, at most?
//!
//! Force: the parts of the coefficients that the rod makes add up to `Σ_{k≥1} |c_k − [k=1]| = s/√(1−s²)`, `s = λ + |δ|`, where
//! all have one sign; what the first K leave of that bounds the rest.
//!
//! Torque: its n-th harmonic is `n (−i)^n (X − iY)` (see [`crate::motion::SliderCrank::torque_coefficient`]), where
//! `|X| ≤ ½ (|g_{n−1}|/(n−1) + |g_{n+1}|/(n+1))` with `|g_k| = |c_k − [k=1]|`, and
//! `|Y| ≤ (R p^n + S q^n)/(2λ²)` for n > 2 with `R = √((1+δ)²−λ²)`, `p = λ/(1+δ+R)`, and S, q the same of −δ. The first part is
//! summed over the rest of the g_k, the second as a geometric series.

use std::collections::BTreeMap;

use num_bigint::BigInt;
use num_rational::BigRational;
use num_traits::{One, Signed, ToPrimitive, Zero};

use super::interval::Interval;
use crate::layout::{Layout, Rod};
use crate::loads::Missing;
use crate::motion::{Enclosure, SliderCrank};
use crate::order;
use crate::proof::Quantity;

/// Floats of a bound are enlarged by this part of it, far more than they are rounded by.
const SLACK: f64 = 1.0 + 1e-9;

/// What the orders of each crank leave.
#[derive(Clone, Debug)]
pub(super) struct Tails {
    /// By rod: `Σ_{i>k} |g_i|` at most, at place k.
    rests: BTreeMap<Rod, Vec<f64>>,
}

impl Tails {
    /// For all orders up to the highest.
    ///
    /// # Errors
    /// A crank cannot turn round.
    pub fn new(layout: &Layout, highest: u32) -> Result<Self, Missing> {
        let mut rests = BTreeMap::new();
        for rod in &layout.mechanism.rods {
            if !rests.contains_key(rod) {
                rests.insert(rod.clone(), rests_of(rod, highest + 1)?);
            }
        }
        Ok(Tails { rests })
    }

    /// The orders above this one, of at least 2, add at most this to a load, in its multiples of m r ω².
    pub fn above(&self, layout: &Layout, quantity: Quantity, order: u32) -> f64 {
        self.sum(layout, quantity, &|rod| match quantity {
            Quantity::Force | Quantity::Moment => self.rest(rod, order),
            Quantity::Torque => {
                let k = f64::from(order);
                let rod_part = (k + 1.0) / k * self.rest(rod, order - 1) + self.rest(rod, order + 1);
                rod_part / 2.0 + elementary(rod, order)
            }
        })
    }

    /// No sum of the terms of a load is larger than this: all pistons at the dead point of the largest acceleration.
    pub fn largest_sum(&self, layout: &Layout, quantity: Quantity) -> f64 {
        self.sum(layout, quantity, &|rod| {
            let shaking = 1.0 + self.rest(rod, 0);
            if quantity == Quantity::Torque { shaking * shaking } else { shaking }
        })
    }

    fn rest(&self, rod: &Rod, order: u32) -> f64 {
        self.rests.get(rod).and_then(|rests| rests.get(order as usize)).copied().unwrap_or(f64::INFINITY)
    }

    /// The bounds of the pistons, each as much as its load counts.
    fn sum(&self, layout: &Layout, quantity: Quantity, bound: &dyn Fn(&Rod) -> f64) -> f64 {
        let size = |number: &BigRational| Interval::around(number).size();
        let cylinders = layout.cylinders.iter().zip(&layout.mechanism.rods);
        let parts = cylinders.map(|(cylinder, rod)| {
            let weight = size(&order::mass_radius(layout, cylinder)) * bound(rod);
            match quantity {
                Quantity::Force => weight,
                Quantity::Moment => weight * size(&layout.arm(cylinder)),
                Quantity::Torque => weight * size(&cylinder.crank_radius),
            }
        });
        // A mass of 0 is 0 times whatever the rest is.
        parts.filter(|part| !part.is_nan()).sum::<f64>() * SLACK
    }
}

/// Bounds at 0, 1, …, the highest, rising errors of the sums included: they are fractions.
fn rests_of(rod: &Rod, highest: u32) -> Result<Vec<f64>, Missing> {
    let crank = SliderCrank::new(rod.ratio.clone(), rod.offset.clone());
    let crank = crank.map_err(|error| Missing::Motion(error.to_string()))?;
    let mut rest = acceleration_at_dead_point(&(&rod.ratio + rod.offset.abs()));
    let mut rests = vec![Interval::around(&rest).high];
    for order in 1..=highest {
        let c = crank.coefficient(order);
        let one = if order == 1 { BigRational::one() } else { BigRational::zero() };
        let re = Enclosure { low: &c.re.low - &one, high: &c.re.high - &one };
        // One of both parts is zero.
        rest -= least_size(&re).max(least_size(&c.im));
        rests.push(Interval::around(&rest).high);
    }
    Ok(rests)
}

fn least_size(number: &Enclosure) -> BigRational {
    if number.contains_zero() { BigRational::zero() } else { number.low.abs().min(number.high.abs()) }
}

/// `s/√(1−s²)`, rounded up.
fn acceleration_at_dead_point(reach: &BigRational) -> BigRational {
    let square = reach * reach;
    let quotient = &square / (BigRational::one() - &square);
    let bits = 256_u32;
    let root = ((quotient.numer() << (2 * bits)) / quotient.denom() + 1_u32).sqrt() + 1_u32;
    BigRational::new(root, BigInt::one() << bits)
}

/// `Σ_{n>K} n (R p^n + S q^n)/(2λ²)`.
fn elementary(rod: &Rod, order: u32) -> f64 {
    let float = |number: &BigRational| number.to_f64().unwrap_or(f64::NAN);
    let (ratio, k) = (float(&rod.ratio), f64::from(order));
    if rod.ratio.is_zero() {
        return 0.0;
    }
    let part = |reach: BigRational| {
        let root = float(&((&reach - &rod.ratio) * (&reach + &rod.ratio))).sqrt();
        let (gap, p) = (float(&(&reach - &rod.ratio)) + root, ratio / (float(&reach) + root));
        // 1 − p without cancellation.
        let short = gap / (float(&reach) + root);
        root * p.powf(k - 1.0) * ((k + 1.0) - k * p) / (short * short) / (float(&reach) + root).powi(2) / 2.0
    };
    part(BigRational::one() + &rod.offset) + part(BigRational::one() - &rod.offset)
}
