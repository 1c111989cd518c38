//! Do the decimals beside a verdict fit the exact sum? Compared with an enclosure that is made as narrow as it takes.

use num_bigint::BigInt;
use num_rational::BigRational;
use num_traits::{One, Signed, Zero};
use serde::ser::Error;
use serde::{Deserialize, Serialize, Serializer};

use super::audit::{Audit, Reason, squared_words, steps_of};
use super::ball::{Ball, Complex};
use super::collected::{Collected, common_multiple};
use super::enclosure::Circle;
use super::refusal::Refusal;

/// A decimal for reading; no verdict is made from it.
#[expect(clippy::disallowed_types, reason = "decimals beside a verdict are shown and never used")]
pub type Decimal = f64;

/// A decimal that is 0 or more.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(try_from = "Decimal")]
pub(super) struct Size(Decimal);

impl Size {
    /// Whether it is 0.
    pub(super) fn is_nothing(self) -> bool {
        self.0 == 0.0
    }

    pub(super) fn shown(self) -> Decimal {
        self.0
    }
}

impl TryFrom<Decimal> for Size {
    type Error = &'static str;

    fn try_from(size: Decimal) -> Result<Self, Self::Error> {
        if size < 0.0 { Err("a size is not below 0") } else { Ok(Size(size)) }
    }
}

/// Writes the length of a sum; one beyond the range of decimals is no number, and no document is written that lacks it.
pub(super) fn length_in_range<S: Serializer>(length: &Decimal, serializer: S) -> Result<S::Ok, S::Error> {
    match length.is_finite() {
        true => serializer.serialize_f64(*length),
        false => Err(S::Error::custom(
            "a length is beyond the range of decimals; write the masses and lengths in other units",
        )),
    }
}

/// A correct decimal is off by less than this power of two of itself: a few units in the last place.
const ACCURACY: u32 = 50;
/// Directions nearer than this power of two of a turn are not distinguished.
const FINEST_TURN: u32 = 150;
/// Bits behind the point at the first attempt, and at the last.
const FIRST_BITS: u32 = 256;
const MOST_BITS: u32 = 1 << 14;

/// What the enclosure says of a decimal.
enum Answer {
    Fits,
    Differs,
    Unclear,
}

/// Checks `|S|` and the direction of S in degrees, each to a few units in the last place, however much the terms cancel.
pub(super) fn check_decimals(
    sum: &Collected,
    vanishes: bool,
    modulus: Decimal,
    angle_deg: Option<Decimal>,
    audit: &Audit,
) -> Result<(), Reason> {
    let Some(modulus) = BigRational::from_float(modulus) else { return Err("`modulus` is not a number".into()) };
    let angle = match (vanishes, angle_deg) {
        (true, None) if modulus.is_zero() => {
            audit.count_decimals(1);
            return Ok(());
        }
        (true, None) => return Err("`modulus` is 0 where the sum vanishes".into()),
        (true, Some(_)) | (false, None) => return Err("`angle_deg` is null exactly where the sum vanishes".into()),
        (false, Some(angle)) => BigRational::from_float(angle).ok_or("`angle_deg` is not a number")?,
    };
    let half_turn = BigRational::from_integer(180.into());
    if !modulus.is_positive() || angle > half_turn || angle <= -half_turn {
        return Err("`modulus` is positive and `angle_deg` lies between -180 and 180".into());
    }
    let scale = scale([sum], audit)?;
    let modulus = modulus * BigRational::from_integer(scale.clone());
    let mut bits = FIRST_BITS;
    while bits <= MOST_BITS {
        let Complex { re, im } = enclose(sum, &scale, &audit.circle(bits), audit)?;
        let parts = [re, im];
        match (length(&parts, &modulus, bits), direction(&parts, &angle, &audit.circle(bits))) {
            (Answer::Fits, Answer::Fits) => {
                audit.count_decimals(2);
                return Ok(());
            }
            (Answer::Differs, _) => return Err("`modulus` does not fit the terms".into()),
            (_, Answer::Differs) => return Err("`angle_deg` does not fit the terms".into()),
            (Answer::Unclear, _) | (_, Answer::Unclear) => bits *= 2,
        }
    }
    Err(format!("{MOST_BITS} bits do not show whether `modulus` and `angle_deg` fit the terms").into())
}

