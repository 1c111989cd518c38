//! What is said of the gas torque while an angle is open? For which values each order vanishes, and why.

mod page;
mod picture;
mod words;

use std::collections::BTreeSet;

use num_rational::BigRational;
use num_traits::{One, Zero};

use crate::engine::{Cycle, CycleOrder, Family, HIGHEST_ORDER, NoSpans, OpenFiring};
use crate::family::{self, NoOpenStar, OpenStar};

pub use page::{open_firing_answer, open_firing_page};

/// Firing stars with open angles that are judged.
#[derive(Clone, Debug)]
pub struct OpenFiringStudy<'a> {
    /// The family.
    pub family: &'a Family,
    /// The deflections of a mode of torsional vibration that the vectors are weighed by, one per cylinder.
    pub shape: Option<Vec<BigRational>>,
    /// The orders, rising, each once; half orders for an open angle in (0°, 360°).
    pub orders: Vec<OpenStar>,
}

impl<'a> OpenFiringStudy<'a> {
    /// Judges these orders, the usual ones where there are none: half orders among them where the layout says when the cylinders
    /// fire.
    ///
    /// # Errors
    /// Where the family has no firing stars.
    pub fn new(family: &'a Family, orders: &[CycleOrder], shape: Option<Vec<BigRational>>) -> Result<Self, NoOpenStar> {
        let orders: BTreeSet<CycleOrder> = match orders {
            [] => usual_orders(family).into_iter().collect(),
            asked => asked.iter().copied().collect(),
        };
        let orders: Vec<CycleOrder> = orders.into_iter().collect();
        let (none, turn) = (BigRational::zero(), BigRational::one());
        let orders = family::firing_stars(family, &orders, shape.as_deref(), [&none, &turn], false)?;
        Ok(OpenFiringStudy { family, shape, orders })
    }

    /// The one open angle; none where two are open, or lengths alone.
    fn unknown(&self) -> Option<&'a str> {
        let unknowns = self.family.open_angles();
        let mut unknowns = unknowns.into_iter();
        unknowns.next().filter(|_| unknowns.next().is_none())
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
    let step = match (family.cycle(), family.open_firing()) {
        (Some(cycle), Some(_)) => cycle.lowest_order().halves(),
        _ => 2,
    };
    let cylinders = u32::try_from(family.cylinders().len()).unwrap_or(u32::MAX);
    let last = cylinders.saturating_mul(step).clamp(8, 2 * HIGHEST_ORDER);
    (1..=last / step).filter_map(|index| CycleOrder::of_halves(index * step)).collect()
}
