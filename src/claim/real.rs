//! Is a real sum below zero, a length within two numbers, a direction within two angles? Exactly: zero is decided, and what is not zero has a sign.

use num_rational::BigRational;
use num_traits::Signed;

use crate::exact::{PhasorSum, Turn};
use crate::numbers;

/// Whether a real sum is below zero: zero is decided exactly, and what is not zero has a sign that enough bits show.
pub(super) fn is_negative(real: &PhasorSum) -> bool {
    if real.vanishes() {
        return false;
    }
    let mut bits = 64;
    loop {
        let [(low, high), _] = numbers::enclose(real, bits);
        if low.is_positive() {
            return false;
        }
        if high.is_negative() {
            return true;
        }
        bits *= 2;
    }
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
    let difference = || rest.times(&rest).minus(&a.times(b).scaled(&four));
    match (at_most, is_negative(&rest)) {
        (true, true) => false,
        (true, false) => !is_negative(&difference()),
        (false, true) => true,
        (false, false) => !is_negative(&difference().scaled(&-BigRational::from_integer(1.into()))),
    }
}

/// Whether the direction of a sum that is not zero is no farther than `half` from an angle, both in turns, `half` below a quarter.
pub(super) fn is_direction_within(sum: &PhasorSum, written: &BigRational, half: &BigRational) -> bool {
    // i(z − z̄) is −2 times the part of z across direction 0.
    let across = |turns: BigRational| {
        let turned = sum.turned(&Turn::new(-turns));
        turned.minus(&turned.conjugate()).turned(&Turn::fraction(1, 4))
    };
    let turned = sum.turned(&Turn::new(-written.clone()));
    let ahead = turned.plus(&turned.conjugate());
    !is_negative(&ahead) && !ahead.vanishes() && !is_negative(&across(written + half)) && {
        let behind = across(written - half);
        behind.vanishes() || is_negative(&behind)
    }
}
