//! For which open angles does an order of the gas torque vanish? Firing stars with unknowns in their angles.
//!
//! The star `Σ r_j e^{−iκφ_j}` with φ_j linear in the unknowns is a sum as any other here (theory, section 11). At whole orders
//! φ_j counts modulo a revolution, so that top dead centres are enough; at half orders it counts modulo two.

use std::collections::BTreeSet;

use num_rational::BigRational;

use super::classify::sum_of;
use super::verdict::OpenSum;
use super::when::When;
use super::zeros::{Solutions, Zeros};
use crate::engine::{CycleOrder, Family, FiringSpan, Linear, NoSpans};
use crate::firing::{NoStar, Weights, are_orders_of};

/// One order of the gas torque.
#[derive(Clone, Debug)]
pub struct OpenStar {
    /// The order κ.
    pub order: CycleOrder,
    /// Its star for each range of the open angle in which the cylinders fire at the same revolutions; none where they cannot fire
    /// in the order that is given.
    pub spans: Result<Vec<SpanStar>, NoSpans>,
}

/// The firing star where the cylinders fire at certain revolutions.
#[derive(Clone, Debug)]
pub struct SpanStar {
    /// Where, and when they fire.
    pub span: FiringSpan,
    /// The star.
    pub sum: OpenSum,
}

/// Why a family has no firing stars.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
pub enum NoOpenStar {
    /// Rods that differ: each kind has a star of its own.
    #[error(
        "the rods differ and an angle or a length is open: each kind of rod has a firing star of its own; give all cylinders \
                 one rod, or the unknowns values below [values]"
    )]
    RodsDiffer,
    /// No engine of the family has them.
    #[error(transparent)]
    NoStar(#[from] NoStar),
}

/// Judges the firing stars of these orders.
///
/// Half orders are decided where the open angle lies in the range, in turns, with its ends where `with_ends` says so.
///
/// # Errors
/// See [`NoOpenStar`].
pub fn firing_stars(
    family: &Family,
    orders: &[CycleOrder],
    weights: &Weights,
    range: [&BigRational; 2],
    with_ends: bool,
) -> Result<Vec<OpenStar>, NoOpenStar> {
    if family.mechanisms().len() > 1 {
        return Err(NoOpenStar::RodsDiffer);
    }
    if family.has_opposed_pistons() {
        return Err(NoStar::OpposedPistons.into());
    }
    weights.fit(family.cylinders().len())?;
    family.cycle().map_or(Ok(()), |cycle| are_orders_of(cycle, orders))?;
    let radii = family.cylinders().iter().map(|cylinder| &cylinder.crank_radius);
    let weights: Vec<BigRational> = radii.enumerate().map(|(index, radius)| radius * weights.of(index)).collect();
    let star = |&order: &CycleOrder| {
        let spans = match order.is_whole() {
            true => Ok(vec![FiringSpan { within: None, angles: family.dead_centres() }]),
            false => family.firing_spans(range, with_ends),
        };
        let judged = |span: FiringSpan| SpanStar { sum: star(&span.angles, &weights, order), span };
        OpenStar { order, spans: spans.map(|spans| spans.into_iter().map(judged).collect()) }
    };
    Ok(orders.iter().map(star).collect())
}

fn star(angles: &[Linear], weights: &[BigRational], order: CycleOrder) -> OpenSum {
    let turned = -order.exact();
    let term = |(angle, weight): (&Linear, &BigRational)| (angle.scaled(&turned), Linear::constant(weight.clone()));
    let terms: Vec<(Linear, Linear)> = angles.iter().zip(weights).map(term).collect();
    sum_of(&terms, None)
}

impl OpenStar {
    /// The spans, where they are known.
    fn known(&self) -> &[SpanStar] {
        self.spans.as_deref().unwrap_or_default()
    }

    /// Whether it vanishes for all values at which the cylinders fire.
    pub fn always(&self) -> bool {
        !self.known().is_empty() && self.known().iter().all(SpanStar::always)
    }

    /// Whether it vanishes for no value at which the cylinders fire.
    pub fn never(&self) -> bool {
        let is_left = |star: &SpanStar| matches!(star.sum.when, When::Never(_));
        !self.known().is_empty() && self.known().iter().all(is_left)
    }

    /// The values of an unknown in a range, in turns and with its ends, at which it vanishes; `None` where it does in a whole
    /// span, where the other unknown enters, or where not all of them are rational.
    pub fn values(&self, unknown: &str, range: [&BigRational; 2]) -> Option<BTreeSet<BigRational>> {
        self.solutions(unknown, range)?.all_exact().cloned()
    }

    /// The same with those that are irrational; `None` where it vanishes in a whole span, or the other unknown enters.
    pub fn solutions(&self, unknown: &str, range: [&BigRational; 2]) -> Option<Solutions> {
        let each = self.known().iter().map(|star| star.solutions(unknown, range)).collect::<Option<Vec<_>>>()?;
        each.into_iter().reduce(|mut all, more| {
            all.exact.extend(more.exact);
            all.irrational.extend(more.irrational);
            all.open.extend(more.open);
            all.irrational.sort();
            all.open.sort();
            all
        })
    }
}

impl SpanStar {
    /// Whether it vanishes throughout.
    pub fn always(&self) -> bool {
        matches!(self.sum.when, When::Always)
    }

    /// The values of an unknown in its span and a range at which it vanishes; `None` as in [`OpenStar::values`].
    pub fn values(&self, unknown: &str, range: [&BigRational; 2]) -> Option<BTreeSet<BigRational>> {
        self.solutions(unknown, range)?.all_exact().cloned()
    }

    /// The same with those that are irrational; `None` as in [`OpenStar::solutions`].
    pub fn solutions(&self, unknown: &str, range: [&BigRational; 2]) -> Option<Solutions> {
        match self.sum.zeros(unknown, range) {
            Zeros::At(mut solutions) => {
                let ends = self.span.within.as_ref().map(|ends| ends.each_ref().map(|end| end.at.clone()));
                solutions.retain(|value| self.span.holds(value), ends.as_ref().map_or(&[], |ends| ends));
                Some(solutions)
            }
            Zeros::Everywhere | Zeros::NotSolved => None,
        }
    }
}
