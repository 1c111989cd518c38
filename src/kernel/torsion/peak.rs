//! Where is a value largest that has several peaks: a torque over the speed?

use crate::motion::top_between;

/// A peak whose points are lower than this part of the highest one is not refined.
const LOWER: f64 = 0.9;

/// The largest value between two ends, and where it is: the peaks of this many points, each then refined.
pub fn highest(low: f64, high: f64, points: usize, of: &dyn Fn(f64) -> f64) -> (f64, f64) {
    let values: Vec<f64> = (0..=points).map(|index| of(low + (high - low) * index as f64 / points as f64)).collect();
    let top = values.iter().copied().fold(f64::NEG_INFINITY, f64::max);
    highest_beside([low, high], &values, top.min(LOWER * top), of)
}

/// The same where the values of points at equal distances are known: of the peaks that are no lower than this.
pub(super) fn highest_beside([low, high]: [f64; 2], values: &[f64], least: f64, of: &dyn Fn(f64) -> f64) -> (f64, f64) {
    let points = values.len() - 1;
    let at = |index: usize| low + (high - low) * index as f64 / points as f64;
    let value = |index: usize| values.get(index).copied().unwrap_or(f64::NEG_INFINITY);
    let is_peak = |index: &usize| {
        let own = values[*index];
        own >= value(index.wrapping_sub(1)) && own >= value(index + 1) && own >= least
    };
    let refined = |index: usize| {
        let place = top_between(at(index.saturating_sub(1)), at((index + 1).min(points)), of);
        let value = of(place);
        if value >= values[index] { (place, value) } else { (at(index), values[index]) }
    };
    let peaks = (0..=points).filter(is_peak).map(refined);
    peaks.fold((low, f64::NEG_INFINITY), |most, one| if one.1 > most.1 { one } else { most })
}
