//! Which parts of a mass are wanted, and what is known of it?

use num_rational::BigRational;

use crate::file::{Rotor, RotorMass};

/// Which parts of a mass are wanted.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Wanted {
    pub(super) size: bool,
    pub(super) angle: bool,
    pub(super) position: bool,
}

impl Wanted {
    pub fn of(mass: &RotorMass) -> Self {
        Wanted {
            size: mass.mass.is_none() || mass.radius.is_none(),
            angle: mass.angle.is_none(),
            position: mass.position.is_none(),
        }
    }

    pub fn is_none(self) -> bool {
        !(self.size || self.angle || self.position)
    }
}

/// `m r` of a known mass with its share of the reciprocating mass.
pub(super) fn mass_radius(rotor: &Rotor, mass: &RotorMass) -> Option<BigRational> {
    Some((mass.mass.as_ref()? + &rotor.share * &mass.reciprocating) * mass.radius.as_ref()?)
}
