//! How does a value become a cell? Each as its type: decimals as they are, exact numbers as text.

use num_bigint::BigInt;
use num_integer::Integer;
use num_rational::BigRational;
use num_traits::{One, Signed, ToPrimitive};

use crate::table::Values;

/// Digits behind the point from which on a fraction is shorter.
const MOST_PLACES: u32 = 12;

/// A rational number: a decimal where it ends, else a fraction.
///
/// ```
/// use crankstar::BigRational;
/// use crankstar::data::exact_number;
/// assert_eq!(exact_number(&BigRational::new((-1).into(), 40.into())), "-0.025");
/// assert_eq!(exact_number(&BigRational::new(1.into(), 3.into())), "1/3");
/// ```
pub fn exact_number(value: &BigRational) -> String {
    if let Some(text) = in_i64(value) {
        return text;
    }
    let mut rest = value.denom().clone();
    let mut places = 0_u32;
    let ten = BigInt::from(10);
    while !rest.is_one() {
        let common = rest.gcd(&ten);
        if common.is_one() || places > MOST_PLACES {
            return value.to_string();
        }
        rest /= common;
        places += 1;
    }
    let scaled = (value * BigRational::from_integer(ten.pow(places))).to_integer();
    with_point(scaled.is_negative(), scaled.abs(), places)
}

/// The same of a number that fits into machine words, of which a sweep has millions.
fn in_i64(value: &BigRational) -> Option<String> {
    let (numerator, denominator) = (value.numer().to_i64()?, value.denom().to_u64()?);
    let twos = denominator.trailing_zeros();
    let (mut rest, mut fives) = (denominator >> twos, 0_u32);
    while rest.is_multiple_of(5) {
        rest /= 5;
        fives += 1;
    }
    let places = twos.max(fives);
    if rest > 1 || places > MOST_PLACES + 1 {
        return Some(if denominator == 1 { numerator.to_string() } else { format!("{numerator}/{denominator}") });
    }
    let scaled = i128::from(numerator) * (10_i128.pow(places) / i128::from(denominator));
    Some(with_point(scaled < 0, scaled.unsigned_abs(), places))
}

/// A number of this many digits behind the point.
fn with_point(is_negative: bool, size: impl std::fmt::Display, places: u32) -> String {
    let sign = if is_negative { "-" } else { "" };
    let text = format!("{size:0>width$}", width = places as usize + 1);
    match text.split_at(text.len() - places as usize) {
        (whole, "") => format!("{sign}{whole}"),
        (whole, part) => format!("{sign}{whole}.{part}"),
    }
}

/// Decimals; what is beyond decimals is omitted.
pub fn decimals(values: impl IntoIterator<Item = Option<f64>>) -> Values {
    // −0 is 0.
    Values::Decimal(values.into_iter().map(|value| value.filter(|value| value.is_finite()).map(|v| v + 0.0)).collect())
}

/// Whole numbers that there are in every row.
pub fn whole<N: TryInto<i64>>(values: impl IntoIterator<Item = N>) -> Values {
    Values::Integer(values.into_iter().map(|value| value.try_into().ok()).collect())
}

/// True, false, or not decided.
pub fn truths(values: impl IntoIterator<Item = Option<bool>>) -> Values {
    Values::Truth(values.into_iter().collect())
}
