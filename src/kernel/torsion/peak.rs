//! Where is a value largest that has several peaks: a torque over the speed?

use crate::motion::top_between;

/// The places of a row of values that are no lower than this and than their neighbours: peaks, or an end beside which the values fall.
pub fn peaks(values: &[f64], least: f64) -> impl Iterator<Item = usize> {
    (0..values.len()).filter(move |at| beside(values, *at).into_iter().all(|side| values[*at] >= side.max(least)))
}

/// What is on both sides of a place in a row: its neighbours, itself at an end.
pub fn beside(row: &[f64], at: usize) -> [f64; 2] {
    [row[at.saturating_sub(1)], row[(at + 1).min(row.len() - 1)]]
}

/// Values that differ by less than this part of the largest are equal but for rounding.
const ALIKE: f64 = 1e-9;

/// The one of largest size; the first of those that are as large but for rounding. None of nothing.
pub fn first_of_largest<T>(all: impl IntoIterator<Item = T>, size: impl Fn(&T) -> f64) -> Option<T> {
    let all: Vec<T> = all.into_iter().collect();
    let largest = all.iter().map(&size).fold(f64::NEG_INFINITY, f64::max);
    all.into_iter().find(|one| size(one) == largest || size(one) >= largest - ALIKE * largest.abs())
}

/// A peak whose points are lower than this part of the highest one is not refined; of values below 0 the highest is this part of the others.
pub(super) const LOWER: f64 = 0.9;

/// The largest value between two ends, and where it is: the peaks of this many points, each then refined.
pub fn highest(low: f64, high: f64, points: usize, of: &dyn Fn(f64) -> f64) -> (f64, f64) {
    highest_among(&evenly(low, high, points), LOWER, of)
}

/// Places at equal distances, both ends among them.
pub fn evenly(low: f64, high: f64, points: usize) -> Vec<f64> {
    (0..=points).map(|index| low + (high - low) * index as f64 / points as f64).collect()
}

/// The largest value between rising places: of the peaks that are no lower than this part of the highest.
pub fn highest_among(places: &[f64], lower: f64, of: &dyn Fn(f64) -> f64) -> (f64, f64) {
    let values: Vec<f64> = places.iter().map(|place| of(*place)).collect();
    let top = values.iter().copied().fold(f64::NEG_INFINITY, f64::max);
    highest_beside(places, &values, (lower * top).min(top / lower), of)
}

/// The same where the values are known: of the peaks that are no lower than this.
pub(super) fn highest_beside(at: &[f64], values: &[f64], least: f64, of: &dyn Fn(f64) -> f64) -> (f64, f64) {
    let refined = |index: usize| {
        let [before, after] = beside(at, index);
        let place = top_between(before, after, of);
        let value = of(place);
        if value >= values[index] { (place, value) } else { (at[index], values[index]) }
    };
    let tops = peaks(values, least).map(refined);
    tops.fold((at[0], f64::NEG_INFINITY), |most, one| if one.1 > most.1 { one } else { most })
}
