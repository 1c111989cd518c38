//! Is a sum over a small conductor zero? The product with one factor for each prime decides it, without sorting or dividing.
//!
//! With the primes `p` that divide `N`, `S` is zero iff all coefficients of `Π_p (1 − x^{N/p}) · Σ w_j x^{e_j}` modulo
//! `x^N − 1` are (theory, section 4).

use smallvec::SmallVec;

use super::terms::{Exponent, Weight};

/// Conductors up to this one are decided by the product: above, sorting the few terms costs less than all the coefficients.
const LARGEST: usize = 16;
/// The primes up to there, but 2.
const ODD_PRIMES: [usize; 5] = [3, 5, 7, 11, 13];

/// Whether the sum is zero; none where its conductor is not small, or an exponent is not below it.
pub(super) fn vanishes<E: Exponent, W: Weight>(conductor: &E, terms: &[(E, W)]) -> Option<bool> {
    let count = conductor.to_usize().filter(|count| *count <= LARGEST)?;
    let mut coefficients: SmallVec<[W; LARGEST]> = SmallVec::from_elem(W::zero(), count);
    for (exponent, weight) in terms {
        *coefficients.get_mut(exponent.to_usize()?)? += weight.clone();
    }
    // Each coefficient of the product is a sum of different weights with signs: none exceeds the sum of all moduli.
    for prime in ODD_PRIMES.into_iter().filter(|prime| count.is_multiple_of(*prime)) {
        let (head, tail) = coefficients.split_at(count - count / prime);
        let turned = tail.iter().chain(head);
        coefficients = coefficients.iter().zip(turned).map(|(one, other)| one.clone() - other.clone()).collect();
    }
    // For the prime 2 the coefficients half a turn apart are compared, in the place of their difference with 0.
    if count.is_multiple_of(2) {
        let (first, second) = coefficients.split_at(count / 2);
        return Some(first == second);
    }
    Some(coefficients.iter().all(W::is_zero))
}
