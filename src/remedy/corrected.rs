//! Is the corrected engine balanced? Its sums are formed anew, with the weights among their terms, and judged.

use num_rational::BigRational;
use num_traits::One;

use super::sums::Subject;
use super::weight::{Weight, doubled_square};
use crate::exact::PhasorSum;
use crate::loads::{self, Factor, Parts, Weighing};
use crate::proof::{Certificate, Quantity, Sense};

/// One sum of the corrected engine, with the evidence whether it is zero.
#[derive(Clone, Debug)]
pub struct Corrected {
    /// Force, or moment about the reference plane.
    pub quantity: Quantity,
    /// The order k.
    pub order: u32,
    /// Direct or reverse.
    pub sense: Sense,
    /// The coefficient that the sum has: none is 1, else c_k of this rod.
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
pub fn corrected(subject: &Subject, orders: &[u32], weights: &[Weight]) -> Vec<Corrected> {
    let plane = &subject.layout().reference_plane;
    let whole = |_: &BigRational| BigRational::one();
    let arm = |position: &BigRational| position - plane;
    let quantities: [(Quantity, Weighing); 2] = [(Quantity::Force, &whole), (Quantity::Moment, &arm)];
    let mut judged = Vec::new();
    for &order in orders {
        for (quantity, weighing) in quantities {
            for sense in [Sense::Direct, Sense::Reverse] {
                let sums = with_weights(subject, weighing, order, sense, weights);
                judged.extend(sums.into_iter().map(|(factor, sum)| {
                    let certificate = sum.certificate();
                    Corrected { quantity, order, sense, factor, sum, certificate }
                }));
            }
        }
    }
    judged
}

fn with_weights(subject: &Subject, weighing: Weighing, order: u32, sense: Sense, weights: &[Weight]) -> Parts {
    let mut sums = loads::sums(subject.layout(), weighing, order, sense);
    for weight in weights.iter().filter(|weight| (weight.order, weight.sense) == (order, sense)) {
        let share = doubled_square(order) * weighing(&weight.position);
        for (factor, sum) in weight.vector.parts() {
            let added = sum.scaled(&share);
            sums.entry(factor.clone()).and_modify(|there| *there = there.plus(&added)).or_insert(added);
        }
    }
    sums
}
