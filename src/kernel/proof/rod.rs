//! What is a rod, and over how many points of a turn is the mean taken that its motion puts before an order?
//!
//! What N points miss: a function that is at most M in size where `|Im φ| ≤ η` has harmonics of at most `M q^{−|m|}`, `q = e^η`,
//! and the mean over N points adds those of `k + N, k − N, k + 2N, …` to that of k: at most `4 M q^{−(N−k)}` where
//! `q^N ≥ 2`. There `|cos φ| ≤ cosh η`, so that `|y| ≤ λ cosh η + |δ|`.
//!
//! - For f it is enough that this is at most 1: the radicand keeps to the right half plane, and `|f|² ≤ 2`.
//! - For the velocity let it be at most `s < 1`: `|f|² ≥ 1 − s²`, and `(1 + s/|f|)² ≤ 2/(1 − s²)` bounds
//!   `(s'/r)²` by `2 q²/(1 − s²)`.

use num_bigint::BigInt;
use num_rational::BigRational;
use num_traits::{One, Signed, ToPrimitive};
use serde::{Deserialize, Serialize};

use super::audit::{Audit, steps_of};
use super::ball::{Ball, Complex};
use super::fraction;
use super::refusal::Refusal;

/// Bits of q behind the point.
const Q_BITS: u32 = 64;
/// Bits of its logarithm behind the point.
const LOG_BITS: u32 = 40;
/// Bits that are computed beyond those that are answered for.
const GUARD: u64 = 32;
/// More bits are not computed.
pub(super) const MOST_BITS: u64 = 8192;
/// A wider strip than to this q makes the bound of the velocity large and saves nothing.
const WIDEST: u32 = 256;

/// A rod, which names a coefficient c_k.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct RodClaim {
    /// λ = r/l.
    #[serde(with = "fraction")]
    pub ratio: BigRational,
    /// δ = e/l.
    #[serde(with = "fraction")]
    pub offset: BigRational,
}

impl RodClaim {
    /// Steps that its lengths take once, which are spent.
    fn steps(&self, audit: &Audit) -> Result<u64, Refusal> {
        let steps = steps_of(&self.ratio) + steps_of(&self.offset);
        audit.spend(steps).map(|()| steps)
    }
}

/// The bits that a factor of this size takes from those that are asked for.
pub(super) fn finer(bits: u32, factor: &BigRational) -> Result<u32, Refusal> {
    let fine = u64::from(bits) + GUARD + factor.ceil().to_integer().bits();
    u32::try_from(fine).ok().filter(|_| fine <= MOST_BITS).ok_or(Refusal::TooManySteps)
}

/// A strip about the real axis, and how large the function is there.
pub(super) struct Strip {
    /// log₂ q or less, in units of `2^−LOG_BITS`.
    log: u64,
    /// M.
    pub most: BigInt,
    /// Steps that the lengths of the rod take at a point.
    steps: u64,
}

impl Strip {
    /// Of the root: `λ cosh η + |δ| ≤ 1`.
    pub fn of_root(rod: &RodClaim, audit: &Audit) -> Result<Self, Refusal> {
        let steps = rod.steps(audit)?;
        Ok(Strip { steps, ..Strip::to(&((BigRational::one() - rod.offset.abs()) / &rod.ratio))? })
    }

    /// To this cosh η, where the function is a root whose radicand keeps to the right half plane and is at most 2 in size.
    pub fn to(cosh: &BigRational) -> Result<Self, Refusal> {
        Ok(Strip { log: logarithm(&widest(cosh))?, most: 2.into(), steps: 0 })
    }

    /// What the mean over as many points misses of a harmonic, in units of the bits that they were counted for.
    pub fn missed(&self) -> BigInt {
        &self.most * 4
    }

    /// Half of the points that an order takes: with an even number each point but two has its mirror image.
    pub fn half_of_points(&self, order: u32, bits: u32) -> u64 {
        let beyond = (u64::from(bits) << LOG_BITS).div_ceil(self.log);
        (u64::from(order) + beyond).div_ceil(2)
    }

