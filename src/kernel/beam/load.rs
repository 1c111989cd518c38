//! What does a load do to the supports beside it, and to the three-moment equations there?

use num_bigint::BigInt;
use num_rational::BigRational;
use num_traits::{Signed, Zero};

/// A unit load on one span or overhanging it, all quantities whole multiples of 1/scale.
#[derive(Debug)]
pub(super) struct Load {
    /// Index of the span; its ends are the supports `span` and `span + 1`.
    pub span: usize,
    /// The common denominator, positive.
    pub scale: BigInt,
    /// What each end of the span carries of the load as long as no moment acts there.
    pub shares: [BigInt; 2],
    /// Right-hand sides of the three-moment equations at the ends of the span.
    pub right_sides: [BigInt; 2],
    /// Moments at the ends of the span that are known beforehand, sagging positive: not zero under an overhang only.
    pub end_moments: [BigInt; 2],
}

/// Index of the span that a place is on, the outer ones prolonged without end.
pub(super) fn span_of(place: &BigRational, places: &[BigInt]) -> usize {
    let inner = &places[1..places.len() - 1];
    inner.partition_point(|support| place.numer() > &(support * place.denom()))
}

impl Load {
    /// The unit load at a place.
    pub fn new(place: &BigRational, places: &[BigInt]) -> Self {
        let span = span_of(place, places);
        let length = &places[span + 1] - &places[span];
        // Distances from the left and the right end of the span, times the denominator q of the place.
        let q = place.denom();
        let a = place.numer() - &places[span] * q;
        let b = &places[span + 1] * q - place.numer();
        let zeros = || [BigInt::zero(), BigInt::zero()];
        if a.is_negative() {
            // The end moment is a; its term in the equation at the next support is on the right.
            let right_sides = [BigInt::zero(), -&a * &length];
            let shares = [q.clone(), BigInt::zero()];
            return Load { span, scale: q.clone(), shares, right_sides, end_moments: [a, BigInt::zero()] };
        }
        if b.is_negative() {
            let right_sides = [-&b * &length, BigInt::zero()];
            let shares = [BigInt::zero(), q.clone()];
            return Load { span, scale: q.clone(), shares, right_sides, end_moments: [BigInt::zero(), b] };
        }
        // −b(l² − b²)/l = −ab(l + b)/l and −a(l² − a²)/l = −ab(l + a)/l, with a + b = l; here over q³l.
        let whole = &length * q;
        let product = -(&a * &b);
        let right_sides = [&product * (&whole + &b), &product * (&whole + &a)];
        let shares = [b * q * q, a * q * q];
        Load { span, scale: whole * q * q, shares, right_sides, end_moments: zeros() }
    }
}
