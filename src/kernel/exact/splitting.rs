//! Which path of classes shows that a sum is not zero, whatever its conductor?
//!
//! Where a conductor is too large for a prime with a root of that order, the decision itself is the evidence: each
//! step keeps a part that would be zero if the whole were (theory, section 4), until one vector is left.

use num_bigint::{BigInt, BigUint};
use num_rational::BigRational;
use num_traits::One;

use super::decide::{collect, corner_in_class, primes_up_to, vanishes};
use super::terms::{Exponent, Weight, classes};
use crate::proof::Step;

type Terms = Vec<(BigUint, BigInt)>;

/// Steps that lead from a sum that is not zero to a single vector.
pub(super) fn find<E: Exponent, W: Weight>(conductor: &E, terms: &[(E, W)]) -> Vec<Step> {
    let mut steps = Vec::new();
    let mut conductor: BigUint = conductor.clone().into();
    let mut terms: Terms =
        terms.iter().map(|(exponent, weight)| (exponent.clone().into(), weight.clone().into())).collect();
    while terms.len() > 1 {
        let (primes, product) = primes_up_to(terms.len(), &conductor);
        let (step, next_conductor, next_terms) = if product == conductor {
            let Some(&prime) = primes.last() else { unreachable!("over conductor 1 one direction remains") };
            compare(&terms, &conductor, prime)
        } else {
            keep_class(&terms, &conductor, product)
        };
        steps.push(step);
        (conductor, terms) = (next_conductor, next_terms);
    }
    steps
}

/// The shortest class that is not zero among those that must vanish by themselves.
fn keep_class(terms: &Terms, conductor: &BigUint, product: BigUint) -> (Step, BigUint, Terms) {
    let step = conductor / &product;
    let reduced = classes(terms, &step).into_values().filter_map(|class| {
        let first = class[0].0.clone();
        let terms: Terms = class.into_iter().map(|(e, w)| ((e - &first) / &step, w)).collect();
        (!vanishes(&product, &terms)).then_some((first, terms))
    });
    let Some((first, kept)) = reduced.min_by_key(|(_, terms)| terms.len()) else {
        unreachable!("a sum is zero where all its classes are")
    };
    let angle = BigRational::new(first.into(), conductor.clone().into());
    (Step::Class { angle, modulus: product.clone().into() }, product, kept)
}

/// Two classes modulo the largest prime that differ.
fn compare(terms: &Terms, conductor: &BigUint, largest: u32) -> (Step, BigUint, Terms) {
    let prime = BigUint::from(largest);
    let rest = conductor / &prime;
    let corner = |u: u32| &rest * u;
    let class = |u: u32| -> Terms {
        let corner = corner(u);
        let label = &corner % &prime;
        debug_assert_eq!(corner_in_class(&label, &prime, &rest), corner);
        let members = terms.iter().filter(|(exponent, _)| exponent % &prime == label);
        members.map(|(e, w)| ((e + conductor - &corner) % conductor / &prime, w.clone())).collect()
    };
    let first = class(0);
    let differences = (1..largest).filter_map(|u| {
        let negated = class(u).into_iter().map(|(exponent, weight)| (exponent, -weight));
        let difference = collect(first.iter().cloned().chain(negated)).into_vec();
        (!vanishes(&rest, &difference)).then_some((u, difference))
    });
    let Some((second, kept)) = differences.min_by_key(|(_, terms)| terms.len()) else {
        unreachable!("a sum is zero where all its classes modulo a prime are equal")
    };
    assert!(!rest.is_one() || kept.len() == 1);
    (Step::Compare { prime: largest.into(), first: 0, second: second.into() }, rest, kept)
}
