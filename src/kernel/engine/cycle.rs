//! In how many revolutions does every cylinder fire once?

use num_rational::BigRational;

/// How many revolutions it takes until a cylinder fires again.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Cycle {
    /// One revolution.
    TwoStroke,
    /// Two revolutions.
    FourStroke,
}

impl Cycle {
    /// The word of a layout file for it.
    pub fn word(self) -> &'static str {
        match self {
            Cycle::TwoStroke => "two-stroke",
            Cycle::FourStroke => "four-stroke",
        }
    }

    /// The cycle of this word.
    pub fn of(word: &str) -> Option<Self> {
        [Cycle::TwoStroke, Cycle::FourStroke].into_iter().find(|cycle| cycle.word() == word)
    }

    /// Length of the cycle in turns of the crank.
    pub fn turns(self) -> BigRational {
        BigRational::from_integer(match self {
            Cycle::TwoStroke => 1.into(),
            Cycle::FourStroke => 2.into(),
        })
    }
}
