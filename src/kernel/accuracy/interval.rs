//! Between which floats does a number lie? Intervals of doubles, every end rounded outward.

use num_rational::BigRational;

use super::real::{Real, cos_sin, turned};
use crate::numbers::float;

/// All numbers from `low` to `high`; the result of an operation holds every result of numbers in its operands.
///
/// An end rounds to the nearest float, so that one step outward is enough.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Interval {
    pub low: f64,
    pub high: f64,
}

/// Brackets of the series of cosine and sine: what the rest adds is far below the last place of a float.
const BRACKETS: u32 = 11;

impl Interval {
    /// Every real number: what is left where nothing is known.
    pub const WHOLE: Interval = Interval { low: f64::NEG_INFINITY, high: f64::INFINITY };
    /// `2π` lies between the nearest float and the next.
    pub const TAU: Interval = Interval { low: std::f64::consts::TAU, high: std::f64::consts::TAU.next_up() };
    const ONE: Interval = Interval { low: 1.0, high: 1.0 };

    /// One float, exactly.
    pub fn point(value: f64) -> Self {
        Interval { low: value, high: value }
    }

    /// The tightest interval around a rational number.
    pub fn around(number: &BigRational) -> Self {
        let near = float(number);
        if !near.is_finite() {
            return Interval::WHOLE;
        }
        let is = |float: f64| BigRational::from_float(float);
        let (mut low, mut high) = (near, near);
        while is(low).is_some_and(|value| value > *number) {
            low = low.next_down();
        }
        while is(high).is_some_and(|value| value < *number) {
            high = high.next_up();
        }
        Interval { low, high }
    }

    fn outward(low: f64, high: f64) -> Self {
        if low.is_nan() || high.is_nan() {
            return Interval::WHOLE;
        }
        Interval { low: low.next_down(), high: high.next_up() }
    }

    /// The largest size of a number in it.
    pub fn size(&self) -> f64 {
        self.low.abs().max(self.high.abs())
    }

    pub fn contains_zero(&self) -> bool {
        self.low <= 0.0 && self.high >= 0.0
    }

    pub fn negated(self) -> Self {
        Interval { low: -self.high, high: -self.low }
    }

    /// The smallest interval around both.
    pub fn hull(self, other: Self) -> Self {
        Interval { low: self.low.min(other.low), high: self.high.max(other.high) }
    }

    /// Cosine and sine of all angles in it, in turns.
    pub fn direction(&self) -> [Interval; 2] {
        let whole = Interval { low: -1.0, high: 1.0 };
        let is_short = self.high - self.low < 1.0 && self.low.abs() < 1e15;
        if !is_short {
            return [whole, whole];
        }
        let [first, last] = [direction_at(self.low), direction_at(self.high)];
        // Between its ends a cosine is monotone, unless a place of its largest or smallest value lies there.
        let holds = |place: f64| (self.low - place).ceil() + place <= self.high;
        let between = |axis: usize, top: f64| {
            let ends = first[axis].hull(last[axis]);
            let low = if holds(top + 0.5) { -1.0 } else { ends.low.max(-1.0) };
            let high = if holds(top) { 1.0 } else { ends.high.min(1.0) };
            Interval { low, high }
        };
        [between(0, 0.0), between(1, 0.25)]
    }
}

fn direction_at(turns: f64) -> [Interval; 2] {
    let quarter = (4.0 * turns).round();
    // The difference is exact: both are multiples of the last place of the smaller.
    let x = Interval::point(turns - quarter / 4.0).times(&Interval::TAU);
    // The terms alternate and fall, so what is omitted lies between 1 and 1 less its first term.
    let rest = x.squared().over((2 * BRACKETS + 1) * (2 * BRACKETS + 2)).high;
    let innermost = Interval { low: (1.0 - rest).next_down(), high: 1.0 };
    turned(cos_sin(&x, &Interval::ONE, &innermost, BRACKETS), quarter as i64, Interval::negated)
}

impl Real for Interval {
    fn zero_like(&self) -> Self {
        Interval::point(0.0)
    }

    fn plus(&self, other: &Self) -> Self {
        Interval::outward(self.low + other.low, self.high + other.high)
    }

    fn minus(&self, other: &Self) -> Self {
        Interval::outward(self.low - other.high, self.high - other.low)
    }

    fn times(&self, other: &Self) -> Self {
        let [a, b] = [self.low * other.low, self.low * other.high];
        let [c, d] = [self.high * other.low, self.high * other.high];
        if (a + b + c + d).is_nan() {
            return Interval::WHOLE;
        }
        Interval::outward(a.min(b).min(c.min(d)), a.max(b).max(c.max(d)))
    }

    fn squared(&self) -> Self {
        let [low, high] = [self.low * self.low, self.high * self.high];
        let square = Interval::outward(low.min(high), low.max(high));
        let low = if self.contains_zero() { 0.0 } else { square.low.max(0.0) };
        Interval { low, high: square.high }
    }

    fn root(&self) -> Self {
        let root = Interval::outward(self.low.max(0.0).sqrt(), self.high.max(0.0).sqrt());
        Interval { low: root.low.max(0.0), high: root.high }
    }

    fn inverse(&self) -> Self {
        if self.low <= 0.0 {
            return Interval::WHOLE;
        }
        Interval::outward(1.0 / self.high, 1.0 / self.low)
    }

    fn over(&self, divisor: u32) -> Self {
        let divisor = f64::from(divisor);
        Interval::outward(self.low / divisor, self.high / divisor)
    }
}
