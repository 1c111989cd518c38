//! Was this star asked for before? A page names the same length in many places; the work is done once.

use std::collections::BTreeMap;

use crate::exact::{IntegerSum, PhasorSum};

/// So many stars are remembered; then all are forgotten.
const MOST: usize = 1024;

/// What was found of each star. Only whole answers are kept, so that an answer does not depend on what came before.
pub(super) struct Memory<T> {
    known: BTreeMap<IntegerSum, T>,
}

impl<T: Clone> Memory<T> {
    pub const fn new() -> Self {
        Memory { known: BTreeMap::new() }
    }

    pub fn get(&self, star: &IntegerSum) -> Option<T> {
        self.known.get(star).cloned()
    }

    pub fn keep(&mut self, star: IntegerSum, found: T) {
        if self.known.len() >= MOST {
            self.known.clear();
        }
        self.known.insert(star, found);
    }
}

/// The key of a sum.
pub(super) fn star(sum: &PhasorSum) -> IntegerSum {
    IntegerSum::collect(sum.terms())
}
