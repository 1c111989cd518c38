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
    let all = u32::MAX >> (32 - throws);
    Some(Covers { size: q, known: HashMap::new() }.of(all).into())
}

struct Covers {
    /// How many elements B has.
    size: u32,
    /// By what is left, moved down to 0.
    known: HashMap<u32, u64>,
}

impl Covers {
    /// The covers of a set of places: the lowest place begins a sum.
    fn of(&mut self, left: u32) -> u64 {
        if left == 0 {
            return 1;
        }
        let left = left >> left.trailing_zeros();
        if let Some(&covers) = self.known.get(&left) {
            return covers;
        }
        let steps = (1..u32::BITS).filter(|step| left >> step & 1 == 1);
        // B holds 0; each element has its partner a step above it.
        let covers = steps.map(|step| self.extend(left & !(1 | 1 << step), self.size - 1, step, 1)).sum();
        self.known.insert(left, covers);
        covers
    }

    /// Takes this many more elements of B, from this place up, each with its partner.
    fn extend(&mut self, left: u32, more: u32, step: u32, from: u32) -> u64 {
        if more == 0 {
            return self.of(left);
        }
        let has = |place: u32| left >> place & 1 == 1;
        let next: Vec<u32> = (from..u32::BITS - step).filter(|&place| has(place) && has(place + step)).collect();
        next.into_iter()
            .map(|place| self.extend(left & !(1 << place | 1 << (place + step)), more - 1, step, place + 1))
            .sum()
    }
}
