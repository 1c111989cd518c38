//! In what can positions along the crankshaft be counted? In known lengths, or in lengths with unknowns.

use std::fmt::Debug;

use num_rational::BigRational;

use super::linear::Linear;
use crate::exact::fraction;

/// What lengths are counted in.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum LengthUnit {
    /// Numbers without a unit: multiples of the spacing a (or metres, as the reader likes).
    #[default]
    Spacing,
    /// Metres.
    Metre,
}

impl LengthUnit {
    /// What it is called in data.
    pub fn name(self) -> &'static str {
        match self {
            LengthUnit::Spacing => "spacing",
            LengthUnit::Metre => "m",
        }
    }
}

/// A position along the crankshaft, or a difference of two.
pub trait Length: Clone + Debug + PartialEq {
    /// The first less the second.
    fn less(&self, other: &Self) -> Self;

    /// The middle between the outermost positions; where some are open, between the first and the last.
    fn middle(positions: &[&Self]) -> Self;
}

impl Length for BigRational {
    fn less(&self, other: &Self) -> Self {
        fraction::minus(self, other)
    }

    fn middle(positions: &[&Self]) -> Self {
        let ends = positions.iter().min().zip(positions.iter().max());
        let two = BigRational::from_integer(2.into());
        ends.map_or_else(Default::default, |(low, high)| (*low + *high) / two)
    }
}

impl Length for Linear {
    fn less(&self, other: &Self) -> Self {
        self.minus(other)
    }

    fn middle(positions: &[&Self]) -> Self {
        let known: Option<Vec<&BigRational>> = positions.iter().map(|position| position.as_known()).collect();
        if let Some(known) = known {
            return Linear::constant(BigRational::middle(&known));
        }
        let half = BigRational::new(1.into(), 2.into());
        let ends = positions.first().zip(positions.last());
        ends.map_or_else(Linear::default, |(first, last)| first.plus(last).scaled(&half))
    }
}
