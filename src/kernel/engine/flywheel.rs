//! How evenly is the engine to turn, and what makes it?

use num_rational::BigRational;

/// What is known, or wanted, of the flywheel.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Flywheel {
    /// Moment of inertia of all that turns with the crank, in kilograms times square metres.
    pub inertia: Option<BigRational>,
    /// Wanted irregularity: the largest speed less the smallest, as a part of the mean.
    pub irregularity: Option<BigRational>,
}
