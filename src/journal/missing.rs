//! What does a layout lack for its complete loads?

use std::fmt;

use crate::loads::Missing;
use crate::torque::NoTorque;

/// Why an engine has no loads of gas and masses together.
#[derive(Clone, Debug, PartialEq)]
pub enum NoCycleLoads {
    /// Its gas has no numbers, or nothing says when its cylinders fire.
    Torque(NoTorque),
    /// No reciprocating mass, or no speed.
    Masses,
    /// Its masses have no loads.
    Loads(Missing),
}

impl fmt::Display for NoCycleLoads {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            NoCycleLoads::Torque(lack) => lack.fmt(f),
            NoCycleLoads::Masses => f.write_str(
                "the layout gives no masses or no speed; add speed = 3000 above the first table, in revolutions a minute, and reciprocating_mass below [mechanism]",
            ),
            NoCycleLoads::Loads(lack) => lack.fmt(f),
        }
    }
}

impl std::error::Error for NoCycleLoads {}

impl From<NoTorque> for NoCycleLoads {
    fn from(lack: NoTorque) -> Self {
        NoCycleLoads::Torque(lack)
    }
}

impl From<Missing> for NoCycleLoads {
    fn from(lack: Missing) -> Self {
        NoCycleLoads::Loads(lack)
    }
}
