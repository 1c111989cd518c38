//! What moves a piston? A crank with a connecting rod, today.

use num_rational::BigRational;
use num_traits::{One, Signed, Zero};

/// What moves the piston of a cylinder: the harmonics of its motion are the coefficients c_k and t_k.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Mechanism {
    /// A crank and a connecting rod, with or without an offset of the cylinder axis.
    SliderCrank(Rod),
}

/// A connecting rod and how its cylinder stands to the crankshaft.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub struct Rod {
    /// Rod ratio λ = r/l.
    pub ratio: BigRational,
    /// Offset δ = e/l: the cylinder axis passes the crankshaft at the distance e, on the side of ψ = 90°.
    pub offset: BigRational,
}

impl Mechanism {
    /// Whether the cylinder axis meets the crankshaft.
    pub fn is_centric(&self) -> bool {
        match self {
            Mechanism::SliderCrank(rod) => rod.offset.is_zero(),
        }
    }

    /// Whether the crank can turn round.
    pub fn turns_round(&self) -> bool {
        match self {
            Mechanism::SliderCrank(rod) => !rod.ratio.is_negative() && turns_round(rod),
        }
    }
}

/// An offset crank that is nearer to its end than a millionth would take too many points to integrate.
fn turns_round(rod: &Rod) -> bool {
    let sum = &rod.ratio + rod.offset.abs();
    match rod.offset.is_zero() {
        true => sum < BigRational::one(),
        false => sum <= BigRational::new(999_999.into(), 1_000_000.into()),
    }
}
