//! In which order do things stand that are asked for in any? Rising, each once.

use std::collections::BTreeSet;

/// These rising, each once.
pub fn rising<T: Ord>(items: impl IntoIterator<Item = T>) -> Vec<T> {
    BTreeSet::from_iter(items).into_iter().collect()
}
