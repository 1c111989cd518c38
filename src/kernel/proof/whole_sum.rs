//! Is the whole of an order zero, where its sums are multiplied by different numbers of the motion?

use num_bigint::BigInt;
use num_rational::BigRational;
use num_traits::{One, Signed};
use serde::{Deserialize, Serialize};

use super::audit::{Audit, Reason};
use super::ball::Complex;
use super::decimals::{Decimal, enclose, scale};
use super::enclosure::check_bits;
use super::judged::{Judged, JudgedGroup};
use super::motion::{Motion, smallness};
use super::quantity::{Quantity, Sense};
use super::refusal::Refusal;
use super::rod::MOST_BITS;

/// The bits that what is not decided is enclosed with.
const BITS_OF_DOUBT: u32 = 256;
/// The bits that decimals are compared with.
const BITS_OF_DECIMALS: u32 = 128;
/// Bits beyond those that are asked for.
const GUARD: u64 = 64;
/// What is not decided is below `10^−DIGITS_OF_DOUBT` of its terms.
const DIGITS_OF_DOUBT: u32 = 15;

/// Whether the whole of one order is zero, with the evidence beyond that of its sums.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct WholeClaim {
    /// Force, moment or torque.
    pub quantity: Quantity,
    /// The order k.
    pub order: u32,
    /// Direct or reverse; none for the torque.
    pub sense: Option<Sense>,
    /// What is said of it.
    pub outcome: WholeOutcome,
}

/// What is said of the whole of an order.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case", deny_unknown_fields)]
pub enum WholeOutcome {
    /// Every sum is zero, or is multiplied by zero.
    Zero,
    /// One sum is left, and its coefficient is not zero, by a theorem.
    NotZero,
    /// Several sums are left, or one before a coefficient that no theorem tells from zero, and an enclosure with this many bits keeps away from zero.
    NotZeroByEnclosure {
        /// From 32 to 512.
        bits: u32,
    },
    /// Such sums are left, and the whole is closer to zero than an enclosure tells apart.
    NotDecided {
        /// A bound of its length.
        below: Decimal,
    },
    /// Several sums are left, and one is multiplied by the coefficient of a rod that is not named.
    Open,
}

/// Checks what is said of the whole in one sense, by its place; returns whether it is zero, where that is decided.
pub(super) fn check_whole(
    claim: &WholeClaim,
    judged: &Judged,
    sense: usize,
    motion: &Motion<'_>,
) -> Result<Option<bool>, Reason> {
    let left = judged.left(sense);
    let is_certain = left.len() == 1 && left.iter().all(|group| !group.coefficient.may_be_zero());
    let is_open = left.len() > 1 && left.iter().any(|group| group.coefficient.is_open());
    match (claim.outcome, left.len()) {
        (WholeOutcome::Zero, 0) => Ok(Some(true)),
        (_, 0) => Err("it is `zero`: no sum remains before a coefficient that is not".into()),
        (WholeOutcome::NotZero, _) if is_certain => Ok(Some(false)),
        _ if is_certain => Err("it is `not-zero`: one sum remains, before a coefficient that is not zero".into()),
        (WholeOutcome::Open, _) if is_open => Ok(None),
        _ if is_open => Err("it is `open`: the rods are not known".into()),
        (WholeOutcome::Zero | WholeOutcome::NotZero | WholeOutcome::Open, 1) => {
            Err("a sum remains before a coefficient that may be zero, which takes an enclosure".into())
        }
        (WholeOutcome::Zero | WholeOutcome::NotZero | WholeOutcome::Open, count) => {
            Err(format!("{count} sums remain before known coefficients, which takes an enclosure").into())
        }
        (WholeOutcome::NotZeroByEnclosure { bits }, _) => {
            let whole = Enclosure::of_bits(judged, &[sense], bits, motion)?;
            match whole.sum(judged, sense, motion)?.excludes_zero() {
                true => Ok(Some(false)),
                false => Err(format!("zero is not excluded by an enclosure with {bits} bits").into()),
            }
        }
        (WholeOutcome::NotDecided { below }, _) => check_doubt(below, judged, sense, motion).map(|()| None),
    }
}

/// What is not decided is very small: `below` bounds it, and is small itself beside its terms.
fn check_doubt(below: Decimal, judged: &Judged, sense: usize, motion: &Motion<'_>) -> Result<(), Reason> {
    let below = BigRational::from_float(below).ok_or("`below` is not a number")?;
    let whole = Enclosure::of_bits(judged, &[sense], BITS_OF_DOUBT, motion)?;
    if !below.is_positive() || below > whole.largest(judged, &[sense]) * doubtful() {
        return Err(format!("`below` is positive, and at most 10^-{DIGITS_OF_DOUBT} of the terms").into());
    }
    let sum = whole.sum(judged, sense, motion)?;
    let [[_, re], [_, im]] = [sum.re.sizes(), sum.im.sizes()];
    let stated = below * BigRational::from_integer(whole.scale << whole.bits);
    match &stated * &stated >= BigRational::from_integer(&re * &re + &im * &im) {
        true => Ok(()),
        false => Err(format!("`below` is less than what an enclosure with {BITS_OF_DOUBT} bits leaves").into()),
    }
}

