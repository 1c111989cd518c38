//! Why is there no remedy?

use crate::loads::Missing;

/// Why there is no remedy.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum RemedyError {
    /// What the layout lacks.
    #[error("{0}")]
    Missing(Missing),
    /// Both planes are at this position, as a person writes it.
    #[error("both planes are at {0}: weights in one plane make no couple; give planes at two positions")]
    PlanesCoincide(String),
    /// A plane at this position lies beyond the ends of the crankshaft.
    #[error("a plane at {0} is beyond the crankshaft, which reaches from {} to {}", .1[0], .1[1])]
    BeyondTheShaft(String, Box<[String; 2]>),
    /// Balance factors where a crankshaft turns otherwise than the first, whose throws they are about.
    #[error(
        "balance factors are of crankshafts that all turn as the first one does; leave them out: then weights in two planes are proposed"
    )]
    Bays,
    /// Balance factors of an engine that has counterweights in other planes than those of its throws, which would stay beside them.
    #[error(
        "the file has a counterweight at z = {0}, beside the planes of the throws in which balance factors put theirs: take balance_factor, counterweights and [[counterweight]] out of the file, or ask without factors"
    )]
    Weighted(String),
    /// A mass at a radius of an engine without masses or a crank radius.
    #[error("a mass at a radius needs the masses of the engine and its crank radius; give them below [mechanism]")]
    NoMass,
    /// Neither one value for all nor one per throw.
    #[error("{given} {what} for {throws} throws; give one for all, or one per throw")]
    TooMany {
        /// What is given.
        what: &'static str,
        /// How many are given.
        given: usize,
        /// How many throws there are.
        throws: usize,
    },
}
