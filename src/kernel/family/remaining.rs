//! What is left of a moment whose lengths are open? The lengths factored out where its vectors share a line.

use num_rational::BigRational;
use num_traits::{Signed, Zero};

use super::verdict::{OpenSum, OpenVerdict};
use crate::engine::Linear;
use crate::exact::{PhasorSum, fraction};
use crate::numbers::{self, Direction, Form};

/// What is left of one quantity, order and sense, its angles known.
#[derive(Clone, Debug)]
#[allow(clippy::large_enum_variant, reason = "an order has a few of them")]
pub enum Remaining {
    /// Nothing.
    Nothing,
    /// `factor · lengths`, in one direction, as in `√10 (2a + b + 2c)` at −18.43°.
    Factored {
        /// The factor, positive.
        factor: Form,
        /// The lengths with whole coefficients without common divisor.
        lengths: Linear,
        /// The direction, where the lengths come out positive.
        direction: Option<Direction>,
        /// The direction in degrees, approximately.
        degrees: f64,
    },
    /// Vectors in different directions, or of lengths whose ratio is not rational: one sum per length.
    Apart,
    /// Angles are open too.
    Open,
}

/// What is left of a verdict in which φ and δ do not enter.
pub fn remaining(verdict: &OpenVerdict) -> Remaining {
    let sums: Vec<(&OpenSum, &PhasorSum)> =
        verdict.sums.iter().filter_map(|sum| sum.left().next().map(|part| (sum, &part.sum))).collect();
    let is_open = verdict.sums.iter().flat_map(OpenSum::left).any(|part| !part.phi.is_zero() || !part.delta.is_zero());
    let Some((_, reference)) = sums.first() else { return Remaining::Nothing };
    if is_open {
        return Remaining::Open;
    }
    let ratios: Option<Vec<BigRational>> = sums.iter().map(|(_, sum)| ratio(sum, reference)).collect();
    let (Some(ratios), Some(factor)) = (ratios, numbers::modulus(reference)) else { return Remaining::Apart };
    let content = fraction::common_unit(&ratios);
    let lengths = sums.iter().zip(&ratios).fold(Linear::default(), |lengths, ((sum, _), ratio)| {
        let coefficient = ratio / &content;
        let part = match &sum.symbol {
            Some(symbol) => Linear::symbol(symbol, coefficient),
            None => Linear::constant(coefficient),
        };
        lengths.plus(&part)
    });
    Remaining::Factored {
        factor: factor.scaled(&content.abs()),
        lengths,
        direction: numbers::direction_of(reference),
        degrees: numbers::evaluate(reference).arg().to_degrees(),
    }
}

/// The rational q with `sum = q · reference`, if there is one.
///
/// `sum · conj(reference) = q |reference|²`, whose sides are compared exactly for the q that the traces give.
pub(super) fn ratio(sum: &PhasorSum, reference: &PhasorSum) -> Option<BigRational> {
    let product = sum.times(&reference.conjugate());
    let square = reference.squared_modulus();
    if !product.minus(&product.conjugate()).vanishes() {
        return None;
    }
    let quotient = numbers::mean_of_conjugates(&product)? / numbers::mean_of_conjugates(&square)?;
    product.minus(&square.scaled(&quotient)).vanishes().then_some(quotient)
}
