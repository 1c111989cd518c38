//! Which are the fewest polygons that make up a sum that is zero?
//!
//! **Which polygons.** Let the angles of n vectors differ by multiples of 1/N. Where a prime p does not divide N, all vectors are in one class g modulo p; `f(g, h) − f(g′, h)`, g′ another
//! class, leaves the sum as it is, takes p-gons to nothing, and each other polygon to one or to nothing. So p does not help. Nor does p > n: one class is empty, so each class is zero by itself
//! and has two vectors or none, so most are empty; what p-gons bring into these takes at least as many other polygons away again as they save. The polygons of the primes left lie each in a class
//! modulo N/M, M the product of these primes: the fewest are those of every class together.
//!
//! **How many.** Modulo the largest prime p the sum is p classes `v_g` over `M/p`. Let a be the weights of the p-gons: `|a| + Σ_g fewest(v_g − a)` polygons, |a| the
//! number of weights that are not 0. The least over all a is the answer. Tried are `a = 0`, every `a = v_g`, and, where that does not suffice, every `v_g` less one polygon, whose
//! weight is one at which some number of polygons falls. What is left has more than that in every class, so more than p or 2p polygons: a bound, and a proof where it is reached.

use smallvec::SmallVec;

use super::decide::primes_up_to;
use super::terms::{Exponent, Terms, Weight, classes};

/// Sums of more vectors are not searched.
pub(super) const MOST_VECTORS: usize = 12;

/// A polygon: its sides, the exponent of a corner, its weight.
pub(super) type Weighted<E, W> = (u32, E, W);

/// Polygons that add up to a sum.
pub(super) struct Fewest<E, W> {
    pub polygons: Vec<Weighted<E, W>>,
    /// Whether no fewer do, proved by the search.
    pub is_proved: bool,
}

impl<E, W: Weight> Fewest<E, W> {
    fn none() -> Self {
        Fewest { polygons: Vec::new(), is_proved: true }
    }

    /// The number of polygons, then of those that are taken away.
    fn cost(&self) -> (usize, usize) {
        (self.polygons.len(), self.polygons.iter().filter(|(_, _, weight)| weight.is_negative()).count())
    }
}

/// The fewest polygons of a sum that is zero, its terms collected; none of many vectors.
pub(super) fn find<E: Exponent, W: Weight>(conductor: &E, terms: &[(E, W)]) -> Option<Fewest<E, W>> {
    if terms.len() > MOST_VECTORS {
        return None;
    }
    let Some((first, _)) = terms.first() else { return Some(Fewest::none()) };
    let from_first = |exponent: &E| (exponent.clone() + conductor.clone() - first.clone()) % conductor.clone();
    let common = terms.iter().fold(conductor.clone(), |common, (exponent, _)| common.gcd(&from_first(exponent)));
    let conductor = conductor.clone() / common.clone();
    let reduced: Terms<E, W> =
        terms.iter().map(|(exponent, weight)| (from_first(exponent) / common.clone(), weight.clone())).collect();
    let (primes, product) = primes_up_to(terms.len(), &conductor);
    let found = match product == conductor {
        true => over_primes(&reduced, &primes, product.to_usize()?)?,
        false => {
            let mut all = Fewest::none();
            for class in classes(&reduced, &(conductor.clone() / product)).values() {
                let of_class = find(&conductor, class)?;
                all.polygons.extend(of_class.polygons);
                all.is_proved &= of_class.is_proved;
            }
            all
        }
    };
    let lifted = |(sides, corner, weight): Weighted<E, W>| (sides, corner * common.clone() + first.clone(), weight);
    Some(Fewest { polygons: found.polygons.into_iter().map(lifted).collect(), is_proved: found.is_proved })
}

fn over_primes<E: Exponent, W: Weight>(terms: &[(E, W)], primes: &[u32], conductor: usize) -> Option<Fewest<E, W>> {
    let mut weights = vec![W::zero(); conductor];
    for (exponent, weight) in terms {
        *weights.get_mut(exponent.to_usize()?)? = weight.clone();
    }
    let found = of_weights(&weights, primes)?;
    let exponent = |corner: usize| u32::try_from(corner).ok().map(E::from);
    let polygons = found.polygons.into_iter().map(|(sides, corner, weight)| Some((sides, exponent(corner)?, weight)));
    Some(Fewest { polygons: polygons.collect::<Option<_>>()?, is_proved: found.is_proved })
}

