//! Whose masses is it about? Those that go to and fro, those that turn, or all that the layout names.

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
}

/// The masses that a statement is about.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Masses {
    /// The reciprocating masses alone.
    Reciprocating,
    /// What turns with the crankpins: the rotating parts of the rods, pins and webs.
    Rotating,
    /// The counterweights alone.
    Counterweights,
    /// All that the layout names, balancer shafts among them: the engine as it is built.
    All,
}

impl Masses {
    /// Whether a group is among them.
    pub fn include(self, group: MassGroup) -> bool {
        match self {
            Masses::Reciprocating => group == MassGroup::Reciprocating,
            Masses::Rotating => group == MassGroup::Rotating || group == MassGroup::Crankshaft,
            Masses::Counterweights => group == MassGroup::Counterweights,
            Masses::All => true,
        }
    }
}
