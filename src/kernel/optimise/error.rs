//! Why are there no best counterweights?

use std::fmt;

use crate::loads::Missing;
use crate::text::harmless;

/// More points than this say nothing more.
pub(super) const MOST_POINTS: usize = 200;

/// Why an engine cannot be optimised.
#[derive(Clone, Debug, PartialEq)]
pub enum OptimiseError {
    /// What the engine lacks for the loads of its bearings.
    Missing(Missing),
    /// No counterweights, so no planes for them.
    NoPlaces,
    /// None on one of several crankshafts.
    NoPlacesOn(String),
    /// All counterweights in one plane, where they make no couple.
    OnePlane(String),
    /// No masses: the crankshaft's mass is not known.
    NoMasses,
    /// No speed or no metres, so that a bound in newton-metres says nothing.
    NoSpeed,
    /// The first order, which counterweights work on, is not among the orders.
    NoFirstOrder,
    /// No points asked for, or more than say anything more.
    Points(usize),
    /// What is no bound of a couple.
    Couple(String),
    /// The gas is asked for, and something lacks for it.
    Gas(String),
    /// The gas is asked for, and the crankshaft stands still: no counterweight makes a force.
    Still,
    /// The solver found no solution.
    Unsolved(String),
    /// The layout file is written in a way that its counterweights cannot be replaced in.
    File(String),
}

impl fmt::Display for OptimiseError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            OptimiseError::Missing(missing) => missing.fmt(f),
            OptimiseError::NoPlaces => f.write_str(
                "the layout has no counterweights whose planes and radii could be taken; below [crankshaft], give balance_factor (any), counterweight_radius and web_offset, or list [[counterweight]] tables",
            ),
            OptimiseError::NoPlacesOn(crankshaft) => write!(
                f,
                "the crankshaft {} has no counterweights whose planes and radii could be taken; give it [[counterweight]] tables in two planes or more, each with the throw it belongs to",
                harmless(crankshaft)
            ),
            OptimiseError::OnePlane(position) => write!(
                f,
                "all counterweights of a crankshaft are at {position}: in one plane they make no couple; give web_offset below [crankshaft], or [[counterweight]] tables in two planes or more"
            ),
            OptimiseError::NoMasses => f.write_str(
                "the mass of the crankshaft is not known; below [mechanism], give reciprocating_mass or piston_mass, and stroke or crank_radius",
            ),
            OptimiseError::NoSpeed => f.write_str(
                "a couple in N·m needs speed and metres: give `speed` above the first table, and `spacing` or `positions` of the cylinders",
            ),
            OptimiseError::NoFirstOrder => {
                f.write_str("counterweights work on order 1, which is not among the orders; add it to `orders` or --orders")
            }
            OptimiseError::Points(points) => write!(f, "a front of {points} points; ask for 1 to {MOST_POINTS}"),
            OptimiseError::Couple(text) => {
                write!(f, "`{}` is not a bound of a couple; write zero, or newton-metres such as 50", harmless(text))
            }
            OptimiseError::Gas(lack) => write!(
                f,
                "effects ask for the gas: {lack}. Without \"gas\" in effects the loads of the masses alone are made least"
            ),
            OptimiseError::Still => f.write_str(
                "at a speed of 0 counterweights make no force; give `speed` above the first table, or leave \"gas\" out of effects",
            ),
            OptimiseError::Unsolved(reason) => write!(f, "the solver found no best counterweights: {reason}"),
            OptimiseError::File(reason) => write!(f, "the counterweights cannot be written into the layout file: {reason}"),
        }
    }
}

impl std::error::Error for OptimiseError {}

impl From<Missing> for OptimiseError {
    fn from(missing: Missing) -> Self {
        OptimiseError::Missing(missing)
    }
}
