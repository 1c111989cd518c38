//! What does a sum look like over one denominator? Like directions collected, weights whole.

use std::collections::BTreeMap;

use num_bigint::{BigInt, BigUint};
use num_integer::Integer;
use num_rational::BigRational;
use num_traits::{Signed, ToPrimitive, Zero};

use super::term::Term;
use super::turn::Turn;
use super::words::Words;
use super::{decide, fraction};

/// The sum `Σ weight · e^{2πi·exponent/conductor}` with whole weights: a [`super::PhasorSum`] scaled by
/// `scale`, with each direction once, no weight zero, in order of the exponents.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub struct IntegerSum {
    /// The common denominator of the angles.
    pub conductor: BigUint,
    /// What the rational weights were multiplied by to make them whole.
    pub scale: BigInt,
    /// `(exponent, weight)`, exponents rising, each below the conductor.
    pub terms: Vec<(BigUint, BigInt)>,
}

impl IntegerSum {
    /// Collects like directions and scales to whole weights.
    pub fn collect(terms: &[Term]) -> Self {
        if let Some(Words { conductor, scale, terms }) = Words::of(terms) {
            let terms = decide::collect(terms.into_iter()).into_iter();
            let terms = terms.map(|(exponent, weight)| (exponent.into(), weight.into())).collect();
            return IntegerSum { conductor: conductor.into(), scale: scale.into(), terms };
        }
        let conductor = fraction::common_denominator(terms.iter().map(|term| term.angle.turns()));
        let scale = fraction::common_denominator(terms.iter().map(|term| &term.weight));
        let mut pairs: Vec<(BigUint, BigInt)> = terms
            .iter()
            .map(|term| (whole(term.angle.turns(), &conductor), whole(&term.weight, &scale)))
            .map(|(exponent, weight)| (exponent.magnitude().clone(), weight))
            .collect();
        pairs.sort_by(|a, b| a.0.cmp(&b.0));
        let mut collected: Vec<(BigUint, BigInt)> = Vec::with_capacity(pairs.len());
        for (exponent, weight) in pairs {
            match collected.last_mut() {
                Some(last) if last.0 == exponent => last.1 += weight,
                _ => collected.push((exponent, weight)),
            }
        }
        collected.retain(|(_, weight)| !weight.is_zero());
        IntegerSum { conductor: conductor.magnitude().clone(), scale, terms: collected }
    }

    /// The same sum in machine words, where the conductor and the sum of all weights stay below 2⁶³.
    ///
    /// No weight in the course of a decision exceeds the sum of all weights, so none can wrap.
    pub fn in_machine_words(&self) -> Option<(u64, Vec<(u64, i64)>)> {
        let total: BigInt = self.terms.iter().map(|(_, weight)| weight.abs()).sum();
        total.to_i64()?;
        let conductor = u64::try_from(self.conductor.to_i64()?).ok()?;
        let terms = self.terms.iter().map(|(e, w)| Some((e.to_u64()?, w.to_i64()?))).collect::<Option<Vec<_>>>()?;
        Some((conductor, terms))
    }

    /// The product of both sums, over the least common conductor.
    pub fn times(&self, other: &Self) -> Self {
        let conductor = self.conductor.lcm(&other.conductor);
        let over = |sum: &Self| -> Vec<(BigUint, BigInt)> {
            let factor = &conductor / &sum.conductor;
            sum.terms.iter().map(|(exponent, weight)| (exponent * &factor, weight.clone())).collect()
        };
        let (left, right) = (over(self), over(other));
        let mut products: BTreeMap<BigUint, BigInt> = BTreeMap::new();
        for (exponent, weight) in &left {
            for (other_exponent, other_weight) in &right {
                let sum = exponent + other_exponent;
                let exponent = if sum < conductor { sum } else { sum - &conductor };
                *products.entry(exponent).or_default() += weight * other_weight;
            }
        }
        let terms = products.into_iter().filter(|(_, weight)| !weight.is_zero()).collect();
        IntegerSum { conductor, scale: &self.scale * &other.scale, terms }
    }

    /// The collected terms as angles and rational weights.
    pub fn to_terms(&self) -> Vec<Term> {
        let conductor = BigInt::from(self.conductor.clone());
        self.terms
            .iter()
            .map(|(exponent, weight)| Term {
                angle: Turn::new(BigRational::new(exponent.clone().into(), conductor.clone())),
                weight: BigRational::new(weight.clone(), self.scale.clone()),
            })
            .collect()
    }
}

/// `ratio · multiple`, where the multiple clears the denominator.
pub(super) fn whole(ratio: &BigRational, multiple: &BigInt) -> BigInt {
    ratio.numer() * (multiple / ratio.denom())
}
