//! Which engines does a file with unknowns describe? A family: angles in φ and δ, positions in symbols.

use std::collections::{BTreeMap, BTreeSet};

use num_rational::BigRational;

use super::crankshaft::Crankshaft;
use super::firing::Cycle;
use super::linear::Linear;
use super::mechanism::Mechanism;
use super::model::{Cylinder, Effects, Engine, Form, LengthUnit};
use super::title_block::TitleBlock;
use crate::exact::Turn;
use crate::text::Untrusted;

/// The unknown bank angle.
pub const PHI: &str = "phi";
/// The unknown angle of a split pin.
pub const DELTA: &str = "delta";

/// A cylinder whose angles may hold φ and δ, and whose position may hold symbols.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct SymbolicCylinder {
    /// What it is called in the firing order.
    pub name: String,
    /// Crank-throw angle β in turns.
    pub throw: Linear,
    /// Angle α of the cylinder axis in turns.
    pub bank: Linear,
    /// Position z along the crankshaft, towards the free end.
    pub position: Linear,
    /// Reciprocating mass.
    pub reciprocating_mass: BigRational,
    /// Crank radius, in multiples of that of the layout.
    pub crank_radius: BigRational,
    /// Which pin of the crankshaft it works on.
    pub pin: usize,
}

impl SymbolicCylinder {
    /// The cylinder without unknowns; `None` where one is left.
    pub(super) fn known(&self) -> Option<Cylinder> {
        Some(Cylinder {
            name: self.name.clone(),
            throw: Turn::new(self.throw.as_known()?.clone()),
            bank: Turn::new(self.bank.as_known()?.clone()),
            position: self.position.as_known()?.clone(),
            reciprocating_mass: self.reciprocating_mass.clone(),
            crank_radius: self.crank_radius.clone(),
            pin: self.pin,
        })
    }

    fn with(&self, values: &BTreeMap<String, BigRational>) -> Self {
        SymbolicCylinder {
            name: self.name.clone(),
            throw: self.throw.with(values),
            bank: self.bank.with(values),
            position: self.position.with(values),
            reciprocating_mass: self.reciprocating_mass.clone(),
            crank_radius: self.crank_radius.clone(),
            pin: self.pin,
        }
    }
}

/// All engines that a layout file with unknowns describes.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Family {
    /// Title of the report.
    pub title: Untrusted,
    /// Where the crank star is published, if the file says so.
    pub source: Option<Untrusted>,
    /// Which form the file used.
    pub form: Form,
    /// The cylinders, in the order of the file.
    pub cylinders: Vec<SymbolicCylinder>,
    /// Position of the plane that moments are taken about: the middle between the first and the last cylinder of the file
    /// unless the file names it.
    pub reference_plane: Linear,
    /// What positions without a symbol are counted in.
    pub length_unit: LengthUnit,
    /// The orders that the file asks for, rising; the usual ones where it asks for none.
    pub orders: Vec<u32>,
    /// Whether the file asks for them.
    pub orders_given: bool,
    /// Two-stroke or four-stroke, if the file says so.
    pub cycle: Option<Cycle>,
    /// Whether the file says where the cylinders stand.
    pub positions_given: bool,
    /// Positions of the main bearings; none where the file says nothing of them, or while an unknown is open.
    pub bearings: Vec<BigRational>,
    /// What the engine measures and weighs.
    pub mechanism: Mechanism,
    /// What is asked for beyond force and moment.
    pub effects: Effects,
    /// What stands in the title block of a calculation report.
    pub title_block: TitleBlock,
    /// The layout file itself.
    pub file: Untrusted,
}

impl Family {
    /// Length of a cylinder's vector in a star of the force: reciprocating mass times crank radius.
    pub fn weight(&self, cylinder: &SymbolicCylinder) -> BigRational {
        &cylinder.reciprocating_mass * &cylinder.crank_radius
    }

    /// The unknowns that are left, by name.
    pub fn unknowns(&self) -> BTreeSet<&str> {
        let parts = self.cylinders.iter().flat_map(|cylinder| [&cylinder.throw, &cylinder.bank, &cylinder.position]);
        parts.flat_map(|linear| linear.symbols().keys()).map(String::as_str).collect()
    }

    /// Arm of a cylinder: its position measured from the reference plane.
    pub fn arm(&self, cylinder: &SymbolicCylinder) -> Linear {
        cylinder.position.minus(&self.reference_plane)
    }

    /// The family with some unknowns known: angles in turns, lengths in the unit of the positions.
    pub fn with(&self, values: &BTreeMap<String, BigRational>) -> Family {
        Family {
            cylinders: self.cylinders.iter().map(|cylinder| cylinder.with(values)).collect(),
            reference_plane: self.reference_plane.with(values),
            ..self.clone()
        }
    }

    /// The one engine of a family without unknowns, its firing not judged; `None` where an unknown is left.
    pub fn only(&self) -> Option<Engine> {
        Some(Engine {
            title: self.title.clone(),
            source: self.source.clone(),
            form: self.form,
            cylinders: self.cylinders.iter().map(SymbolicCylinder::known).collect::<Option<Vec<_>>>()?,
            reference_plane: self.reference_plane.as_known()?.clone(),
            reference_plane_given: true,
            length_unit: self.length_unit,
            orders: self.orders.clone(),
            orders_given: self.orders_given,
            positions_given: self.positions_given,
            bearings: self.bearings.clone(),
            mechanism: self.mechanism.clone(),
            crankshaft: Crankshaft::default(),
            effects: self.effects,
            title_block: self.title_block.clone(),
            file: self.file.clone(),
            firing: None,
        })
    }
}
