//! Where is a function with one top largest?

/// Where a function with one top between two places is largest, by so many golden sections.
pub fn golden_section(mut low: f64, mut high: f64, sections: u32, value: impl Fn(f64) -> f64) -> f64 {
    let golden = (5.0_f64.sqrt() - 1.0) / 2.0;
    for _ in 0..sections {
        let (left, right) = (high - golden * (high - low), low + golden * (high - low));
        match value(left) < value(right) {
            true => low = left,
            false => high = right,
        }
    }
    (low + high) / 2.0
}