/// The least whole number that makes all weights of these sums whole.
pub(super) fn scale<'a>(sums: impl IntoIterator<Item = &'a Collected>, audit: &Audit) -> Result<BigInt, Refusal> {
    sums.into_iter().flat_map(Collected::values).try_fold(BigInt::one(), |scale, weight| {
        audit.spend(squared_words(&scale) + steps_of(weight))?;
        Ok(common_multiple(&scale, weight.denom()))
    })
}

/// `S · scale`, to the bits of the circle.
pub(super) fn enclose(sum: &Collected, scale: &BigInt, circle: &Circle, audit: &Audit) -> Result<Complex, Refusal> {
    let (mut re, mut im, mut doubt) = (BigInt::zero(), BigInt::zero(), BigInt::zero());
    for (angle, weight) in sum {
        audit.spend(circle.steps() + steps_of(angle) + squared_words(scale))?;
        let whole = weight.numer() * (scale / weight.denom());
        let (cos, sin) = circle.cos_sin(angle);
        re += &whole * cos;
        im += &whole * sin;
        doubt += whole.abs() * 2;
    }
    Ok(Complex { re: Ball { middle: re, doubt: doubt.clone() }, im: Ball { middle: im, doubt } })
}

/// Whether `|S|` is this, up to the accuracy: squares are compared.
fn length([re, im]: &[Ball; 2], modulus: &BigRational, bits: u32) -> Answer {
    let ([re_least, re_most], [im_least, im_most]) = (re.sizes(), im.sizes());
    let least = BigRational::from_integer(&re_least * &re_least + &im_least * &im_least);
    let most = BigRational::from_integer(&re_most * &re_most + &im_most * &im_most);
    let stated = modulus * BigRational::from_integer(BigInt::one() << bits);
    let slack = &stated * power_of_two(ACCURACY);
    let square = |number: BigRational| &number * &number;
    let (low, high) = (square(&stated - &slack), square(stated + slack));
    if low <= least && most <= high {
        Answer::Fits
    } else if most < low || high < least {
        Answer::Differs
    } else {
        Answer::Unclear
    }
}

/// Whether S turned back by this angle points along 0, up to the accuracy.
fn direction([re, im]: &[Ball; 2], degrees: &BigRational, circle: &Circle) -> Answer {
    let (cos, sin) = circle.cos_sin(&(degrees / BigRational::from_integer(360.into())));
    let bits = circle.bits();
    // |cos| + |sin| < 3/2, and each is off by less than 2 units itself.
    let sizes = re.middle.abs() + im.middle.abs() + &re.doubt * 2;
    let doubt: BigInt = &re.doubt * 3 + ((sizes * 2) >> bits) + 3;
    let along = Ball { middle: (&re.middle * &cos + &im.middle * &sin) >> bits, doubt: doubt.clone() };
    let across = Ball { middle: (&im.middle * &cos - &re.middle * &sin) >> bits, doubt };
    let [along_least, along_most] = along.sizes();
    let [across_least, across_most] = across.sizes();
    // The tangent of the slack: 7/400 is above π/180.
    let tangent =
        degrees.abs() * BigRational::new(7.into(), 400.into()) * power_of_two(ACCURACY) + power_of_two(FINEST_TURN);
    let reach = |along: BigInt| BigRational::from_integer(along) * &tangent;
    let is_ahead = along.middle.is_positive() && !along_least.is_zero();
    let is_behind = along.middle.is_negative() && !along_least.is_zero();
    if is_ahead && BigRational::from_integer(across_most) <= reach(along_least) {
        Answer::Fits
    } else if is_behind || BigRational::from_integer(across_least) > reach(along_most) {
        Answer::Differs
    } else {
        Answer::Unclear
    }
}

/// `2^−minus`.
pub(super) fn power_of_two(minus: u32) -> BigRational {
    BigRational::new(BigInt::one(), BigInt::one() << minus)
}
