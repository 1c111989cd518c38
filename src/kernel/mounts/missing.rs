//! What does an engine lack for forces and moments on its mounts?

use std::fmt;

use crate::engine::CycleOrder;
use crate::loads::Missing;
use crate::order::MissingArm;
use crate::torque;

/// Why there are no forces and moments about the centre of gravity in newtons.
#[derive(Clone, Debug, PartialEq)]
pub enum NoExcitation {
    /// No masses, crank radius or speed.
    Scale,
    /// Positions in spacings, while the mounts stand in metres.
    Positions,
    /// An order that the torque of the gas, or of articulated rods, is not computed at.
    Order(CycleOrder),
    /// A length that the roll moment hangs on.
    Arm(MissingArm),
    /// What else the layout lacks.
    Missing(Missing),
}

impl fmt::Display for NoExcitation {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            NoExcitation::Scale => f.write_str(
                "motions on the mounts need a speed above the first table, and reciprocating_mass and crank_radius below [mechanism]",
            ),
            NoExcitation::Positions => f.write_str(
                "the mounts have places in metres and the cylinders in spacings; give the spacing of the cylinders, such as spacing = \"0.09 m\"",
            ),
            NoExcitation::Order(order) => write!(
                f,
                "order {order}: the torque of the gas, and that of articulated rods, is computed up to order {}; ask for lower orders",
                torque::HIGHEST
            ),
            NoExcitation::Arm(MissingArm::EndlessRod) => {
                f.write_str("the roll moment is not known: the offset of an endless rod is no length")
            }
            NoExcitation::Arm(MissingArm::Distance) => {
                f.write_str("the roll moment is not known: the distance of the crankshafts is not given")
            }
            NoExcitation::Arm(MissingArm::Crankshaft(index)) => {
                write!(f, "the roll moment is not known: crankshaft {} has no place", index + 1)
            }
            NoExcitation::Arm(MissingArm::Balancer(index)) => write!(
                f,
                "the roll moment is not known: balancer shaft {} has neither height nor offset; add them to its table [[balancer]]",
                index + 1
            ),
            NoExcitation::Missing(what) => what.fmt(f),
        }
    }
}

impl std::error::Error for NoExcitation {}

impl From<Missing> for NoExcitation {
    fn from(what: Missing) -> Self {
        NoExcitation::Missing(what)
    }
}
