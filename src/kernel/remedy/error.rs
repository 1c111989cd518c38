//! Why is there no remedy?

use std::fmt;

use crate::loads::Missing;

/// Why there is no remedy.
#[derive(Clone, Debug, PartialEq)]
pub enum RemedyError {
    /// What the layout lacks.
    Missing(Missing),
    /// Both planes are at this position, as a person writes it.
    PlanesCoincide(String),
    /// A plane at this position lies beyond the ends of the crankshaft.
    BeyondTheShaft(String, Box<[String; 2]>),
    /// Balance factors where a crankshaft turns otherwise than the first, whose throws they are about.
    Bays,
    /// Balance factors of an engine that has counterweights in other planes than those of its throws, which would stay beside them.
    Weighted(String),
    /// A mass at a radius of an engine without masses or a crank radius.
    NoMass,
    /// Neither one value for all nor one per throw.
    TooMany {
        /// What is given.
        what: &'static str,
        /// How many are given.
        given: usize,
        /// How many throws there are.
        throws: usize,
    },
}

impl fmt::Display for RemedyError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            RemedyError::Missing(missing) => missing.fmt(f),
            RemedyError::PlanesCoincide(position) => write!(
                f,
                "both planes are at {position}: weights in one plane make no couple; give planes at two positions"
            ),
            RemedyError::BeyondTheShaft(position, ends) => {
                write!(
                    f,
                    "a plane at {position} is beyond the crankshaft, which reaches from {} to {}",
                    ends[0], ends[1]
                )
            }
            RemedyError::Bays => f.write_str(
                "balance factors are of crankshafts that all turn as the first one does; leave them out: then weights in two planes are proposed",
            ),
            RemedyError::Weighted(position) => write!(
                f,
                "the file has a counterweight at z = {position}, beside the planes of the throws in which balance factors put theirs: take balance_factor, counterweights and [[counterweight]] out of the file, or ask without factors"
            ),
            RemedyError::NoMass => f.write_str(
                "a mass at a radius needs the masses of the engine and its crank radius; give them below [mechanism]",
            ),
            RemedyError::TooMany { what, given, throws } => {
                write!(f, "{given} {what} for {throws} throws; give one for all, or one per throw")
            }
        }
    }
}

impl std::error::Error for RemedyError {}
