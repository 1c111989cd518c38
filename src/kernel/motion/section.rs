//! Where is a function with one top largest, and where does something cease to hold?

/// Where a function with one top between two places is largest, by this many golden sections.
pub fn golden_section(mut low: f64, mut high: f64, sections: u32, value: impl Fn(f64) -> f64) -> f64 {
    let golden = (5.0_f64.sqrt() - 1.0) / 2.0;
    for _ in 0..sections {
        let (left, right) = (high - golden * (high - low), low + golden * (high - low));
        if value(left) < value(right) { low = left } else { high = right }
    }
    (low + high) / 2.0
}

/// Where something ceases to hold that holds at the lower of two places and not at the higher, by this many halvings.
pub fn halving(mut low: f64, mut high: f64, halvings: u32, holds: impl Fn(f64) -> bool) -> f64 {
    for _ in 0..halvings {
        let middle = (low + high) / 2.0;
        if holds(middle) { low = middle } else { high = middle }
    }
    (low + high) / 2.0
}
