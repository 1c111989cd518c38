//! What is wrong with a beam, and what would be right?

use std::fmt;

use num_rational::BigRational;

/// Why supports make no beam. Supports are indices into the list as given; messages count from 1.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum BeamError {
    /// This many supports, 0 or 1, do not hold a beam.
    FewerThanTwoSupports(usize),
    /// Two supports at one position: the span between them has no length.
    CoincidingSupports {
        /// The one given first.
        first: usize,
        /// The one given later.
        second: usize,
        /// Where both stand.
        at: BigRational,
    },
}

impl fmt::Display for BeamError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            BeamError::FewerThanTwoSupports(0) => write!(f, "no support holds the beam: it needs two or more"),
            BeamError::FewerThanTwoSupports(count) => {
                write!(f, "{count} support does not hold the beam: it needs two or more")
            }
            BeamError::CoincidingSupports { first, second, at } => {
                let (first, second) = (first + 1, second + 1);
                write!(f, "supports {first} and {second} are both at {at}: each needs a position of its own")
            }
        }
    }
}

impl std::error::Error for BeamError {}