/// The same of all weights over a product of rising primes; none where the sum is not zero.
fn of_weights<W: Weight>(weights: &[W], primes: &[u32]) -> Option<Fewest<usize, W>> {
    let Some((&prime, smaller)) = primes.split_last() else { return weights[0].is_zero().then(Fewest::none) };
    if weights.iter().all(W::is_zero) {
        return Some(Fewest::none());
    }
    let mut search = Search::new(weights, prime, smaller);
    search.try_shared(&vec![W::zero(); search.rest]);
    for class in 0..search.classes.len() {
        search.try_shared(&search.classes[class].clone());
    }
    if smaller.is_empty() {
        return search.best;
    }
    let sides = prime as usize;
    // A class of one prime needs one polygon at most, so that there all is tried.
    let is_all = smaller.len() == 1;
    let mut bound = sides + 1;
    if smaller.len() <= 2 && search.best.as_ref().is_none_or(|best| best.polygons.len() > bound) {
        search.try_less_one(smaller);
        bound = 2 * sides + 1;
    }
    let is_proved = search.is_proved;
    search.best.map(|best| Fewest { is_proved: is_proved && (is_all || best.polygons.len() <= bound), ..best })
}

/// The search for the weights of the p-gons of the largest prime.
struct Search<'a, W> {
    prime: u32,
    smaller: &'a [u32],
    /// The conductor without the prime.
    rest: usize,
    /// By exponent modulo the prime, then modulo the rest.
    classes: Vec<Vec<W>>,
    best: Option<Fewest<usize, W>>,
    /// Whether the fewest polygons of every class that was asked for are proved to be.
    is_proved: bool,
}

impl<'a, W: Weight> Search<'a, W> {
    fn new(weights: &[W], prime: u32, smaller: &'a [u32]) -> Self {
        let sides = prime as usize;
        let rest = weights.len() / sides;
        let mut classes = vec![vec![W::zero(); rest]; sides];
        for (exponent, weight) in weights.iter().enumerate() {
            classes[exponent % sides][exponent % rest] = weight.clone();
        }
        Search { prime, smaller, rest, classes, best: None, is_proved: true }
    }

    /// The exponent of a place in a class.
    fn exponent(&self, class: usize, place: usize) -> usize {
        let sides = self.prime as usize;
        let in_class = |corner: &usize| corner % sides == class;
        (0..sides).map(|turn| place + turn * self.rest).find(in_class).unwrap_or(place)
    }

    /// Takes p-gons of these weights.
    fn try_shared(&mut self, shared: &[W]) {
        let weighted = shared.iter().enumerate().filter(|(_, weight)| !weight.is_zero());
        let polygons = weighted.map(|(place, weight)| (self.prime, place, weight.clone())).collect();
        let mut found = Fewest { polygons, is_proved: true };
        for class in 0..self.classes.len() {
            if self.best.as_ref().is_some_and(|best| found.polygons.len() > best.polygons.len()) {
                return;
            }
            let left: Vec<W> =
                self.classes[class].iter().zip(shared).map(|(one, other)| one.clone() - other.clone()).collect();
            let Some(of_class) = of_weights(&left, self.smaller) else { return };
            self.is_proved &= of_class.is_proved;
            let lifted = of_class
                .polygons
                .into_iter()
                .map(|(sides, place, weight)| (sides, self.exponent(class, place), weight));
            found.polygons.extend(lifted);
        }
        if self.best.as_ref().is_none_or(|best| found.cost() < best.cost()) {
            self.best = Some(found);
        }
    }

    /// Takes the weights of each class less one polygon.
    fn try_less_one(&mut self, smaller: &[u32]) {
        for class in 0..self.classes.len() {
            for &sides in smaller {
                let step = self.rest / sides as usize;
                for first in 0..step {
                    let corners: SmallVec<[usize; 8]> = (first..self.rest).step_by(step).collect();
                    for weight in self.weights_of(class, &corners) {
                        let mut shared = self.classes[class].clone();
                        corners.iter().for_each(|&corner| shared[corner] -= weight.clone());
                        self.try_shared(&shared);
                    }
                }
            }
        }
    }

    /// The weights of a polygon at which it has a corner less to add, or another class a polygon less: of a class `a_i + b_j` over two primes the
    /// number falls where two of the `−a_i` and `b_j` become equal.
    fn weights_of(&self, class: usize, corners: &[usize]) -> Vec<W> {
        let own = &self.classes[class];
        let mut weights: Vec<W> = corners.iter().map(|&corner| own[corner].clone()).collect();
        for other in &self.classes {
            let difference = |place: usize| other[place].clone() - own[place].clone();
            for &corner in corners {
                weights.push(-difference(corner));
                weights.extend((0..self.rest).map(|place| difference(place) - difference(corner)));
            }
        }
        weights.sort_unstable();
        weights.dedup();
        weights.retain(|weight| !weight.is_zero());
        weights
    }
}
