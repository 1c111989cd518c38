//! `--masses`: whose masses are the verdicts about?

use crankstar::engine::Engine;
use crankstar::order;
use crankstar::proof::Quantity;
use crankstar::verdict::Judgement;

use super::failure::Failure;

/// The argument; without it, all masses that the layout file has.
#[derive(clap::Args)]
pub struct Masses {
    /// Whose masses the verdicts are about [default: all that the layout file has]
    #[arg(long, value_enum, value_name = "WHICH")]
    masses: Option<MassSet>,
}

#[derive(Clone, Copy, clap::ValueEnum)]
enum MassSet {
    /// Pistons, pins, and the reciprocating part of the rods
    Reciprocating,
    /// What turns with the crankpins: the rotating part of the rods, pins and webs; no counterweights
    Rotating,
    /// The counterweights
    Counterweights,
    /// The engine as it is built, with counterweights and balancer shafts
    All,
}

impl From<MassSet> for order::Masses {
    fn from(which: MassSet) -> Self {
        match which {
            MassSet::Reciprocating => order::Masses::Reciprocating,
            MassSet::Rotating => order::Masses::Rotating,
            MassSet::Counterweights => order::Masses::Counterweights,
            MassSet::All => order::Masses::All,
        }
    }
}

impl Masses {
    /// Whether some masses were asked for.
    pub fn are_given(&self) -> bool {
        self.masses.is_some()
    }

    /// Judges an engine at these orders.
    pub fn judge(&self, engine: &Engine, orders: &[u32], quantities: &[Quantity]) -> Result<Judgement, Failure> {
        match self.masses {
            None => Judgement::new(engine, orders, quantities).map_err(Failure::new),
            Some(which) => Judgement::of(engine, orders, which.into(), quantities).map_err(Failure::new),
        }
    }
}

/// Whose masses are meant says nothing of a family.
pub fn masses_of_a_family() -> Failure {
    Failure::new("--masses needs an engine without unknowns; give them values below [values]")
}
