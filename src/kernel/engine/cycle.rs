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
    /// Length of the cycle in turns of the crank.
    pub fn turns(self) -> BigRational {
        BigRational::from_integer(match self {
            Cycle::TwoStroke => 1.into(),
            Cycle::FourStroke => 2.into(),
        })
    }
}
