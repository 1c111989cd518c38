//! `--cycle`: how often does each cylinder fire?

use clap::ValueEnum;
use crankstar::engine;

#[derive(Clone, Copy, PartialEq, Eq, ValueEnum)]
pub enum Cycle {
    /// Every cylinder fires once a revolution
    TwoStroke,
    /// Every cylinder fires once in two revolutions
    FourStroke,
}

impl From<Cycle> for engine::Cycle {
    fn from(cycle: Cycle) -> Self {
        match cycle {
            Cycle::TwoStroke => engine::Cycle::TwoStroke,
            Cycle::FourStroke => engine::Cycle::FourStroke,
        }
    }
}
