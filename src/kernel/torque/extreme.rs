//! Where in the cycle is a value largest, and where smallest? On a grid, then between its places.

use std::f64::consts::TAU;

use crate::motion::top_between;
use crate::numbers;

/// A largest or smallest value, and where it first stands.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Extreme {
    /// The value.
    pub value: f64,
    /// The crank angle θ in degrees, within the cycle.
    pub angle: f64,
}

/// Steps of a revolution in which the largest value is looked for: half a degree each.
const STEPS: usize = 720;
/// Where a function does not rise in this part of a step beside a place, its top is there: by less the rounding of values hides whether it rises.
const HAIR: f64 = 1e-5;
/// Angles closer than this in radians are one.
const SAME: f64 = 1e-9;
/// A top of the grid lower than the highest by more than this part of the range is no highest value.
const NEAR_TOP: f64 = 0.02;

/// Angles through a cycle of this length in radians, half a degree apart.
pub fn angles(period: f64) -> impl Iterator<Item = f64> {
    let count = (period / TAU * STEPS as f64).round() as usize;
    let step = period / count as f64;
    (0..count).map(move |index| index as f64 * step)
}

/// The same with these angles among them, at which something has a kink: rising, so that from one to the next all is smooth.
pub fn angles_with(kinks: impl Iterator<Item = f64>, period: f64) -> Vec<f64> {
    let mut grid: Vec<f64> = angles(period).chain(kinks.map(|kink| kink.rem_euclid(period))).collect();
    grid.sort_unstable_by(f64::total_cmp);
    grid.dedup_by(|next, before| *next - *before < SAME);
    grid
}

/// The largest value in a cycle of a function that is known at rising angles, and is smooth and has at most one top from one to the next.
pub fn largest(period: f64, grid: &[f64], values: &[f64], value: impl Fn(f64) -> f64) -> Extreme {
    let count = values.len().min(grid.len());
    let highest = values.iter().copied().fold(f64::NEG_INFINITY, f64::max);
    let lowest = values.iter().copied().fold(f64::INFINITY, f64::min);
    let mut best = Extreme { value: f64::NEG_INFINITY, angle: 0.0 };
    let mut take = |place: f64, found: f64| {
        if found > best.value + numbers::ALIKE * (highest - lowest) || best.value == f64::NEG_INFINITY {
            best = Extreme { value: found, angle: place.rem_euclid(period).to_degrees() };
        }
    };
    // Where nothing changes one place is as good as all.
    let most = if highest > lowest { count } else { 1 };
    let is_near =
        |index: &usize| values[*index].max(values[(index + 1) % count]) >= highest - NEAR_TOP * (highest - lowest);
    for index in (0..count).filter(is_near).take(most) {
        let next = if index + 1 == count { grid[0] + period } else { grid[index + 1] };
        let ends = [(grid[index], values[index]), (next, values[(index + 1) % count])];
        let [(from, _), (to, _)] = if ends[0].1 >= ends[1].1 { ends } else { [ends[1], ends[0]] };
        take(ends[0].0, ends[0].1);
        // A top between two places is where the function still rises from the higher one: that may be lower than its neighbour beyond.
        if value(from + HAIR * (to - from)) > value(from) {
            let top = top_between(from.min(to), from.max(to), &value);
            take(top, value(top));
        }
    }
    best
}

/// The largest and the smallest value of such a function.
pub fn extremes(period: f64, grid: &[f64], values: &[f64], value: impl Fn(f64) -> f64) -> [Extreme; 2] {
    let opposite: Vec<f64> = values.iter().map(|value| -value).collect();
    let lowest = largest(period, grid, &opposite, |theta| -value(theta));
    [largest(period, grid, values, value), Extreme { value: -lowest.value, ..lowest }]
}
