//! `--masses`: whose masses are the verdicts about?

use crankstar::engine::Engine;
use crankstar::order;
use crankstar::proof::Quantity;
use crankstar::verdict::Judgement;

use super::choice::Choices;
use super::failure::Failure;

/// The argument; without it, all masses that the layout file has.
#[derive(clap::Args)]
pub struct Masses {
    /// Whose masses the verdicts are about [default: all that the layout file has]
    #[arg(long, value_parser = sets(), value_name = "WHICH")]
    masses: Option<order::Masses>,
}

fn sets() -> Choices<order::Masses> {
    Choices::new([
        ("reciprocating", "Pistons, pins, and the reciprocating part of the rods", order::Masses::Reciprocating),
        (
            "rotating",
            "What turns with the crankpins: the rotating part of the rods, pins and webs; no counterweights",
            order::Masses::Rotating,
        ),
        ("counterweights", "The counterweights", order::Masses::Counterweights),
        ("all", "The engine as it is built, with counterweights and balancer shafts", order::Masses::All),
    ])
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
            Some(which) => Judgement::of(engine, orders, which, quantities).map_err(Failure::new),
        }
    }
}

/// Whose masses are meant says nothing of a family.
pub fn masses_of_a_family() -> Failure {
    Failure::new("--masses needs an engine without unknowns; give them values below [values]")
}
