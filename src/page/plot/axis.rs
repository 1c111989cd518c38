//! Which values does an axis cover, and at which of them does it have ticks?

use num_traits::ToPrimitive;

use super::super::Unit;
use super::number::{labels, ten_to};

/// How lengths on the page follow values.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Scale {
    /// Equal steps for equal differences.
    Linear,
    /// Equal steps for equal ratios; only positive values have a place.
    Log,
}

/// An axis as it is asked for.
#[derive(Clone, Debug)]
pub struct Axis {
    /// What is measured, in which unit: plain text, with a place `{}` for the unit where one is named.
    pub label: String,
    /// What the values are counted in.
    pub unit: Option<Unit>,
    /// Linear or logarithmic.
    pub scale: Scale,
    /// First and last value; from the data, rounded to ticks, where none or no usable one is given.
    pub range: Option<(f64, f64)>,
    /// Where ticks stand; at 1, 2 or 5 times a power of ten where none are given.
    pub ticks: Option<Vec<f64>>,
    /// Whether the range of a linear axis reaches zero where it follows the data: amplitudes are seen from there.
    pub from_zero: bool,
    /// Values that it reaches whatever the data are: those of other plots that it is compared with.
    pub covers: Vec<f64>,
}

/// A value that is marked on an axis.
#[derive(Clone, Debug, PartialEq)]
pub struct Tick {
    /// The value.
    pub value: f64,
    /// The value as text.
    pub label: String,
}

/// An axis with its range and ticks fixed.
#[derive(Clone, Debug)]
pub struct Ruler {
    scale: Scale,
    /// First value; less than the last, and positive on a logarithmic axis.
    pub low: f64,
    /// Last value.
    pub high: f64,
    /// Labelled values inside the range, rising.
    pub ticks: Vec<Tick>,
    /// Values between them that get a small mark: 2 to 9 times the decades of a logarithmic axis.
    pub small: Vec<f64>,
}

/// Values larger than this, or smaller than its inverse, are not used: what is computed with them could overflow.
const FARTHEST: f64 = 1e280;
/// Values closer than this part of the largest are the same.
const SAME: f64 = 1e-9;
/// Places on the page beyond this many lengths of the axis are as far.
const FAR_OUT: f64 = 1e4;
/// A logarithmic axis of this many decades has its labels at decades only.
const MANY_DECADES: i32 = 3;

impl Axis {
    /// A linear axis that covers the data.
    pub fn linear(label: impl Into<String>) -> Self {
        Axis {
            label: label.into(),
            unit: None,
            scale: Scale::Linear,
            range: None,
            ticks: None,
            from_zero: false,
            covers: Vec::new(),
        }
    }

    /// A linear axis that covers zero and the data.
    pub fn amplitude(label: impl Into<String>) -> Self {
        Axis { from_zero: true, ..Axis::linear(label) }
    }

    /// A logarithmic axis that covers the data.
    pub fn log(label: impl Into<String>) -> Self {
        Axis { scale: Scale::Log, ..Axis::linear(label) }
    }

    /// A linear axis over angles in degrees, with a tick each `step` degrees: 90 or 180 for crank angles.
    pub fn angle(label: impl Into<String>, from: f64, to: f64, step: u16) -> Self {
        let step = f64::from(step.max(1));
        let first = (from / step).ceil();
        let ticks = (0..=64).map(|index| (first + f64::from(index)) * step).take_while(|tick| *tick <= to);
        Axis { range: Some((from, to)), ticks: Some(ticks.collect()), ..Axis::linear(label) }
    }

    /// A linear axis from one angle to another in degrees, with ticks at parts of a turn that have room.
    pub fn degrees(label: impl Into<String>, from: f64, to: f64) -> Self {
        let (low, high) = (from.min(to), from.max(to));
        match [1, 2, 5, 10, 15, 30, 45, 60, 90, 180].into_iter().find(|step| high - low <= f64::from(*step) * 8.0) {
            Some(step) if high - low >= 4.0 => Axis::angle(label, low, high, step),
            _ => Axis::linear(label).within(low, high),
        }
    }

