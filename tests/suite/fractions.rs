//! Are fractions in machine words the same numbers as fractions of any size, down to how they are reduced?

use crate::support::dice::Dice;
use crankstar::exact::fraction;
use num_bigint::BigInt;
use num_integer::Integer;
use num_rational::BigRational;
use num_traits::{One, Signed, Zero};

/// A whole number of up to this many bits, of either sign, often 0, 1 or at the end of a machine word.
fn whole(dice: &mut Dice, bits: u64) -> BigInt {
    let size = match dice.below(6) {
        0 => BigInt::from(dice.below(13)),
        1 => (BigInt::one() << dice.below(bits + 1)) - dice.below(3) as i64 + 1,
        2 => (BigInt::from(dice.below(u64::MAX)) * dice.below(u64::MAX)) >> (128 - bits),
        _ => BigInt::from(dice.below(1 << bits.min(63))),
    };
    if dice.below(2) == 0 { size } else { -size }
}

fn ratio(dice: &mut Dice) -> BigRational {
    let bits = [4, 16, 32, 62, 63, 64, 65, 128][dice.below(8) as usize];
    let below = whole(dice, bits).abs().max(BigInt::one());
    BigRational::new(whole(dice, bits), below)
}

/// A second fraction that has much in common with the first: its denominator, its numerator, or both.
fn kin(dice: &mut Dice, one: &BigRational) -> BigRational {
    let other = ratio(dice);
    match dice.below(5) {
        0 => BigRational::new(other.numer().clone(), one.denom().clone()),
        1 if !one.is_zero() => BigRational::new(other.numer() * one.denom(), one.numer().clone()),
        2 => -one,
        3 => one.clone(),
        _ => other,
    }
}

#[test]
fn sums_products_and_comparisons_are_those_of_any_size() {
    let mut dice = Dice::new(20);
    let (mut short, mut long) = (0, 0);
    for _ in 0..40_000 {
        let one = ratio(&mut dice);
        let other = kin(&mut dice, &one);
        let said = [fraction::plus(&one, &other), fraction::minus(&one, &other), fraction::times(&one, &other)];
        let meant = [&one + &other, &one - &other, &one * &other];
        for (said, meant) in said.into_iter().zip(meant) {
            assert_eq!((said.numer(), said.denom()), (meant.numer(), meant.denom()), "of {one} and {other}");
            assert!(said.denom().is_positive() && said.numer().gcd(said.denom()).is_one(), "of {one} and {other}");
        }
        if !other.is_zero() {
            let (said, meant) = (fraction::over(&one, &other), &one / &other);
            assert_eq!((said.numer(), said.denom()), (meant.numer(), meant.denom()), "of {one} and {other}");
        }
        assert_eq!(fraction::compare(&one, &other), one.cmp(&other), "{one} {other}");
        let is_short = [&one, &other].into_iter().all(|number| number.numer().bits().max(number.denom().bits()) < 64);
        *(if is_short { &mut short } else { &mut long }) += 1;
    }
    assert!(short > 5_000 && long > 5_000, "{short} {long}");
}
