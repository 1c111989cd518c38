//! What is said of the gas torque while an angle is open? For which values each order vanishes, and why.

mod page;
mod picture;
mod words;

use num_rational::BigRational;
use num_traits::{One, Zero};

use crate::engine::{Cycle, CycleOrder, Family, NoSpans, OpenFiring};
use crate::family::{self, NoOpenStar, OpenStar};
use crate::firing::{self, Weights};
use crate::report::rising;

pub use page::{open_firing_answer, open_firing_page};
pub(in crate::report) use picture::plot_of_stars;

/// Firing stars with open angles that are decided.
#[derive(Clone, Debug)]
pub struct OpenFiringStudy<'a> {
    /// The family.
    pub family: &'a Family,
    /// What the vectors are weighed by.
    pub weights: Weights,
    /// The orders, rising, each once; half orders for an open angle in (0°, 360°).
    pub orders: Vec<OpenStar>,
}

impl<'a> OpenFiringStudy<'a> {
    /// Judges these orders, the usual ones where there are none: half orders among them where the layout says when the cylinders
    /// fire.
    ///
    /// # Errors
    /// Where the family has no firing stars.
    pub fn new(family: &'a Family, orders: &[CycleOrder], weights: Weights) -> Result<Self, NoOpenStar> {
        let orders = rising(if orders.is_empty() { usual_orders(family) } else { orders.to_vec() });
        let (none, turn) = (BigRational::zero(), BigRational::one());
        let orders = family::firing_stars(family, &orders, &weights, [&none, &turn], false)?;
        Ok(OpenFiringStudy { family, weights, orders })
    }

    /// The cylinders in the order of their firing, where the layout gives one.
    fn order(&self) -> Option<String> {
        let OpenFiring::Order(order) = self.family.open_firing()? else { return None };
        let names = order.iter().map(|&cylinder| self.family.cylinders()[cylinder].name.as_str());
        Some(names.collect::<Vec<_>>().join("-"))
    }

    /// Whether half orders exist, and the layout does not say when the cylinders fire.
    fn lacks_half_orders(&self) -> bool {
        let is_two_stroke = self.family.cycle() == Some(Cycle::TwoStroke);
        let asked = self.orders.iter().any(|star| star.spans.as_ref().is_err_and(|why| *why == NoSpans::NotSaid));
        asked || !is_two_stroke && self.family.open_firing().is_none()
    }
}

/// As those of an engine, half orders where it is known when the cylinders fire.
fn usual_orders(family: &Family) -> Vec<CycleOrder> {
    let lowest = match (family.cycle(), family.open_firing()) {
        (Some(cycle), Some(_)) => cycle.lowest_order(),
        _ => Cycle::TwoStroke.lowest_order(),
    };
    firing::usual_orders(family.cylinders().len(), lowest)
}
