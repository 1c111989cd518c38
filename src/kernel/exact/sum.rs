//! What is a phasor sum? Rational weights at rational angles, one term per cylinder.

use std::borrow::Cow;
use std::collections::BTreeMap;
use std::collections::btree_map::Entry;

use num_rational::BigRational;
use num_traits::{Signed, Zero};

use super::collected::IntegerSum;
use super::term::Term;
use super::turn::Turn;
use super::words::Words;
use super::{decide, fraction};
use crate::proof::Vector;

/// The sum `Σ weight · e^{2πi·angle}`, with its terms as they were given.
///
/// Two sums are equal (`==`) where they are the same number, however they are written. Collecting like directions is not
/// enough to tell, since roots of unity are not independent (`1 + e^{2πi/3} = e^{2πi/6}`), so their difference is decided:
///
/// ```standalone_crate
/// # use crankstar_kernel as crankstar;
/// use crankstar::exact::{PhasorSum, Term, Turn};
/// let unit = |numerator, denominator| {
///     PhasorSum::new(vec![Term { angle: Turn::fraction(numerator, denominator), weight: num_traits::One::one() }])
/// };
/// assert_eq!(unit(0, 1).plus(&unit(1, 3)), unit(1, 6));
/// assert_ne!(unit(0, 1).plus(&unit(1, 3)), unit(1, 7));
/// ```
///
/// Where the way of writing matters, as in a document with one term per cylinder, compare [`PhasorSum::terms`].
#[derive(Clone, Debug)]
pub struct PhasorSum {
    terms: Vec<Term>,
}

impl PartialEq for PhasorSum {
    fn eq(&self, other: &Self) -> bool {
        self.minus(other).vanishes()
    }
}

/// Equality of numbers, decided exactly, is reflexive, symmetric and transitive.
impl Eq for PhasorSum {}

impl PhasorSum {
    /// The sum of these terms, in this order.
    pub fn new(terms: Vec<Term>) -> Self {
        PhasorSum { terms }
    }

    /// The terms as given, before collecting.
    pub fn terms(&self) -> &[Term] {
        &self.terms
    }

    /// The terms as given, in the words of the checker.
    pub fn vectors(&self) -> Vec<Vector> {
        let vector = |term: &Term| Vector { angle: term.angle.turns().clone(), weight: term.weight.clone() };
        self.terms.iter().map(vector).collect()
    }

    /// The same sum with each direction once, no weight zero, in order of the angles.
    pub fn collected(&self) -> Vec<Term> {
        let mut by_angle: BTreeMap<&Turn, Cow<BigRational>> = BTreeMap::new();
        for term in &self.terms {
            match by_angle.entry(&term.angle) {
                Entry::Vacant(place) => drop(place.insert(Cow::Borrowed(&term.weight))),
                Entry::Occupied(mut there) => *there.get_mut() = Cow::Owned(fraction::plus(there.get(), &term.weight)),
            }
        }
        by_angle
            .into_iter()
            .filter(|(_, weight)| !weight.is_zero())
            .map(|(angle, weight)| Term { angle: angle.clone(), weight: weight.into_owned() })
            .collect()
    }

    /// The same sum, [collected](PhasorSum::collected).
    pub fn tidied(&self) -> Self {
        PhasorSum { terms: self.collected() }
    }

    /// The same sum with each line once, opposite directions collected too: all weights positive, in order of the angles.
    pub fn on_lines(&self) -> Vec<Term> {
        let half = Turn::fraction(1, 2);
        let to_first_half = |term: &Term| match term.angle < half {
            true => term.clone(),
            false => Term { angle: term.angle.opposite(), weight: -&term.weight },
        };
        self.map(to_first_half).tidied().positive().collected()
    }

    /// The sum with every vector of negative weight as one of positive weight, turned by half a turn.
    pub fn positive(&self) -> Self {
        self.map(|term| match term.weight.is_negative() {
            true => Term { angle: term.angle.opposite(), weight: -&term.weight },
            false => term.clone(),
        })
    }

    /// Whether the sum is zero, decided exactly (see [`decide::vanishes`]).
    pub fn vanishes(&self) -> bool {
        match Words::of(&self.terms) {
            Some(sum) => decide::vanishes(&sum.conductor, &sum.terms),
            None => {
                let sum = IntegerSum::collect(&self.terms);
                decide::vanishes(&sum.conductor, &sum.terms)
            }
        }
    }

    /// Every vector turned by the same angle.
    pub fn turned(&self, by: &Turn) -> Self {
        self.map(|term| Term { angle: &term.angle + by, weight: term.weight.clone() })
    }

    /// Every vector lengthened by the same factor.
    pub fn scaled(&self, by: &BigRational) -> Self {
        self.map(|term| Term { angle: term.angle.clone(), weight: fraction::times(&term.weight, by) })
    }

    /// The mirror image in the reference direction: the complex conjugate.
    pub fn conjugate(&self) -> Self {
        self.map(|term| Term { angle: -&term.angle, weight: term.weight.clone() })
    }

    /// The sum of both sums.
    pub fn plus(&self, other: &Self) -> Self {
        PhasorSum { terms: self.terms.iter().chain(&other.terms).cloned().collect() }
    }

    /// The first sum less the second.
    pub fn minus(&self, other: &Self) -> Self {
        self.plus(&other.map(|term| Term { angle: term.angle.clone(), weight: -&term.weight }))
    }

    /// The image under the Galois map `e^{2πit} ↦ e^{2πi·at}`, for a prime to the common denominator.
    pub fn galois(&self, a: i64) -> Self {
        self.map(|term| Term { angle: term.angle.times(a), weight: term.weight.clone() })
    }

    /// The product of both sums, collected.
    pub fn times(&self, other: &Self) -> Self {
        let (left, right) = (IntegerSum::collect(&self.terms), IntegerSum::collect(&other.terms));
        PhasorSum { terms: left.times(&right).to_terms() }
    }

    /// `|S|² = S S̄ = Σ_j Σ_l w_j w_l e^{2πi(t_j − t_l)}`, collected: again a phasor sum.
    pub fn squared_modulus(&self) -> Self {
        self.times(&self.conjugate())
    }

    /// Whether both sums are equally long: `|S|² − |S′|²` is zero, decided exactly.
    pub fn is_as_long_as(&self, other: &Self) -> bool {
        self.squared_modulus().minus(&other.squared_modulus()).vanishes()
    }

    fn map(&self, change: impl Fn(&Term) -> Term) -> Self {
        PhasorSum { terms: self.terms.iter().map(change).collect() }
    }
}

/// Whether the vectors of each group sum to zero: then all of it does, whatever each group is multiplied by.
pub fn vanish_apart<K: Ord>(vectors: impl IntoIterator<Item = (K, Term)>) -> bool {
    let mut groups: BTreeMap<K, Vec<Term>> = BTreeMap::new();
    vectors.into_iter().for_each(|(group, term)| groups.entry(group).or_default().push(term));
    groups.into_values().all(|terms| PhasorSum::new(terms).vanishes())
}
