//! What does an engine measure and weigh? Speed, crank radius and mass, as they were given.

use num_rational::BigRational;

use crate::text::Untrusted;

/// What an engine measures and weighs, as far as it is known.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Dimensions {
    /// Speed in revolutions a minute.
    pub speed: Option<BigRational>,
    /// Crank radius r in metres, that the cylinders' crank radii are multiples of.
    pub crank_radius: Option<BigRational>,
    /// Reciprocating mass m in kilograms, that the cylinders' masses are multiples of.
    pub mass: Option<BigRational>,
    /// What the layout file says, as written.
    pub given: Vec<Given>,
    /// Where the numbers come from, if the file says so.
    pub source: Option<Untrusted>,
}

/// A quantity that the file gives.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Given {
    /// Which.
    pub quantity: Measure,
    /// The cylinder that it belongs to, by its index; none where it is that of all, or of all links.
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
    /// Mass of the piston rod of a crosshead engine.
    PistonRodMass,
    /// Mass of the crosshead.
    CrossheadMass,
    /// Mass of the rod.
    RodMass,
    /// Distance of the rod's centre of gravity from its big end.
    RodCentre,
    /// Rotating mass at the crankpin.
    RotatingMass,
    /// Knuckle radius a of a link, from crankpin to knuckle pin.
    KnuckleRadius,
    /// Knuckle ratio κ = a/l, l the length of the master rod.
    KnuckleRatio,
    /// Length L of a link.
    LinkLength,
    /// Link ratio r/L.
    LinkRatio,
    /// Mass at a knuckle pin.
    KnuckleMass,
}

impl Measure {
    /// Whether links have it, and not every cylinder.
    pub fn is_of_links(self) -> bool {
        match self {
            Measure::KnuckleRadius
            | Measure::KnuckleRatio
            | Measure::LinkLength
            | Measure::LinkRatio
            | Measure::KnuckleMass => true,
            Measure::Speed
            | Measure::Stroke
            | Measure::CrankRadius
            | Measure::RodLength
            | Measure::RodRatio
            | Measure::PinOffset
            | Measure::OffsetRatio
            | Measure::ReciprocatingMass
            | Measure::PistonMass
            | Measure::PinMass
            | Measure::PistonRodMass
            | Measure::CrossheadMass
            | Measure::RodMass
            | Measure::RodCentre
            | Measure::RotatingMass => false,
        }
    }
}
