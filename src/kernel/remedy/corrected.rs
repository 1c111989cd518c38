//! Is the corrected engine balanced? Its sums are formed anew, with the weights among their terms, and judged.

use num_rational::BigRational;

use super::comparable_engine::ComparableEngine;
use super::weight::{Weight, doubled_square};
use crate::exact::{PhasorSum, Term};
use crate::order::{self, Factor};
use crate::proof::{Certificate, Planar, Sense};

/// One sum of the corrected engine, with the evidence whether it is zero.
#[derive(Clone, Debug)]
pub struct Corrected {
    /// Force, or moment about the reference plane.
    pub quantity: Planar,
    /// The order k.
    pub order: u32,
    /// Direct or reverse.
    pub sense: Sense,
    /// What the sum is multiplied by.
    pub factor: Factor,
    /// The terms of the engine and of the weights, in multiples of m r.
    pub sum: PhasorSum,
    /// The evidence.
    pub certificate: Certificate,
}

impl Corrected {
    /// Whether the sum is zero.
    pub fn vanishes(&self) -> bool {
        self.certificate.claims_zero()
    }
}

/// Judges the sums of these orders of an engine with these weights.
pub fn corrected(subject: &ComparableEngine, orders: &[u32], weights: &[Weight]) -> Vec<Corrected> {
    let mut judged = Vec::new();
    for &order in orders {
        for quantity in Planar::BOTH {
            let lever = |position: &BigRational| order::lever(subject.engine(), quantity, position);
            for sense in Sense::BOTH {
                let engine = order::contributions(subject.engine(), order, sense);
                let engine = engine.iter().map(|one| one.weighed(lever));
                let added = weights
                    .iter()
                    .filter(|weight| (weight.order, weight.sense) == (order, sense))
                    .flat_map(|weight| terms(weight, doubled_square(order) * lever(&weight.position)));
                let sums = order::by_factor(engine.chain(added));
                judged.extend(sums.into_iter().map(|(factor, sum)| {
                    let certificate = sum.certificate();
                    Corrected { quantity, order, sense, factor, sum, certificate }
                }));
            }
        }
    }
    judged
}

/// The terms of a weight, this many times.
fn terms(weight: &Weight, share: BigRational) -> Vec<(Factor, Term)> {
    let parts = weight.vector.parts().iter();
    let scaled = parts.flat_map(|(factor, sum)| {
        sum.scaled(&share).terms().iter().map(|term| (factor.clone(), term.clone())).collect::<Vec<_>>()
    });
    scaled.collect()
}
