//! Can one star speak for the whole engine? Only where all cylinders have one coefficient c_k in common.

use num_traits::Zero;

use crate::engine::Family;

/// Why the vectors of a family are not one sum.
#[derive(Clone, Copy, Debug, PartialEq, Eq, thiserror::Error)]
pub enum NotComparable {
    /// Rods that differ have coefficients of their own: no angle of the star is one of the engine.
    #[error(
        "the rods differ and an angle or a length is open: each kind of rod has coefficients of its own, so that one star does not speak for the engine; give all cylinders one rod, or the unknowns values below [values]"
    )]
    RodsDiffer,
    /// Every reciprocating mass is 0.
    #[error("every reciprocating mass is 0, so that nothing depends on what is open; give a mass")]
    NoMass,
}

/// Whether the star of a family is that of the engine.
///
/// # Errors
/// Why it is not.
pub fn comparable(family: &Family) -> Result<(), NotComparable> {
    if family.mechanisms().len() > 1 {
        return Err(NotComparable::RodsDiffer);
    }
    let no_unit = family.dimensions().mass.as_ref().is_some_and(Zero::is_zero);
    match no_unit || family.cylinders().iter().all(|cylinder| cylinder.weight().is_zero()) {
        true => Err(NotComparable::NoMass),
        false => Ok(()),
    }
}
