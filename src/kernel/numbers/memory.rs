//! Was this asked for before? A page names the same length in many places and draws the same direction in many pictures; the work is done once.

use std::collections::BTreeMap;

use crate::exact::{IntegerSum, PhasorSum};

/// So many answers are remembered; then all are forgotten.
const MOST: usize = 1024;

/// What was found of each star, or of another question. Only whole answers are kept, so that an answer does not depend on what came before.
pub(super) struct Memory<T, K = IntegerSum> {
    known: BTreeMap<K, T>,
}

impl<T: Clone, K: Ord> Memory<T, K> {
    pub const fn new() -> Self {
        Memory { known: BTreeMap::new() }
    }

    pub fn get(&self, question: &K) -> Option<T> {
        self.known.get(question).cloned()
    }

    pub fn keep(&mut self, question: K, found: T) {
        if self.known.len() >= MOST {
            self.known.clear();
        }
        self.known.insert(question, found);
    }
}

/// The key of a sum.
pub(super) fn star(sum: &PhasorSum) -> IntegerSum {
    IntegerSum::collect(sum.terms())
}
