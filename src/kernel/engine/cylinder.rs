//! What is a cylinder, as far as balance goes? Its throw, bank, place and mass, and what moves its piston.

use num_rational::BigRational;
use num_traits::{One, Zero};

use super::mechanism::{Link, Mechanism, Rod};
use crate::exact::{Turn, fraction};

/// One cylinder with its crank throw. In a [`Family`](super::Family) its angles `A` and its place `L` may hold unknowns.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Cylinder<A = Turn, L = BigRational> {
    /// What it is called in the firing order: `1`, `L2`; where it is empty, its number.
    pub name: String,
    /// Crank-throw angle β, from the reference throw, anticlockwise seen from the free end; on a crank that turns against the
    /// reference that of the equivalent crank which turns with it ([`GearedCrank`](super::GearedCrank)).
    pub throw: A,
    /// Angle α of the cylinder axis, from the reference direction.
    pub bank: A,
    /// Position z along the crankshaft, towards the free end, in the engine's [`LengthUnit`](super::LengthUnit).
    pub position: L,
    /// Reciprocating mass, in multiples of that of the engine.
    pub reciprocating_mass: BigRational,
    /// Rotating mass at the crankpin in kilograms.
    pub rotating_mass: BigRational,
    /// Crank radius, in multiples of that of the engine.
    pub crank_radius: BigRational,
    /// What moves the piston; none where nothing is known of it.
    pub mechanism: Option<Mechanism>,
    /// Mass at the knuckle pin of a link, in multiples of the reciprocating mass of the engine: the pin, and the big end of the
    /// link.
    pub knuckle_mass: BigRational,
    /// Which pin of the crankshaft it works on: cylinders with the same number share it, or the parts of a split one.
    pub pin: usize,
    /// Which crankshaft it works on, where several are geared together; else 0.
    pub crank: usize,
    /// Which cylinder it shares with the piston that faces it; none where it has one of its own.
    pub shared: Option<Shared>,
}

/// A cylinder in which two pistons face each other.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Shared {
    /// Its number: that of both pistons in it, and of no others.
    pub number: usize,
    /// Whether the other piston stands for the cylinder: it fires at the dead centre of that one.
    pub is_second: bool,
}

impl<A, L> Cylinder<A, L> {
    /// A cylinder of unit mass and unit crank radius on a pin of this number.
    pub fn new(throw: A, bank: A, position: L, pin: usize) -> Self {
        Cylinder {
            name: String::new(),
            throw,
            bank,
            position,
            reciprocating_mass: BigRational::one(),
            rotating_mass: BigRational::zero(),
            crank_radius: BigRational::one(),
            mechanism: None,
            knuckle_mass: BigRational::zero(),
            pin,
            crank: 0,
            shared: None,
        }
    }

    /// Length of the cylinder's vector in a star of the force: reciprocating mass times crank radius.
    pub fn weight(&self) -> BigRational {
        fraction::times(&self.reciprocating_mass, &self.crank_radius)
    }

    /// Its connecting rod on the crankpin; none where nothing is known of it, or where it is a link.
    pub fn rod(&self) -> Option<&Rod> {
        self.mechanism.as_ref()?.rod()
    }

    /// Its link on the rod of another cylinder, where it has one.
    pub fn link(&self) -> Option<&Link> {
        self.mechanism.as_ref()?.link()
    }

    /// The same cylinder with other angles and another place, if they can be had.
    pub(super) fn map<B, M>(
        &self,
        angle: impl Fn(&A) -> Option<B>,
        length: impl FnOnce(&L) -> Option<M>,
    ) -> Option<Cylinder<B, M>> {
        Some(Cylinder {
            name: self.name.clone(),
            throw: angle(&self.throw)?,
            bank: angle(&self.bank)?,
            position: length(&self.position)?,
            reciprocating_mass: self.reciprocating_mass.clone(),
            rotating_mass: self.rotating_mass.clone(),
            crank_radius: self.crank_radius.clone(),
            mechanism: self.mechanism.clone(),
            knuckle_mass: self.knuckle_mass.clone(),
            pin: self.pin,
            crank: self.crank,
            shared: self.shared,
        })
    }
}

impl Cylinder {
    /// Whether the link of another cylinder hangs on the rod of this one.
    pub fn is_master_of(&self, other: &Cylinder) -> bool {
        let is_on_its_crankpin =
            (&self.throw, &self.position, &self.crank_radius) == (&other.throw, &other.position, &other.crank_radius);
        let is_its_rod = |link: &Link| {
            self.mechanism == Some(Mechanism::SliderCrank(link.master_rod())) && &self.bank + &link.angle == other.bank
        };
        is_on_its_crankpin && other.link().is_some_and(is_its_rod)
    }

    /// Crank angle `α − β` at which the piston is at top dead centre.
    pub fn top_dead_centre(&self) -> Turn {
        &self.bank - &self.throw
    }
}

/// The piston that faces the one at this index, by its own; none of a piston with a cylinder of its own.
pub(super) fn partner<A, L>(cylinders: &[Cylinder<A, L>], index: usize) -> Option<usize> {
    let number = cylinders[index].shared?.number;
    let is_in_it = |other: &Cylinder<A, L>| other.shared.is_some_and(|shared| shared.number == number);
    (0..cylinders.len()).find(|&other| other != index && is_in_it(&cylinders[other]))
}

/// The pistons by which cylinders are told: all but the second of two in one.
pub fn firing_pistons<A, L>(cylinders: &[Cylinder<A, L>]) -> Vec<usize> {
    (0..cylinders.len()).filter(|&index| !is_second(&cylinders[index])).collect()
}

pub(super) fn is_second<A, L>(cylinder: &Cylinder<A, L>) -> bool {
    cylinder.shared.is_some_and(|shared| shared.is_second)
}