fn doubtful() -> BigRational {
    BigRational::new(BigInt::one(), BigInt::from(10).pow(DIGITS_OF_DOUBT))
}

/// Whether two lengths are so near to each other that it may be left open which is the larger.
pub(super) fn are_nearly_equally_long(judged: &Judged, motion: &Motion<'_>) -> Result<bool, Reason> {
    let common = Enclosure::of_bits(judged, &[0, 1], BITS_OF_DOUBT, motion)?;
    let [direct, reverse] = [0, 1].map(|sense| common.sum(judged, sense, motion));
    let [_, difference] = direct?.square(common.bits).minus(&reverse?.square(common.bits)).sizes();
    let largest = common.largest(judged, &[0, 1]);
    let unit = BigRational::from_integer((&common.scale * &common.scale) << common.bits);
    Ok(BigRational::from_integer(difference) <= &largest * &largest * doubtful() * unit)
}

/// A bound of the length of the whole in one sense: no less than that, and hardly more.
pub(super) fn longest(judged: &Judged, sense: usize, motion: &Motion<'_>) -> Result<BigRational, Reason> {
    let whole = Enclosure::of_bits(judged, &[sense], BITS_OF_DOUBT, motion)?;
    let sum = whole.sum(judged, sense, motion)?;
    Ok(BigRational::new(sum.longest(), whole.scale << whole.bits))
}

/// The whole in one sense, for the decimals beside it: its real and its imaginary part, and its terms end to end.
pub(super) fn value(judged: &Judged, sense: usize, motion: &Motion<'_>) -> Result<[BigRational; 3], Reason> {
    let whole = Enclosure::of_bits(judged, &[sense], BITS_OF_DECIMALS, motion)?;
    let sum = whole.sum(judged, sense, motion)?;
    let part = |middle: BigInt| BigRational::new(middle, &whole.scale << whole.bits);
    Ok([part(sum.re.middle), part(sum.im.middle), whole.largest(judged, &[sense])])
}

/// Whether an enclosure tells `|direct|²` from `|reverse|²`.
pub(super) fn are_unequally_long(judged: &Judged, bits: u32, motion: &Motion<'_>) -> Result<bool, Reason> {
    let common = Enclosure::of_bits(judged, &[0, 1], bits, motion)?;
    let direct = common.sum(judged, 0, motion)?.square(common.bits);
    let reverse = common.sum(judged, 1, motion)?.square(common.bits);
    Ok(direct.minus(&reverse).excludes_zero())
}

/// The units of an enclosure: `2^−bits` of a sum that is scaled to whole weights.
struct Enclosure {
    bits: u32,
    scale: BigInt,
    /// The coefficients are about `2^−below_one`, by how fast the harmonics of the motion fall.
    below_one: u64,
}

/// What is left in these senses.
fn left_in<'a>(judged: &'a Judged, senses: &[usize]) -> Vec<(&'a JudgedGroup, usize)> {
    senses.iter().flat_map(|&sense| judged.left(sense).into_iter().map(move |group| (group, sense))).collect()
}

impl Enclosure {
    /// Bits are counted from about the size of the largest coefficient on: those of high orders are small.
    fn of_bits(judged: &Judged, senses: &[usize], bits: u32, motion: &Motion<'_>) -> Result<Self, Reason> {
        check_bits(bits)?;
        let left = left_in(judged, senses);
        let smallness: Vec<u64> = left
            .iter()
            .map(|(group, _)| smallness(&group.coefficient, judged.order, motion.audit()))
            .collect::<Result<_, Refusal>>()?;
        let below_one = smallness.into_iter().min().unwrap_or_default();
        let bits = below_one.checked_add(u64::from(bits) + GUARD).filter(|bits| *bits <= MOST_BITS);
        let bits = bits.and_then(|bits| u32::try_from(bits).ok());
        let sums = left.iter().map(|(group, sense)| &group.sums[*sense].0);
        Ok(Enclosure { bits: bits.ok_or(Reason::TooManySteps)?, scale: scale(sums, motion.audit())?, below_one })
    }

    /// The terms of these senses end to end, each times about the size of the largest coefficient.
    fn largest(&self, judged: &Judged, senses: &[usize]) -> BigRational {
        let weights = left_in(judged, senses).into_iter().flat_map(|(group, sense)| group.sums[sense].0.values());
        let weights: BigRational = weights.map(Signed::abs).sum();
        weights / BigRational::from_integer(BigInt::one() << self.below_one)
    }

    /// The sum over all that is left in a sense; in the reverse one the coefficients are conjugated.
    fn sum(&self, judged: &Judged, sense: usize, motion: &Motion<'_>) -> Result<Complex, Reason> {
        let audit: &Audit = motion.audit();
        let is_reverse = judged.quantity.senses()[sense] == Some(Sense::Reverse);
        judged.left(sense).into_iter().try_fold(Complex::zero(), |whole, group| {
            let coefficient = motion.coefficient(&group.coefficient, judged.order, self.bits)?;
            let coefficient = coefficient.ok_or("the rods are not known")?;
            let coefficient = if is_reverse { coefficient.conjugate() } else { coefficient };
            let sum = enclose(&group.sums[sense].0, &self.scale, &audit.circle(self.bits), audit)?;
            Ok(whole.plus(&sum.times(&coefficient, self.bits)))
        })
    }
}
