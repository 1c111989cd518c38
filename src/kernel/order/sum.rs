//! What is a vector with numbers of the motion in it? One exact sum before each of them.

use std::collections::BTreeMap;

use num_rational::BigRational;
use num_traits::One;

use super::factor::Factor;
use crate::exact::{PhasorSum, Term, fraction};

/// `Σ factor · sum`, in normal form: each direction of a sum once, and no sum that vanishes.
///
/// It is zero, whatever the factors are, exactly where no sum is left.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct OrderSum(BTreeMap<Factor, PhasorSum>);

/// The terms before each factor, not collected, in their order.
pub fn by_factor(terms: impl IntoIterator<Item = (Factor, Term)>) -> BTreeMap<Factor, PhasorSum> {
    let mut parts: BTreeMap<Factor, Vec<Term>> = BTreeMap::new();
    for (factor, term) in terms {
        parts.entry(factor).or_default().push(term);
    }
    parts.into_iter().map(|(factor, terms)| (factor, PhasorSum::new(terms))).collect()
}

impl OrderSum {
    /// The sum of these terms, each before its factor.
    pub fn new(terms: impl IntoIterator<Item = (Factor, Term)>) -> Self {
        Self::of(by_factor(terms))
    }

    /// One sum before one factor.
    pub fn single(factor: Factor, sum: PhasorSum) -> Self {
        Self::of([(factor, sum)])
    }

    fn of(parts: impl IntoIterator<Item = (Factor, PhasorSum)>) -> Self {
        let collected = parts.into_iter().map(|(factor, sum)| (factor, sum.tidied()));
        OrderSum(collected.filter(|(_, sum)| !sum.vanishes()).collect())
    }

    /// The sums that do not vanish, by factor.
    pub fn parts(&self) -> &BTreeMap<Factor, PhasorSum> {
        &self.0
    }

    /// Whether the vector is zero, whatever the factors are.
    pub fn vanishes(&self) -> bool {
        self.0.is_empty()
    }

    /// The one sum with its factor; `None` where there are several, or none.
    pub fn only(&self) -> Option<(&Factor, &PhasorSum)> {
        let mut parts = self.0.iter();
        parts.next().filter(|_| parts.next().is_none())
    }

    /// The sum of both.
    pub fn plus(&self, other: &Self) -> Self {
        let mut all = self.0.clone();
        for (factor, sum) in &other.0 {
            all.entry(factor.clone()).and_modify(|there| *there = there.plus(sum)).or_insert_with(|| sum.clone());
        }
        Self::of(all)
    }

    /// The first less the second.
    pub fn minus(&self, other: &Self) -> Self {
        self.plus(&other.scaled(&-BigRational::one()))
    }

    /// A multiple.
    pub fn scaled(&self, by: &BigRational) -> Self {
        Self::of(self.0.iter().map(|(factor, sum)| (factor.clone(), sum.scaled(by))))
    }

    /// The terms of a multiple, each with its factor.
    pub fn terms_scaled(&self, by: BigRational) -> impl Iterator<Item = (Factor, Term)> {
        let parts = self.0.iter().flat_map(|(factor, sum)| sum.terms().iter().map(move |term| (factor, term)));
        parts.map(move |(factor, Term { angle, weight })| {
            (factor.clone(), Term { angle: angle.clone(), weight: fraction::times(weight, &by) })
        })
    }

    /// The mirror image of every sum in the reference direction; the factors stay.
    pub fn mirrored(&self) -> Self {
        OrderSum(self.0.iter().map(|(factor, sum)| (factor.clone(), sum.conjugate())).collect())
    }
}
