//! Are the sizes and directions beside the evidence those of its sums?

use num_bigint::BigInt;
use num_rational::BigRational;
use num_traits::{One, Signed};

use super::agreement::agrees;
use super::audit::{Audit, Fault, Reason, demand, refuse_if};
use super::ball::Ball;
use super::coefficient::{Coefficient, Factor};
use super::decimals::{Decimal, Size, power_of_two};
use super::judged::Judged;
use super::motion::{Motion, smallness};
use super::rod::RodClaim;
use super::whole_sum::value;

/// A decimal is off by less than this power of two of itself: some hundred units in the last place, as it is a product of others.
const ACCURACY: u32 = 44;
/// Where terms cancel, by less than this power of two of them.
const OF_TERMS: u32 = 80;
/// Nothing below this power of two has all digits of a decimal.
const SMALLEST: u32 = 1000;
/// Bits of directions.
const BITS: u32 = 128;

/// A number that is 0 or more, and what decimals of it may be off.
pub(super) struct Length {
    pub value: BigRational,
    pub slack: BigRational,
}

impl Length {
    /// To 64 bits at least: no root is smaller than the inverse of the denominator.
    fn new(square: &BigRational, doubt: BigRational) -> Self {
        let bits = square.denom().bits() + 64;
        let root = ((square.numer() << (2 * bits)) / square.denom()).sqrt();
        Length::of(BigRational::new(root, BigInt::one() << bits), doubt)
    }

    pub fn of(value: BigRational, doubt: BigRational) -> Self {
        Length { slack: &value * power_of_two(ACCURACY) + doubt, value }
    }

    /// Checks a decimal of it in this unit, which is 0 where the evidence proves that it is, and at rest.
    pub fn is_size(&self, at: &str, size: Size, unit: &BigRational, is_zero: bool) -> Result<(), Fault> {
        agrees(at, size, is_zero || !unit.is_positive())?;
        is_near(at, size.shown(), &(&self.value * unit), &(&self.slack * unit))
    }
}

/// A vector that decimals stand for.
pub(super) struct Shown {
    re: BigRational,
    im: BigRational,
    pub length: Length,
}

impl Shown {
    /// What is left of an order in a sense, in multiples of m r ω².
    pub fn of(judged: &Judged, sense: usize, motion: &Motion<'_>) -> Result<Self, Reason> {
        let [re, im, terms] = value(judged, sense, motion)?;
        Ok(Shown::new(re, im, terms * power_of_two(OF_TERMS)))
    }

    pub fn new(re: BigRational, im: BigRational, doubt: BigRational) -> Self {
        Shown { length: Length::new(&(&re * &re + &im * &im), doubt), re, im }
    }

    fn times(&self, other: &Shown) -> Self {
        let (re, im) = (&self.re * &other.re - &self.im * &other.im, &self.re * &other.im + &self.im * &other.re);
        let doubt = &self.length.value * &other.length.slack + &other.length.value * &self.length.slack;
        Shown::new(re, im, doubt)
    }

    /// Checks both parts of a number.
    pub fn has_parts(&self, at: &str, parts: [Decimal; 2]) -> Result<(), Fault> {
        let rights = [&self.re, &self.im];
        parts.into_iter().zip(rights).try_for_each(|(part, right)| is_near(at, part, right, &self.length.slack))
    }

    /// Checks its direction in degrees: one of `full` of them, half of these at most; none where the evidence proves that it is zero.
    pub fn points(
        &self,
        at: &str,
        degrees: Option<Decimal>,
        full: i32,
        vanishes: Option<bool>,
        audit: &Audit,
    ) -> Result<(), Fault> {
        let Length { value, slack } = &self.length;
        let Some(degrees) = degrees else {
            let may_lack = vanishes != Some(false) || *value < power_of_two(SMALLEST);
            return demand(may_lack, Fault::new(at, "what is not zero has a direction"));
        };
        refuse_if(vanishes == Some(true), Fault::new(at, "what is zero has no direction"))?;
        let turns = BigRational::from_float(degrees).unwrap_or_default() / BigRational::from_integer(full.into());
        let (cos, sin) = audit.circle(BITS).cos_sin(&turns);
        let part = |unit: BigInt| BigRational::new(unit, BigInt::one() << BITS) * value;
        let is_along = (part(cos) - &self.re).abs() <= *slack && (part(sin) - &self.im).abs() <= *slack;
        let is_there = is_along && turns <= half() && turns > -half();
        demand(is_there, Fault::new(at, "it is not the direction of the evidence"))
    }
}

/// What both vectors of an order trace, in multiples of m r ω².
pub(super) struct Swing {
    pub sums: [Shown; 2],
    pub largest: Length,
    pub smallest: BigRational,
    /// Along direction 0 and across it.
    pub parts: [BigRational; 2],
    /// Twice as far round as the longer axis.
    pub axis: Shown,
}

impl Swing {
    pub fn of(judged: &Judged, motion: &Motion<'_>) -> Result<Self, Reason> {
        let [mut direct, mut reverse] = [Shown::of(judged, 0, motion)?, Shown::of(judged, 1, motion)?];
        for one in [&mut direct, &mut reverse] {
            *one = Shown::new(&one.re * half(), &one.im * half(), &one.length.slack * half());
        }
        let (a, b) = (&direct.length, &reverse.length);
        let largest = Length { value: &a.value + &b.value, slack: &a.slack + &b.slack };
        let smallest = (&a.value - &b.value).abs();
        let [along, across] = [1, -1].map(|sign| {
            let sign = BigRational::from_integer(sign.into());
            Shown::new(&direct.re + &reverse.re * &sign, &direct.im - &reverse.im * sign, BigRational::default())
        });
        let (axis, parts) = (direct.times(&reverse), [along.length.value, across.length.value]);
        Ok(Swing { sums: [direct, reverse], largest, smallest, parts, axis })
    }
}

/// c_k of a rod whose motion has the order.
pub(super) fn of_rod(rod: &RodClaim, order: u32, motion: &Motion<'_>) -> Result<Shown, Reason> {
    refuse_if(Factor::of_rod(rod, order).is_zero, "the motion has no such order")?;
    let coefficient = Coefficient::Rod(rod.clone());
    let below_one = u32::try_from(smallness(&coefficient, order, motion.audit())?).map_err(|_| Reason::TooManySteps)?;
    let bits = below_one.saturating_add(BITS);
    let number = motion.coefficient(&coefficient, order, bits)?.ok_or("the rods are not known")?;
    let part = |part: Ball| BigRational::new(part.middle, BigInt::one() << bits);
    Ok(Shown::new(part(number.re), part(number.im), BigRational::default()))
}

/// Checks a decimal.
pub(super) fn is_near(at: &str, stated: Decimal, right: &BigRational, slack: &BigRational) -> Result<(), Fault> {
    let stated = BigRational::from_float(stated).unwrap_or_default();
    let is_near = (stated - right).abs() <= slack + power_of_two(SMALLEST);
    demand(is_near, Fault::new(at, "it is not what the evidence says"))
}

fn half() -> BigRational {
    BigRational::new(1.into(), 2.into())
}
