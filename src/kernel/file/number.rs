//! What number did a person write? Taken exactly: `22.5`, `"3/2"`, `1e-3`.

use std::borrow::Cow;

use num_bigint::BigInt;
use num_rational::BigRational;
use num_traits::{ToPrimitive, Zero};

use crate::exact::fraction;

/// Longer numbers than this are refused by name.
const MOST_DIGITS: usize = 200;
/// Powers of ten beyond this are refused by name.
const LARGEST_EXPONENT: i32 = 100;

/// Why a text is not an exact number.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
pub enum NumberError {
    /// Not of the form `-12.5`, `3/2` or `1e-3`.
    #[error("not a number; write a decimal such as 22.5 or a fraction such as \"3/2\"")]
    NotANumber,
    /// A comma where the decimal point is.
    #[error("not a number; write a decimal point, as in 22.5")]
    DecimalComma,
    /// A fraction over 0.
    #[error("a fraction over 0; its denominator has to be 1 or more")]
    ZeroDenominator,
    /// More than 200 digits, or a power of ten beyond ±100.
    #[error("out of range; up to 200 digits and powers of ten up to 100 are read")]
    TooLong,
}

/// Reads a decimal or a fraction exactly as written.
///
/// ```standalone_crate
/// # use crankstar_kernel as crankstar;
/// use crankstar::file::parse_number;
/// assert_eq!(parse_number("22.5").unwrap().to_string(), "45/2");
/// assert_eq!(parse_number("-2/6").unwrap().to_string(), "-1/3");
/// assert!(parse_number("nan").is_err());
/// ```
///
/// # Errors
/// [`NumberError`] says what is not read.
pub fn parse_number(text: &str) -> Result<BigRational, NumberError> {
    let text = text.trim().replace('−', "-");
    if text.chars().count() > MOST_DIGITS {
        return Err(NumberError::TooLong);
    }
    match text.split_once('/') {
        None => decimal(&text),
        // `7/3e1` might be 70/3 or 7/30.
        Some((_, denominator)) if denominator.contains(['e', 'E']) => Err(NumberError::NotANumber),
        Some((numerator, denominator)) => {
            let (numerator, denominator) = (decimal(numerator.trim_end())?, decimal(denominator.trim_start())?);
            if denominator.is_zero() {
                Err(NumberError::ZeroDenominator)
            } else {
                Ok(fraction::over(&numerator, &denominator))
            }
        }
    }
}

fn decimal(text: &str) -> Result<BigRational, NumberError> {
    let (mantissa, exponent) = match text.split_once(['e', 'E']) {
        Some((mantissa, exponent)) => (mantissa, integer_text(exponent)?),
        None => (text, "0"),
    };
    let exponent: i32 = exponent.parse().map_err(|_| NumberError::TooLong)?;
    if exponent.abs() > LARGEST_EXPONENT {
        return Err(NumberError::TooLong);
    }
    let (is_negative, unsigned) = match mantissa.as_bytes().first() {
        Some(b'-') => (true, &mantissa[1..]),
        Some(b'+') => (false, &mantissa[1..]),
        _ => (false, mantissa),
    };
    let (whole, behind) = unsigned.split_once('.').unwrap_or((unsigned, ""));
    let digits = if behind.is_empty() { Cow::Borrowed(whole) } else { Cow::Owned(format!("{whole}{behind}")) };
    if digits.is_empty() || !digits.bytes().all(|byte| byte.is_ascii_digit()) {
        let is_digit = |byte: u8| byte.is_ascii_digit() || byte == b',';
        let has_comma = digits.matches(',').count() == 1 && !unsigned.contains('.') && digits.bytes().all(is_digit);
        return Err(if has_comma { NumberError::DecimalComma } else { NumberError::NotANumber });
    }
    let places = i32::try_from(behind.len()).map_err(|_| NumberError::TooLong)?;
    // Nearly every number is a word over a power of ten that is one.
    let power = (places - exponent).to_u32().and_then(|power| 10_i64.checked_pow(power));
    if let Some((digits, power)) = digits.parse::<i64>().ok().zip(power) {
        return Ok(fraction::ratio(if is_negative { -digits } else { digits }, power));
    }
    let digits: BigInt = digits.parse().map_err(|_| NumberError::NotANumber)?;
    let sign = BigInt::from(if is_negative { -1 } else { 1 });
    let ten = BigRational::from_integer(10.into());
    Ok(BigRational::from_integer(sign * digits) * ten.pow(exponent - places))
}

fn integer_text(text: &str) -> Result<&str, NumberError> {
    let digits = text.strip_prefix(['-', '+']).unwrap_or(text);
    let is_integer = !digits.is_empty() && digits.bytes().all(|byte| byte.is_ascii_digit());
    if is_integer { Ok(text.strip_prefix('+').unwrap_or(text)) } else { Err(NumberError::NotANumber) }
}
