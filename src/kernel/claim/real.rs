//! Is a real sum below zero, a length within two numbers, a direction within two angles? Exactly: zero is decided, and what is not zero has a sign.

use std::cmp::Ordering;

use num_rational::BigRational;
use num_traits::Signed;

use crate::exact::{PhasorSum, Turn};
use crate::numbers;

/// Whether a real sum is below zero.
pub(super) fn is_negative(real: &PhasorSum) -> bool {
    numbers::sign(real) == Ordering::Less
}

/// Whether `½(|A| + |B|)` is no farther than `half` from a number.
pub(super) fn is_length_within(parts: [&PhasorSum; 2], written: &BigRational, half: &BigRational) -> bool {
    let squares = parts.map(PhasorSum::squared_modulus);
    let (low, high) = (written - half, written + half);
    let is_above = !low.is_positive() || compare(&squares, &low, false);
    is_above && !high.is_negative() && compare(&squares, &high, true)
}

/// Whether `½(√a + √b)` is at most `t`, or at least `t`, a number that is not below 0: `√a + √b ≤ 2t` where `s = 4t² − a − b` is not below 0, and
/// `s²` is not below `4ab`.
fn compare([a, b]: &[PhasorSum; 2], t: &BigRational, at_most: bool) -> bool {
    let four = BigRational::from_integer(4.into());
    let rest = numbers::number(&four * t * t).minus(a).minus(b);
    if is_negative(&rest) {
        return !at_most;
    }
    let (square, product) = (rest.times(&rest), a.times(b).scaled(&four));
    !is_negative(&if at_most { square.minus(&product) } else { product.minus(&square) })
}

/// Whether the direction of a sum that is not zero is no farther than `half` from an angle, both in turns, `half` below a quarter.
pub(super) fn is_direction_within(sum: &PhasorSum, written: &BigRational, half: &BigRational) -> bool {
    // z + z̄ is twice the part of z along direction 0; with z turned by a quarter, that across it.
    let along = |turns: BigRational| {
        let turned = sum.turned(&Turn::new(-turns));
        turned.plus(&turned.conjugate())
    };
    let quarter = BigRational::new(1.into(), 4.into());
    let ahead = along(written.clone());
    let is_ahead = !is_negative(&ahead) && !ahead.vanishes();
    is_ahead && !is_negative(&along(written + half - &quarter)) && !is_negative(&along(written - half + quarter))
}
