//! Which of all orders vanish? One period of stars tells it.
//!
//! In each term the order multiplies the firing angle, so where N times every angle times the lowest order is whole the star of
//! order κ depends on κ only modulo N times the lowest order.

use num_bigint::BigInt;
use num_integer::Integer;
use num_traits::ToPrimitive;

use super::{NoStar, StarOrder, Weights, firing_of, firing_stars};
use crate::engine::{Cycle, CycleOrder, Engine};

/// Longer periods are not judged.
pub const LONGEST_PATTERN: u32 = 720;

/// The stars of one period of orders, which are those of every order.
#[derive(Clone, Debug)]
pub struct FiringPattern {
    /// Two-stroke or four-stroke.
    pub cycle: Cycle,
    /// The stars of orders 1, 2, … up to the period, counted in the lowest order of the cycle.
    pub orders: Vec<StarOrder>,
}

/// Why there is no pattern.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
pub enum NoPattern {
    /// There is no star either.
    #[error("{0}")]
    NoStar(NoStar),
    /// The pattern repeats only after this many orders.
    #[error("the pattern repeats only after {0} orders; at most {LONGEST_PATTERN} are decided")]
    PeriodTooLong(BigInt),
}

impl FiringPattern {
    /// After which order the stars repeat.
    pub fn repeats_after(&self) -> CycleOrder {
        self.orders.last().map_or_else(|| self.cycle.lowest_order(), |last| last.order)
    }

    /// The orders of the first period up to its middle, and the last: the stars between are mirror images of these.
    pub fn half(&self) -> impl Iterator<Item = &StarOrder> {
        let repeats = self.repeats_after().halves();
        self.orders.iter().filter(move |order| 2 * order.order.halves() <= repeats || order.order.halves() == repeats)
    }

    /// The order of [`FiringPattern::half`] whose star is that of this order, or its mirror image.
    pub fn folded(&self, order: CycleOrder) -> CycleOrder {
        let repeats = self.repeats_after();
        let within = order.halves() % repeats.halves();
        CycleOrder::of_halves(within.min(repeats.halves() - within)).unwrap_or(repeats)
    }

    /// The orders of the first period that do not vanish.
    pub fn left(&self) -> impl Iterator<Item = &StarOrder> {
        self.orders.iter().filter(|order| !order.vanishes())
    }
}

/// Judges one period of firing stars.
///
/// # Errors
/// See [`NoPattern`].
pub fn pattern(engine: &Engine, weights: &Weights) -> Result<FiringPattern, NoPattern> {
    let firing = firing_of(engine).map_err(NoPattern::NoStar)?;
    let lowest = firing.cycle.lowest_order();
    let period =
        firing.shots.iter().fold(BigInt::from(1), |period, shot| period.lcm(lowest.times(&shot.angle).denominator()));
    let short = period.to_u32().filter(|&period| period <= LONGEST_PATTERN);
    let period = short.ok_or(NoPattern::PeriodTooLong(period))?;
    let orders: Vec<CycleOrder> =
        (1..=period).filter_map(|index| CycleOrder::of_halves(index * lowest.halves())).collect();
    let orders = firing_stars(engine, &orders, weights).map_err(NoPattern::NoStar)?;
    Ok(FiringPattern { cycle: firing.cycle, orders })
}
