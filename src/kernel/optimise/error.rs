//! Why are there no best counterweights?

use crate::loads::Missing;
use crate::text::harmless;

/// More points than this say nothing more.
pub(super) const MOST_POINTS: usize = 200;

/// Why an engine cannot be optimised.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum OptimiseError {
    /// What the engine lacks for the loads of its bearings.
    #[error(transparent)]
    Missing(#[from] Missing),
    /// No counterweights, so no planes for them.
    #[error(
        "the layout has no counterweights whose planes and radii could be taken; below [crankshaft], give balance_factor (any), counterweight_radius and web_offset, or list [[counterweight]] tables"
    )]
    NoPlaces,
    /// None on one of several crankshafts.
    #[error("the crankshaft {} has no counterweights whose planes and radii could be taken; give it [[counterweight]] tables in two planes or more, each with the throw it belongs to", harmless(.0))]
    NoPlacesOn(String),
    /// All counterweights in one plane, where they make no couple.
    #[error(
        "all counterweights of a crankshaft are at {0}: in one plane they make no couple; give web_offset below [crankshaft], or [[counterweight]] tables in two planes or more"
    )]
    OnePlane(String),
    /// No masses: the crankshaft's mass is not known.
    #[error(
        "the mass of the crankshaft is not known; below [mechanism], give reciprocating_mass or piston_mass, and stroke or crank_radius"
    )]
    NoMasses,
    /// No speed or no metres, so that a bound in newton-metres says nothing.
    #[error(
        "a couple in N·m needs speed and metres: give `speed` above the first table, and `spacing` or `positions` of the cylinders"
    )]
    NoSpeed,
    /// The first order, which counterweights work on, is not among the orders.
    #[error("counterweights work on order 1, which is not among the orders; add it to `orders` or --orders")]
    NoFirstOrder,
    /// No points asked for, or more than say anything more.
    #[error("a front of {0} points; ask for 1 to {MOST_POINTS}")]
    Points(usize),
    /// What is no bound of a couple.
    #[error("`{}` is not a bound of a couple; write zero, or newton-metres such as 50", harmless(.0))]
    Couple(String),
    /// The gas is asked for, and something lacks for it.
    #[error("effects ask for the gas: {0}. Without \"gas\" in effects the loads of the masses alone are made least")]
    Gas(String),
    /// The crankshaft stands still: no counterweight makes a force.
    #[error("at a speed of 0 counterweights make no force; give a `speed` above 0, or none for loads in m r ω²")]
    Still,
    /// The solver found no solution.
    #[error("the solver found no best counterweights: {0}")]
    Unsolved(String),
    /// The layout file is written in a way that its counterweights cannot be replaced in.
    #[error("the counterweights cannot be written into the layout file: {0}")]
    File(String),
}
