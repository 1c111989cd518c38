//! What is a verdict about?

use std::ops::Neg;

use serde::{Deserialize, Serialize};

/// What a verdict is about.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Serialize, Deserialize)]
#[serde(from = "QuantityName", into = "&'static str")]
pub enum Quantity {
    /// Two vectors turn in the plane across the crankshaft.
    Planar(Planar),
    /// One number, about an axis along the crankshaft.
    Axial(Axial),
}

/// A quantity that has a vector in each sense.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Planar {
    /// The shaking force.
    Force,
    /// The moment of the shaking forces about the reference plane.
    Moment,
}

impl Planar {
    /// Both, the force first.
    pub const BOTH: [Planar; 2] = [Planar::Force, Planar::Moment];

    /// The word of the JSON document.
    pub fn name(self) -> &'static str {
        Quantity::Planar(self).name()
    }

    /// What is the force's, or what is the moment's.
    pub fn choose<T>(self, of_force: T, of_moment: T) -> T {
        match self {
            Planar::Force => of_force,
            Planar::Moment => of_moment,
        }
    }
}

/// A quantity about an axis along the crankshaft.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Axial {
    /// The inertia torque on the crankshaft.
    Torque,
    /// The roll moment on the frame, about the middle of the engine.
    Roll,
}

/// As the documents name them.
#[derive(Deserialize)]
#[serde(rename_all = "lowercase")]
enum QuantityName {
    Force,
    Moment,
    Torque,
    Roll,
}

impl From<QuantityName> for Quantity {
    fn from(name: QuantityName) -> Self {
        match name {
            QuantityName::Force => Quantity::FORCE,
            QuantityName::Moment => Quantity::MOMENT,
            QuantityName::Torque => Quantity::TORQUE,
            QuantityName::Roll => Quantity::ROLL,
        }
    }
}

impl From<Quantity> for &'static str {
    fn from(quantity: Quantity) -> Self {
        quantity.name()
    }
}

impl From<Planar> for Quantity {
    fn from(planar: Planar) -> Self {
        Quantity::Planar(planar)
    }
}

impl Quantity {
    /// The shaking force.
    pub const FORCE: Quantity = Quantity::Planar(Planar::Force);
    /// The moment of the shaking forces.
    pub const MOMENT: Quantity = Quantity::Planar(Planar::Moment);
    /// The inertia torque.
    pub const TORQUE: Quantity = Quantity::Axial(Axial::Torque);
    /// The roll moment.
    pub const ROLL: Quantity = Quantity::Axial(Axial::Roll);
    /// All of them, in the order of the documents.
    pub const ALL: [Quantity; 4] = [Quantity::FORCE, Quantity::MOMENT, Quantity::TORQUE, Quantity::ROLL];

    /// Force and moment.
    pub const PLANAR: [Quantity; 2] = [Quantity::FORCE, Quantity::MOMENT];

    /// The word of the JSON document.
    pub fn name(self) -> &'static str {
        match self {
            Quantity::FORCE => "force",
            Quantity::MOMENT => "moment",
            Quantity::TORQUE => "torque",
            Quantity::ROLL => "roll",
        }
    }

    /// Force or moment, where it is one of them.
    pub fn planar(self) -> Option<Planar> {
        match self {
            Quantity::Planar(planar) => Some(planar),
            Quantity::Axial(_) => None,
        }
    }

    /// The senses that it has vectors in.
    pub(super) fn senses(self) -> &'static [Option<Sense>] {
        match self {
            Quantity::Planar(_) => &[Some(Sense::Direct), Some(Sense::Reverse)],
            Quantity::Axial(_) => &[None],
        }
    }
}

/// Which way a vector turns.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum Sense {
    /// With the crank, `e^{ikθ}`.
    Direct,
    /// Against the crank, `e^{−ikθ}`.
    Reverse,
}

impl Sense {
    /// Both, direct first.
    pub const BOTH: [Sense; 2] = [Sense::Direct, Sense::Reverse];

    /// What is the direct one's, or what is the reverse one's.
    pub fn choose<T>(self, of_direct: T, of_reverse: T) -> T {
        match self {
            Sense::Direct => of_direct,
            Sense::Reverse => of_reverse,
        }
    }

    /// A number that counts with the crank: its opposite against it.
    pub fn signed<T: Neg<Output = T>>(self, number: T) -> T {
        match self {
            Sense::Direct => number,
            Sense::Reverse => -number,
        }
    }

    /// The word of the JSON document.
    pub fn name(self) -> &'static str {
        self.choose("direct", "reverse")
    }
}
