//! How are fractions computed fast? In machine words, as nearly all of them are short: sums and products of [`BigRational`] ask for
//! memory at every step, and reduce by a gcd of numbers of any size.

use std::borrow::Borrow;
use std::cmp::Ordering;

use num_bigint::{BigInt, Sign};
use num_integer::Integer;
use num_rational::BigRational;
use num_traits::{One, Signed, Zero};

/// One word over another, which is above 0.
pub fn ratio(numerator: i64, denominator: i64) -> BigRational {
    let common = numerator.gcd(&denominator);
    BigRational::new_raw((numerator / common).into(), (denominator / common).into())
}

/// The sum of two fractions.
pub fn plus(one: &BigRational, other: &BigRational) -> BigRational {
    sum_in_machine_words(one, other, 1).map_or_else(|| one + other, reduced)
}

/// The first less the second.
pub fn minus(one: &BigRational, other: &BigRational) -> BigRational {
    sum_in_machine_words(one, other, -1).map_or_else(|| one - other, reduced)
}

/// The product of two fractions.
pub fn times(one: &BigRational, other: &BigRational) -> BigRational {
    words(one).zip(words(other)).map_or_else(|| one * other, |(one, other)| product(one, other))
}

/// The first divided by the second, which is not zero.
pub fn over(one: &BigRational, other: &BigRational) -> BigRational {
    let inverse = || words(other).filter(|(numerator, _)| *numerator != 0);
    let in_machine_words = words(one).zip(inverse()).map(|(one, (c, d))| product(one, (d * c.signum(), c.abs())));
    in_machine_words.unwrap_or_else(|| one / other)
}

/// Which is larger.
pub fn compare(one: &BigRational, other: &BigRational) -> Ordering {
    match words(one).zip(words(other)) {
        // Each product is below 2¹²⁶.
        Some(((a, b), (c, d))) => (i128::from(a) * i128::from(d)).cmp(&(i128::from(c) * i128::from(b))),
        None => one.cmp(other),
    }
}

/// The least common multiple of the denominators: 1 of none.
pub fn common_denominator(numbers: impl IntoIterator<Item: Borrow<BigRational>>) -> BigInt {
    numbers.into_iter().fold(BigInt::one(), |multiple, number| multiple.lcm(number.borrow().denom()))
}

/// The largest number of which all these are whole multiples: 0 where all are 0.
pub fn common_unit<'a>(numbers: impl IntoIterator<Item = &'a BigRational>) -> BigRational {
    let (divisor, multiple) =
        numbers.into_iter().fold((BigInt::zero(), BigInt::one()), |(divisor, multiple), number| {
            (divisor.gcd(number.numer()), multiple.lcm(number.denom()))
        });
    BigRational::new(divisor, multiple)
}

/// Decimals of a layout file end within so many places.
pub const MOST_PLACES: usize = 12;

/// A decimal where it ends within so many places, else a fraction: what a person would type.
pub fn written(value: &BigRational, most_places: usize) -> String {
    let ten = BigRational::from_integer(10.into());
    let (mut scaled, mut places) = (value.abs(), 0);
    while !scaled.is_integer() && places < most_places {
        scaled *= &ten;
        places += 1;
    }
    if !scaled.is_integer() {
        return value.to_string();
    }
    let sign = if value.is_negative() { "-" } else { "" };
    let digits = format!("{:0>width$}", scaled.to_integer().to_string(), width = places + 1);
    let (whole, fraction) = digits.split_at(digits.len() - places);
    format!("{sign}{whole}.{fraction}").trim_end_matches('.').to_owned()
}

/// `a/b ± c/d` with the gcd g of the denominators: `(a·d/g ± c·b/g) / (b·d/g)`, in which only a divisor of g is left to take out (Knuth,
/// The Art of Computer Programming, volume 2, section 4.5.1).
pub(super) fn sum_in_machine_words(one: &BigRational, other: &BigRational, sign: i128) -> Option<(i128, i128)> {
    let ((a, b), (c, d)) = (words(one)?, words(other)?);
    let common = if b == d { b } else { b.gcd(&d) };
    let (left, right) = (b / common, d / common);
    // Each product is below 2¹²⁶.
    let sum = i128::from(a) * i128::from(right) + sign * i128::from(c) * i128::from(left);
    let part = common_divisor(sum, common);
    Some((divided(sum, part), i128::from(left) * i128::from(d / part)))
}

/// The greatest common divisor of a sum and a word. Long words divide ten times slower, and few sums need them.
fn common_divisor(sum: i128, word: i64) -> i64 {
    match (word, i64::try_from(sum)) {
        (1, _) => 1,
        (_, Ok(sum)) => word.gcd(&sum),
        (_, Err(_)) => i64::try_from(sum % i128::from(word)).map_or(1, |rest| word.gcd(&rest)),
    }
}

fn divided(sum: i128, by: i64) -> i128 {
    match (by, i64::try_from(sum)) {
        (1, _) => sum,
        (_, Ok(sum)) => i128::from(sum / by),
        (_, Err(_)) => sum / i128::from(by),
    }
}

/// `a/b · c/d`: what is in common stands across, since either is reduced.
fn product((a, b): (i64, i64), (c, d): (i64, i64)) -> BigRational {
    let (first, second) = (a.gcd(&d), c.gcd(&b));
    let numerator = i128::from(a / first) * i128::from(c / second);
    reduced((numerator, i128::from(b / second) * i128::from(d / first)))
}

/// Numerator and denominator below 2⁶³.
pub(super) fn words(number: &BigRational) -> Option<(i64, i64)> {
    Some((word(number.numer())?, word(number.denom())?))
}

fn word(number: &BigInt) -> Option<i64> {
    let mut digits = number.iter_u64_digits();
    let size = i64::try_from(digits.next().unwrap_or(0)).ok()?;
    let size = if number.sign() == Sign::Minus { -size } else { size };
    (digits.len() == 0).then_some(size)
}

/// A fraction that is reduced.
pub(super) fn reduced((numerator, denominator): (i128, i128)) -> BigRational {
    // A long word becomes a number of any size digit by digit.
    let whole = |number: i128| i64::try_from(number).map_or_else(|_| number.into(), BigInt::from);
    BigRational::new_raw(whole(numerator), whole(denominator))
}
