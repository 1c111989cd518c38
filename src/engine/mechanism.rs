//! What does an engine measure and weigh? Crank, rods, masses and speed.

use num_rational::BigRational;
use num_traits::{One, Signed, Zero};

use crate::text::Untrusted;

/// What an engine measures and weighs, as far as its file says.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Mechanism {
    /// Speed in revolutions a minute.
    pub speed: Option<BigRational>,
    /// Crank radius r in metres, that the cylinders' crank radii are multiples of.
    pub crank_radius: Option<BigRational>,
    /// Reciprocating mass m in kilograms, that the cylinders' masses are multiples of.
    pub mass: Option<BigRational>,
    /// Rods, one a cylinder; none where the file says nothing of them.
    pub rods: Vec<Rod>,
    /// Rotating mass at each crankpin in kilograms, one a cylinder; none where the file says nothing of them.
    pub rotating_masses: Vec<BigRational>,
    /// What the file says, as written.
    pub given: Vec<Given>,
    /// Where the numbers come from, if the file says so.
    pub source: Option<Untrusted>,
}

/// A connecting rod and how its cylinder stands to the crankshaft.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub struct Rod {
    /// Rod ratio λ = r/l.
    pub ratio: BigRational,
    /// Offset δ = e/l: the cylinder axis passes the crankshaft at the distance e, on the side of ψ = 90°.
    pub offset: BigRational,
}

/// A quantity that the file gives.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Given {
    /// Which.
    pub quantity: Measure,
    /// The cylinder that it belongs to, by its index; none where it is that of all.
    pub cylinder: Option<usize>,
    /// In metres, kilograms, revolutions a minute, or a pure number.
    pub value: BigRational,
    /// As it was written.
    pub written: Untrusted,
}

/// What can be given.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Measure {
    /// Speed.
    Speed,
    /// Stroke, twice the crank radius.
    Stroke,
    /// Crank radius r.
    CrankRadius,
    /// Rod length l between the centres of its eyes.
    RodLength,
    /// Rod ratio λ.
    RodRatio,
    /// Offset e of the cylinder axis.
    PinOffset,
    /// Offset δ = e/l.
    OffsetRatio,
    /// Reciprocating mass of a cylinder.
    ReciprocatingMass,
    /// Mass of the piston with its rings.
    PistonMass,
    /// Mass of the piston pin.
    PinMass,
    /// Mass of the rod.
    RodMass,
    /// Distance of the rod's centre of gravity from its big end.
    RodCentre,
    /// Rotating mass at the crankpin.
    RotatingMass,
}

/// An offset crank that is nearer to its end than a millionth would take too many points to integrate.
pub(crate) fn turns_round(rod: &Rod) -> bool {
    let sum = &rod.ratio + rod.offset.abs();
    match rod.offset.is_zero() {
        true => sum < BigRational::one(),
        false => sum <= BigRational::new(999_999.into(), 1_000_000.into()),
    }
}
