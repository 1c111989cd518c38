//! Is the sum zero? Splitting by the primes up to the number of terms decides it.
//!
//! With ζ_N = e^{2πi/N}, two facts suffice (theory, section 4; de Bruijn 1953, Lam and Leung 2000):
//!
//! - `p² | N`, or `p` above the number of terms: the terms fall into classes by their exponent modulo `p`, and the
//!   sum is zero iff each class is zero by itself.
//! - `p | N` once, `N = pM`: `S = Σ_{u<p} ζ_p^u S_u` with every `S_u` over the conductor `M`, and the sum is zero
//!   iff all the `S_u` are equal.
//!
//! So the cost depends on the number of terms, and not on the conductor: it is never factored. Over small conductors a
//! product says the same sooner ([`super::dense`]).

use smallvec::SmallVec;

use super::dense;
use super::terms::{Exponent, Terms, Weight};

/// Whether `Σ weight · e^{2πi·exponent/conductor}` is zero.
///
/// Exponents lie in `0..conductor`, in any order and as often as they like. In machine words the conductor and
/// the sum of the moduli of all weights must stay below 2⁶³ ([`super::IntegerSum::in_machine_words`] sees to it).
///
/// ```standalone_crate
/// # use crankstar_kernel as crankstar;
/// use crankstar::exact::vanishes;
/// assert!(vanishes(&6_u64, &[(0, 1_i64), (2, 1), (4, 1)])); // a regular triangle
/// assert!(!vanishes(&6_u64, &[(0, 1_i64), (2, 1), (3, 1)]));
/// ```
pub fn vanishes<E: Exponent, W: Weight>(conductor: &E, terms: &[(E, W)]) -> bool {
    if let Some(answer) = dense::vanishes(conductor, terms) {
        return answer;
    }
    let terms = collect(terms.iter().cloned());
    if terms.len() < 3 {
        return few_vanish(&terms, conductor);
    }
    let (primes, radical) = primes_up_to(terms.len(), conductor);
    let step = conductor.clone() / radical.clone();
    every_class_vanishes(&terms, &step, &primes, &radical)
}

/// One vector never vanishes; two do where they are opposite and equally long.
fn few_vanish<E: Exponent, W: Weight>(terms: &[(E, W)], conductor: &E) -> bool {
    let [(first, weight), (second, other)] = terms else { return terms.is_empty() };
    let between = if first < second { second.clone() - first.clone() } else { first.clone() - second.clone() };
    weight == other && between.clone() + between == *conductor
}

/// The primes up to `count` that divide the conductor, and their product.
pub(super) fn primes_up_to<E: Exponent>(count: usize, conductor: &E) -> (SmallVec<[u32; 4]>, E) {
    let mut primes: SmallVec<[u32; 4]> = SmallVec::new();
    let mut radical = E::one();
    for candidate in 2..=u32::try_from(count).unwrap_or(u32::MAX) {
        let is_composite = primes.iter().any(|p| candidate % p == 0);
        if !is_composite && conductor.is_multiple_of(&E::from(candidate)) && is_prime(candidate) {
            primes.push(candidate);
            radical = radical * E::from(candidate);
        }
    }
    (primes, radical)
}

fn is_prime(candidate: u32) -> bool {
    (2..).take_while(|d| d * d <= candidate).all(|d| !candidate.is_multiple_of(d))
}

/// Whether every class of exponents modulo `step` is zero by itself; `step · product of primes` is the conductor.
fn every_class_vanishes<E: Exponent, W: Weight>(terms: &[(E, W)], step: &E, primes: &[u32], product: &E) -> bool {
    if step.is_one() {
        return squarefree_vanishes(terms, primes, product);
    }
    by_class(terms, step).chunk_by(same_class).all(|class| {
        // One term of the class is turned to angle 0, so every exponent left is a multiple of the step.
        let first = &class[0].exponent;
        squarefree_vanishes(&shifted(class, |exponent| (exponent - first.clone()) / step.clone()), primes, product)
    })
}