    /// Of the velocity: `λ cosh η + |δ| ≤ s`, half-way between the most on the axis and 1.
    pub fn of_velocity(rod: &RodClaim, audit: &Audit) -> Result<Self, Refusal> {
        let steps = rod.steps(audit)?;
        let one = BigRational::one();
        let s = (&one + &rod.ratio + rod.offset.abs()) / BigRational::from_integer(2.into());
        let cap = BigInt::from(WIDEST) << Q_BITS;
        let q = if rod.ratio.is_positive() { widest(&((&s - rod.offset.abs()) / &rod.ratio)).min(cap) } else { cap };
        let exact = BigRational::new(q.clone(), BigInt::one() << Q_BITS);
        let most = &exact * &exact * BigRational::from_integer(2.into()) / (&one - &s * &s);
        Ok(Strip { log: logarithm(&q)?, most: most.ceil().to_integer(), steps })
    }

    /// `log₂ q^k`, or a little less.
    pub fn decay(&self, order: u32) -> u64 {
        let bits = (u128::from(order) * u128::from(self.log)) >> LOG_BITS;
        u64::try_from(bits).unwrap_or(u64::MAX)
    }

    /// The means of the even part times `cos kφ` and of the odd part times `sin kφ`, in units of `2^−bits`.
    pub fn harmonic(
        &self,
        order: u32,
        bits: u32,
        audit: &Audit,
        value: impl Fn(&Ball, &Ball) -> Option<[Ball; 2]>,
    ) -> Result<[Ball; 2], Refusal> {
        let half = self.half_of_points(order, bits);
        let (count, circle) = (2 * half, audit.circle(bits));
        let words = u64::from(bits / 64 + 1);
        audit.spend((half + 1).saturating_mul(circle.steps() + words * words / 2 + self.steps))?;
        let place = |j: u64| circle.direction(&BigRational::new(j.into(), count.into()));
        let table: Vec<Complex> = (0..=half).map(place).collect();
        let mut sums = [Ball::exact(0.into()), Ball::exact(0.into())];
        let share = |points: u64| BigRational::new(points.into(), count.into());
        let (once, twice) = (share(1), share(2));
        for (j, point) in (0..=half).zip(&table) {
            let parts = value(&point.re, &point.im).ok_or(Refusal::TooManySteps)?;
            let Complex { re: cos, im: sin } = multiple(&table, u64::from(order), j, count)?;
            let share = if j == 0 || j == half { &once } else { &twice };
            for ((sum, part), wave) in sums.iter_mut().zip(&parts).zip([cos, sin]) {
                *sum = sum.plus(&part.times(&wave, bits).scaled(share));
            }
        }
        let missed = self.missed();
        Ok(sums.map(|sum| Ball { doubt: sum.doubt + &missed, ..sum }))
    }
}

/// Cosine and sine of k times the j-th angle of this many, from those of the first half.
pub(super) fn multiple(table: &[Complex], k: u64, j: u64, count: u64) -> Result<Complex, Refusal> {
    let at = u128::from(k) * u128::from(j) % u128::from(count);
    let at = at.to_usize().ok_or(Refusal::TooManySteps)?;
    let mirrored = || Some(table.get(count.to_usize()? - at)?.conjugate());
    table.get(at).cloned().or_else(mirrored).ok_or(Refusal::TooManySteps)
}

/// q with `(q + 1/q)/2 = cosh`, or a little less, in units of `2^−Q_BITS`.
fn widest(cosh: &BigRational) -> BigInt {
    let floor = |number: BigRational| number.floor().to_integer();
    let scaled = |number: &BigRational, bits: u32| floor(number * BigRational::from_integer(BigInt::one() << bits));
    let square = cosh * cosh - BigRational::one();
    scaled(cosh, Q_BITS) + scaled(&square, 2 * Q_BITS).sqrt()
}

/// log₂ of a number above 1 in units of `2^−Q_BITS`, or a little less: it is squared, and halved where it passes 2.
fn logarithm(number: &BigInt) -> Result<u64, Refusal> {
    let mantissa_bits = 63;
    let length = number.bits();
    let whole = length.checked_sub(u64::from(Q_BITS) + 1).ok_or(Refusal::TooManySteps)?;
    let mantissa: BigInt = number >> (length - mantissa_bits);
    let mut mantissa = mantissa.to_u128().ok_or(Refusal::TooManySteps)?;
    let mut log = whole;
    for _ in 0..LOG_BITS {
        let square = mantissa * mantissa;
        let is_above_two = square >> (2 * mantissa_bits - 1) == 1;
        log = 2 * log + u64::from(is_above_two);
        mantissa = square >> (mantissa_bits - u64::from(!is_above_two));
    }
    // Where the rod all but reaches over the shaft no number of points is enough.
    if log == 0 { Err(Refusal::TooManySteps) } else { Ok(log) }
}
