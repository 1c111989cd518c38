//! What is an engine, as far as its balance goes? Cylinders: throw, bank, position, reciprocating mass.

use num_rational::BigRational;
use num_traits::{One, Zero};

use super::crankshaft::Crankshaft;
use super::firing::Firing;
use super::mechanism::{Mechanism, Rod};
use super::title_block::TitleBlock;
use crate::exact::Turn;
use crate::text::Untrusted;

/// One cylinder with its crank throw.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Cylinder {
    /// What it is called in the firing order: `1`, `L2`.
    pub name: String,
    /// Crank-throw angle β, from the reference throw, anticlockwise seen from the free end.
    pub throw: Turn,
    /// Angle α of the cylinder axis, from the reference direction.
    pub bank: Turn,
    /// Position z along the crankshaft, towards the free end, in the layout's [`LengthUnit`].
    pub position: BigRational,
    /// Reciprocating mass, in kilograms, or in multiples of a common mass.
    pub reciprocating_mass: BigRational,
    /// Crank radius, in multiples of that of the layout.
    pub crank_radius: BigRational,
    /// Which pin of the crankshaft it works on: cylinders with the same number share it, or the parts of a split one.
    pub pin: usize,
}

impl Cylinder {
    /// Crank angle `α − β` at which the piston stands at top dead centre.
    pub fn top_dead_centre(&self) -> Turn {
        &self.bank - &self.throw
    }

    /// Length of the cylinder's vector in a star of the force: reciprocating mass times crank radius.
    pub fn weight(&self) -> BigRational {
        &self.reciprocating_mass * &self.crank_radius
    }
}

/// What lengths are counted in.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum LengthUnit {
    /// Numbers without a unit: multiples of the spacing a (or metres, as the reader likes).
    Spacing,
    /// Metres.
    Metre,
}

/// Which short form the layout file used; the order is that of the catalogue.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Form {
    /// All cylinders on one side of the crankshaft.
    Inline,
    /// Two banks.
    Vee,
    /// Two banks at 180° on shared pins.
    Flat,
    /// Opposed cylinders on pins of their own, 180° apart.
    Boxer,
    /// Three banks or more.
    Fan,
    /// Cylinders all round a common throw.
    Radial,
    /// One table a cylinder.
    General,
}

/// An engine layout: what a layout file says, in exact numbers.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Engine {
    /// Title of the report.
    pub title: Untrusted,
    /// Where the crank star is published, if the file says so.
    pub source: Option<Untrusted>,
    /// Which form the file used.
    pub form: Form,
    /// The cylinders, in the order of the file.
    pub cylinders: Vec<Cylinder>,
    /// Position of the plane that moments are taken about.
    pub reference_plane: BigRational,
    /// Whether the file names the reference plane; else it is the middle of the cylinders.
    pub reference_plane_given: bool,
    /// What positions are counted in.
    pub length_unit: LengthUnit,
    /// Whether the file says where the cylinders stand; else they stand one spacing apart.
    pub positions_given: bool,
    /// The orders that the file asks for, rising; the usual ones where it asks for none.
    pub orders: Vec<u32>,
    /// Whether the file asks for them.
    pub orders_given: bool,
    /// When the cylinders fire, where the file says enough.
    pub firing: Option<Firing>,
    /// Positions of the main bearings, in the order of the file; none where the file says nothing of them.
    pub bearings: Vec<BigRational>,
    /// What the engine measures and weighs.
    pub mechanism: Mechanism,
    /// Masses on the crankshaft, and the balancer shafts that it drives.
    pub crankshaft: Crankshaft,
    /// What is asked for beyond force and moment.
    pub effects: Effects,
    /// What stands in the title block of a calculation report.
    pub title_block: TitleBlock,
    /// The layout file itself.
    pub file: Untrusted,
}

/// What a layout file asks for beyond the forces and moments of its masses: `effects = ["torque", "remedy"]`.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Effects {
    /// The inertia torque.
    pub torque: bool,
    /// Counterweights and balancer shafts for what is left of orders 1 and 2.
    pub remedy: bool,
}

impl Engine {
    /// Arm of a cylinder: its position measured from the reference plane.
    pub fn arm(&self, cylinder: &Cylinder) -> BigRational {
        &cylinder.position - &self.reference_plane
    }

    /// The different rods of the engine, in the order of the cylinders; none where the file says nothing of them.
    pub fn rods(&self) -> Vec<&Rod> {
        let mut different: Vec<&Rod> = Vec::new();
        for rod in &self.mechanism.rods {
            if !different.contains(&rod) {
                different.push(rod);
            }
        }
        different
    }

    /// Whether some cylinder axis misses the crankshaft, so that every order exists.
    pub fn has_offset(&self) -> bool {
        self.mechanism.rods.iter().any(|rod| !rod.offset.is_zero())
    }

    /// The same engine with only the masses that work on this rod; the others are 0.
    pub fn only_with(&self, rod: &Rod) -> Engine {
        let mut part = self.clone();
        for (index, cylinder) in part.cylinders.iter_mut().enumerate() {
            if self.mechanism.rods.get(index) != Some(rod) {
                cylinder.reciprocating_mass = BigRational::zero();
            }
        }
        part
    }

    /// Whether every reciprocating mass and crank radius is 1, so that weights need not be shown.
    pub fn has_unit_masses(&self) -> bool {
        self.cylinders.iter().all(|cylinder| cylinder.weight().is_one())
    }
}
