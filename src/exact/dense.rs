//! Is a sum over a small conductor zero? The product with one factor for each prime decides it, without sorting or dividing.
//!
//! With the primes `p` that matter ([`super::decide`]), `S` is zero iff all coefficients of
//! `Π_p (1 − x^{N/p}) · Σ w_j x^{e_j}` modulo `x^N − 1` are (theory, section 4).

use smallvec::SmallVec;

use super::decide::{Exponent, Weight, primes_up_to};

/// Conductors up to this one are decided by the product: above, sorting the few terms costs less than all the coefficients.
const LARGEST: usize = 24;

type Coefficients<W> = SmallVec<[W; LARGEST]>;

/// Whether the sum is zero; none where its conductor is not small, or an exponent is not below it.
pub(super) fn vanishes<E: Exponent, W: Weight>(conductor: &E, terms: &[(E, W)]) -> Option<bool> {
    let count = conductor.to_usize().filter(|count| *count <= LARGEST)?;
    let mut coefficients: Coefficients<W> = SmallVec::from_elem(W::zero(), count);
    for (exponent, weight) in terms {
        *coefficients.get_mut(exponent.to_usize()?)? += weight.clone();
    }
    let (primes, _) = primes_up_to(terms.len(), conductor);
    // Each coefficient of the product is a sum of different weights with signs: none exceeds the sum of all moduli.
    for prime in primes {
        let step = count / prime as usize;
        let turned = coefficients.iter().cycle().skip(count - step);
        coefficients = coefficients.iter().zip(turned).map(|(one, other)| one.clone() - other.clone()).collect();
    }
    Some(coefficients.iter().all(W::is_zero))
}
