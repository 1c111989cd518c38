//! What is one part of a sum, turned by unknown angles?

use num_rational::BigRational;

use crate::exact::PhasorSum;
use crate::proof::Certificate;

/// The factor `e^{i(phi·φ + delta·δ)}` with the sum behind it.
#[derive(Clone, Debug)]
pub struct Part {
    /// How many times φ enters.
    pub phi: BigRational,
    /// How many times δ enters.
    pub delta: BigRational,
    /// The sum without unknowns.
    pub sum: PhasorSum,
    /// Evidence that it is zero, or that it is not.
    pub certificate: Certificate,
}
