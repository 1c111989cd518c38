//! `--cycle`: how often does each cylinder fire?

use crankstar::engine::Cycle;

use super::choice::Choices;

/// The working cycles.
pub fn cycles() -> Choices<Cycle> {
    Choices::new([
        ("two-stroke", "Every cylinder fires once a revolution", Cycle::TwoStroke),
        ("four-stroke", "Every cylinder fires once in two revolutions", Cycle::FourStroke),
    ])
}
