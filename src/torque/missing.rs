//! What does a layout lack for its torque?

use std::fmt;

use crate::firing::NoStar;
use crate::gas::NoGas;

/// Why an engine has no torque through its cycle.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub enum NoTorque {
    /// Its gas has no numbers.
    Gas(NoGas),
    /// Nothing says when its cylinders fire.
    Firing,
}

impl fmt::Display for NoTorque {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            NoTorque::Gas(lack) => lack.fmt(f),
            NoTorque::Firing => NoStar::NoFiring.fmt(f),
        }
    }
}

impl std::error::Error for NoTorque {}

impl From<NoGas> for NoTorque {
    fn from(lack: NoGas) -> Self {
        NoTorque::Gas(lack)
    }
}