    /// The same axis with values in this unit, whose name takes the place `{}` of the label.
    pub fn counted_in(self, unit: Unit) -> Self {
        Axis { unit: Some(unit), ..self }
    }

    /// Its label, with the unit.
    pub(super) fn words(&self) -> String {
        self.unit.map_or_else(|| self.label.clone(), |unit| self.label.replacen("{}", unit.name, 1))
    }

    /// How many units stand for one where inches are asked for, with the axis over them; none where they stay.
    pub(super) fn in_inches(&self) -> Option<(f64, Axis)> {
        let (inch, size) = self.unit?.inch()?;
        let factor = size.recip().to_f64()?;
        let range = self.range.map(|(low, high)| (low * factor, high * factor));
        let ticks = self.ticks.as_ref().map(|ticks| ticks.iter().map(|tick| tick * factor).collect());
        let covers = self.covers.iter().map(|value| value * factor).collect();
        Some((factor, Axis { unit: Some(inch), range, ticks, covers, ..self.clone() }))
    }

    /// These axes over inches and pounds, with how many of their units stand for one; none where no unit changes.
    pub(super) fn all_in_inches<const N: usize>(axes: [&Axis; N]) -> Option<[(f64, Axis); N]> {
        let changed = axes.map(|axis| (axis, axis.in_inches()));
        let changes = changed.iter().any(|(_, inches)| inches.is_some());
        changes.then(|| changed.map(|(axis, inches)| inches.unwrap_or_else(|| (1.0, axis.clone()))))
    }

    /// The same axis from one value to another.
    pub fn within(self, low: f64, high: f64) -> Self {
        Axis { range: Some((low, high)), ..self }
    }

    /// The same axis, reaching these values too.
    pub fn covering(self, values: &[f64]) -> Self {
        Axis { covers: values.into(), ..self }
    }

    /// The axis over these values, with about this many steps between ticks. Values that have no place are passed over.
    pub fn ruler(&self, values: impl IntoIterator<Item = f64>, steps: usize) -> Ruler {
        let usable = |value: &f64| match self.scale {
            Scale::Linear => *value == 0.0 || (FARTHEST.recip()..FARTHEST).contains(&value.abs()),
            Scale::Log => (FARTHEST.recip()..FARTHEST).contains(value),
        };
        let values = values.into_iter().chain(self.covers.iter().copied());
        let mut own: Vec<f64> = self.ticks.iter().flatten().copied().filter(usable).collect();
        own.sort_by(f64::total_cmp);
        own.dedup();
        let zero = (self.from_zero && self.scale == Scale::Linear).then_some(0.0);
        let given = self.range.map(|(a, b)| (a.min(b), a.max(b)));
        let given = given.filter(|(low, high)| usable(low) && usable(high) && !same(*low, *high));
        let range = given.unwrap_or_else(|| self.cover(values.filter(usable).chain(own.iter().copied()).chain(zero)));
        let (ticks, small) = match self.scale {
            _ if !own.is_empty() => (own, Vec::new()),
            Scale::Linear => (linear_ticks(range, steps), Vec::new()),
            Scale::Log => log_ticks(range, steps),
        };
        let (low, high) = match given {
            None if self.ticks.is_none() => {
                let ends = ticks.first().copied().zip(ticks.last().copied()).unwrap_or(range);
                (range.0.min(ends.0), range.1.max(ends.1))
            }
            _ => range,
        };
        let slack = (high - low) * SAME;
        let inside = |value: &f64| (low - slack..=high + slack).contains(value);
        let ticks: Vec<f64> = ticks.into_iter().filter(inside).collect();
        let names = labels(&ticks, self.scale == Scale::Log);
        let ticks = ticks.into_iter().zip(names).map(|(value, label)| Tick { value, label }).collect();
        Ruler { scale: self.scale, low, high, ticks, small: small.into_iter().filter(inside).collect() }
    }

