//! Whose masses is it about? Those that go to and fro, those that turn, or all that the layout names.

use crate::proof::Masses;

/// What in the engine a force comes from.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum MassGroup {
    /// Pistons, pins, and the reciprocating part of the rods.
    Reciprocating,
    /// Rotating parts of the rods, which turn with the crankpins.
    Rotating,
    /// Pins and webs of the crankshaft.
    Crankshaft,
    /// Counterweights.
    Counterweights,
    /// Balancer shafts.
    Balancers,
}

impl MassGroup {
    /// All of them.
    pub const ALL: [MassGroup; 5] = [
        MassGroup::Reciprocating,
        MassGroup::Rotating,
        MassGroup::Crankshaft,
        MassGroup::Counterweights,
        MassGroup::Balancers,
    ];

    /// Whether these masses are among those.
    pub fn is_among(self, masses: Masses) -> bool {
        match masses {
            Masses::Reciprocating => self == MassGroup::Reciprocating,
            Masses::Rotating => self == MassGroup::Rotating || self == MassGroup::Crankshaft,
            Masses::Counterweights => self == MassGroup::Counterweights,
            Masses::All => true,
        }
    }
}