/// The same question for a conductor that is the product of distinct rising `primes`; exponents distinct.
fn squarefree_vanishes<E: Exponent, W: Weight>(terms: &[(E, W)], primes: &[u32], conductor: &E) -> bool {
    if terms.len() < 3 {
        return few_vanish(terms, conductor);
    }
    // Primes above the number of terms only split, and an empty class makes a prime split too.
    let Some((&largest, smaller)) = primes.split_last() else { return false };
    let count = largest as usize;
    let prime = E::from(largest);
    let rest = conductor.clone() / prime.clone();
    if terms.len() < count {
        return every_class_vanishes(terms, &prime, smaller, &rest);
    }
    if smaller.is_empty() {
        // Over one prime, 1 + ζ + … + ζ^{p−1} = 0 is the only relation, and all corners are here.
        return terms.iter().all(|(_, weight)| *weight == terms[0].1);
    }
    let sorted = by_class(terms, &prime);
    if sorted.chunk_by(same_class).count() < count {
        return every_class_vanishes(terms, &prime, smaller, &rest);
    }
    // S_u over the conductor M = N/p, where N = pM: the exponent x of u/p + x/M.
    let aligned = |class: &[Classed<E, W>]| {
        let corner = corner_in_class(&class[0].class, &prime, &rest);
        shifted(class, |exponent| ((exponent + conductor.clone() - corner.clone()) % conductor.clone()) / prime.clone())
    };
    let mut classes = sorted.chunk_by(same_class);
    let first = classes.next().map(aligned).unwrap_or_default();
    classes.all(|class| {
        let negated = first.iter().map(|(exponent, weight)| (exponent.clone(), -weight.clone()));
        let difference = collect(aligned(class).into_iter().chain(negated));
        squarefree_vanishes(&difference, smaller, &rest)
    })
}

/// The multiple `u · rest` of `rest` that lies in a class modulo `prime`, with `0 ≤ u < prime`.
pub(super) fn corner_in_class<E: Exponent>(class: &E, prime: &E, rest: &E) -> E {
    let step = rest.clone() % prime.clone();
    let mut corner = E::zero();
    let mut reached = E::zero();
    while reached != *class {
        corner = corner + rest.clone();
        reached = (reached + step.clone()) % prime.clone();
    }
    corner
}

/// A term with the class of its exponent.
struct Classed<E, W> {
    class: E,
    exponent: E,
    weight: W,
}

/// The terms with their classes modulo `modulus`, sorted by class, then by exponent.
fn by_class<E: Exponent, W: Weight>(terms: &[(E, W)], modulus: &E) -> SmallVec<[Classed<E, W>; 16]> {
    let mut classed: SmallVec<[Classed<E, W>; 16]> = terms
        .iter()
        .map(|(exponent, weight)| Classed {
            class: exponent.clone() % modulus.clone(),
            exponent: exponent.clone(),
            weight: weight.clone(),
        })
        .collect();
    classed.sort_unstable_by(|a, b| (&a.class, &a.exponent).cmp(&(&b.class, &b.exponent)));
    classed
}

fn same_class<E: Eq, W>(a: &Classed<E, W>, b: &Classed<E, W>) -> bool {
    a.class == b.class
}

fn shifted<E: Exponent, W: Weight>(class: &[Classed<E, W>], exponent: impl Fn(E) -> E) -> Terms<E, W> {
    class.iter().map(|term| (exponent(term.exponent.clone()), term.weight.clone())).collect()
}

/// Like exponents added up, zeros dropped, exponents rising.
pub(super) fn collect<E: Exponent, W: Weight>(terms: impl Iterator<Item = (E, W)>) -> Terms<E, W> {
    let mut sorted: Terms<E, W> = terms.collect();
    sorted.sort_unstable_by(|a, b| a.0.cmp(&b.0));
    sorted.dedup_by(|next, kept| {
        let same = next.0 == kept.0;
        if same {
            kept.1 += next.1.clone();
        }
        same
    });
    sorted.retain(|(_, weight)| !weight.is_zero());
    sorted
}