    /// The least range that covers the values, widened where they are all the same.
    fn cover(&self, values: impl Iterator<Item = f64>) -> (f64, f64) {
        let ends = (f64::INFINITY, f64::NEG_INFINITY);
        let (low, high) = values.fold(ends, |(low, high), value| (low.min(value), high.max(value)));
        match self.scale {
            Scale::Linear if low > high => (0.0, 1.0),
            Scale::Log if low > high => (1.0, 10.0),
            _ if !same(low, high) => (low, high),
            Scale::Log => (low / 3.0, high * 3.0),
            // A constant is shown with its distance from zero.
            Scale::Linear if high.abs() < FARTHEST.recip() => (-1.0, 1.0),
            Scale::Linear => (2.0 * low.min(0.0), 2.0 * high.max(0.0)),
        }
    }
}

impl Ruler {
    pub(super) fn scale(&self) -> Scale {
        self.scale
    }

    /// Where a value stands: 0 at the first, 1 at the last; none where it has no place.
    pub fn place(&self, value: f64) -> Option<f64> {
        let place = match self.scale {
            Scale::Linear => (value - self.low) / (self.high - self.low),
            Scale::Log if value <= 0.0 => return None,
            Scale::Log => (value / self.low).ln() / (self.high / self.low).ln(),
        };
        (value.is_finite() && !place.is_nan()).then(|| place.clamp(-FAR_OUT, FAR_OUT))
    }
}

fn same(low: f64, high: f64) -> bool {
    high - low <= (SAME * low.abs().max(high.abs())).max(FARTHEST.recip())
}

/// Multiples of a step of 1, 2 or 5 times a power of ten; the outer ones cover the range.
fn linear_ticks((low, high): (f64, f64), steps: usize) -> Vec<f64> {
    let raw = (high - low) / steps.max(1) as f64;
    let power = raw.log10().floor() as i32;
    let fits = |factor: &i64| *factor as f64 * ten_to(power) >= raw * (1.0 - SAME);
    let factor = [1, 2, 5].into_iter().find(fits).unwrap_or(10);
    let step = factor as f64 * ten_to(power);
    let (first, last) = ((low / step + SAME).floor() as i64, (high / step - SAME).ceil() as i64);
    let most = first.saturating_add(2 * steps.max(1) as i64 + 2);
    // Read from its decimal digits a tick is the nearest float there is.
    let value = |index: i64| format!("{}e{power}", index.saturating_mul(factor)).parse().unwrap_or(f64::NAN);
    (first..=last.min(most)).map(value).filter(|value: &f64| value.is_finite()).collect()
}

/// Decades, or 1, 2 and 5 times them where the range is short; and the marks between.
fn log_ticks((low, high): (f64, f64), steps: usize) -> (Vec<f64>, Vec<f64>) {
    let (first, last) = ((low.log10() + SAME).floor() as i32, (high.log10() - SAME).ceil() as i32);
    let decades = last - first;
    let times = |factors: &'static [f64]| {
        (first..=last).flat_map(move |power| factors.iter().map(move |factor| factor * ten_to(power)))
    };
    if decades >= MANY_DECADES {
        let stride = (decades + steps.max(2) as i32 - 1) / steps.max(2) as i32;
        let first = first.div_euclid(stride) * stride;
        let ticks: Vec<f64> = (first..last + stride).filter(|power| power % stride == 0).map(ten_to).collect();
        let between: &[f64] = if stride == 1 { &[2.0, 3.0, 4.0, 5.0, 6.0, 7.0, 8.0, 9.0] } else { &[1.0] };
        let small = (first..last + stride).flat_map(|power| between.iter().map(move |factor| factor * ten_to(power)));
        return (ticks, small.collect());
    }
    let ticks: Vec<f64> = times(&[1.0, 2.0, 5.0]).collect();
    let start = ticks.iter().rposition(|tick| *tick <= low * (1.0 + SAME)).unwrap_or(0);
    let end = ticks.iter().position(|tick| *tick >= high * (1.0 - SAME)).unwrap_or(ticks.len() - 1);
    let small = times(&[3.0, 4.0, 6.0, 7.0, 8.0, 9.0]).collect();
    match ticks.get(start..=end) {
        Some(ticks) if ticks.len() > 2 => (ticks.to_vec(), small),
        _ => (linear_ticks((low, high), steps), Vec::new()),
    }
}
