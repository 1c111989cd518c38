//! What does an engine lack for forces and moments on its mounts?

use crate::engine::CycleOrder;
use crate::loads::Missing;
use crate::order::MissingArm;
use crate::torque;

/// Why there are no forces and moments about the centre of gravity in newtons.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum NoExcitation {
    /// No masses, crank radius or speed.
    #[error(
        "motions on the mounts need a speed above the first table, and reciprocating_mass and crank_radius below [mechanism]"
    )]
    Scale,
    /// Positions in spacings, while the mounts stand in metres.
    #[error(
        "the mounts have places in metres and the cylinders in spacings; give the spacing of the cylinders, such as spacing = \"0.09 m\""
    )]
    Positions,
    /// An order that the torque of the gas, or of articulated rods, is not computed at.
    #[error(
        "order {0}: the torque of the gas, and that of articulated rods, is computed up to order {}; ask for lower orders",
        torque::HIGHEST
    )]
    Order(CycleOrder),
    /// A length that the roll moment hangs on.
    #[error("the roll moment is not known: {0}")]
    Arm(MissingArm),
    /// What else the layout lacks.
    #[error(transparent)]
    Missing(#[from] Missing),
}
