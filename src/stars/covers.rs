//! In how many ways is `{0, …, n−1}` cut into sums `A ⊕ B` of two and q places?

use std::collections::HashMap;

use num_bigint::BigUint;

/// Covers of more places are not counted.
const MOST: u32 = 30;

/// The exact covers of `{0, …, n−1}` by sums of p and q places; none where p is not 2, or n is too large.
pub(super) fn count(throws: u32, p: u32, q: u32) -> Option<BigUint> {
    if p != 2 || throws > MOST {
        return None;
    }
    let mut shapes: HashMap<u32, u32> = HashMap::new();
    for step in 1..throws {
        for_each_set(q, throws - step, &mut |set| {
            if set & (set << step) == 0 {
                *shapes.entry(set | set << step).or_default() += 1;
            }
        });
    }
    let shapes: Vec<(u32, u32)> = shapes.into_iter().collect();
    let all = u32::MAX >> (32 - throws);
    let mut known = HashMap::new();
    Some(covers(all, &shapes, &mut known).into())
}

/// Calls with every set of so many places from 0 to below a number, 0 among them.
fn for_each_set(size: u32, below: u32, call: &mut dyn FnMut(u32)) {
    fn extend(set: u32, left: u32, from: u32, below: u32, call: &mut dyn FnMut(u32)) {
        if left == 0 {
            return call(set);
        }
        for next in from..below {
            extend(set | 1 << next, left - 1, next + 1, below, call);
        }
    }
    if below > 0 {
        extend(1, size - 1, 1, below, call);
    }
}

/// The covers of a set of places: the lowest place begins a shape.
fn covers(left: u32, shapes: &[(u32, u32)], known: &mut HashMap<u32, u64>) -> u64 {
    if left == 0 {
        return 1;
    }
    if let Some(&covers) = known.get(&left) {
        return covers;
    }
    let lowest = left.trailing_zeros();
    let beginning = left >> lowest;
    let fits = shapes.iter().filter(|(shape, _)| shape & !beginning == 0);
    let found: Vec<u64> =
        fits.map(|(shape, ways)| u64::from(*ways) * covers((beginning & !shape) << lowest, shapes, known)).collect();
    let sum = found.into_iter().sum();
    known.insert(left, sum);
    sum
}
