//! Which methods are worth their time? Those than which no other is both faster and more accurate.

/// The places of the Pareto front of pairs (time, error), by rising time: each has a smaller error than all that are
/// faster. Pairs that are not comparable, with NaN, are not on it.
///
/// ```standalone_crate
/// # use crankstar_kernel as crankstar;
/// let costs = [(1.0, 0.1), (2.0, 0.2), (3.0, 0.01), (3.0, 0.02)];
/// assert_eq!(crankstar::accuracy::front(&costs), [0, 2]);
/// ```
pub fn front(costs: &[(f64, f64)]) -> Vec<usize> {
    let mut places: Vec<usize> = (0..costs.len()).filter(|&i| !costs[i].0.is_nan() && !costs[i].1.is_nan()).collect();
    places.sort_by(|&i, &j| costs[i].0.total_cmp(&costs[j].0).then(costs[i].1.total_cmp(&costs[j].1)));
    let mut least = f64::INFINITY;
    places.retain(|&place| {
        let is_better = costs[place].1 < least;
        least = least.min(costs[place].1);
        is_better
    });
    places
}
