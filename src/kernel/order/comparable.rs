//! Can the masses that turn be compared with those that go to and fro?

use num_traits::Zero;

use crate::engine::Engine;

/// What an engine lacks for its masses to be in one sum.
#[derive(Clone, Copy, Debug, PartialEq, Eq, thiserror::Error)]
pub enum NotComparable {
    /// The rotating masses cannot be compared with reciprocating ones that are not given.
    #[error(
        "the layout gives rotating masses, on rods, crankshaft or balancer shafts, but no reciprocating ones; below [mechanism], give reciprocating_mass or piston_mass"
    )]
    Masses,
    /// The radii of webs, counterweights or balancer shafts cannot be compared with a crank radius that is not given.
    #[error(
        "the layout gives webs, counterweights or balancer shafts but no crank; below [mechanism], give stroke or crank_radius"
    )]
    CrankRadius,
}

/// Whether the masses that turn can be compared with the reciprocating ones.
///
/// # Errors
/// What the engine lacks for that.
pub fn comparable(engine: &Engine) -> Result<(), NotComparable> {
    let (dimensions, crankshaft) = (engine.dimensions(), engine.crankshaft());
    let has_weights = !crankshaft.counterweights.is_empty() || !crankshaft.balancers.is_empty();
    let axes = || crankshaft.balancers.iter().filter_map(|shaft| shaft.axis.as_ref());
    let has_distances = axes().any(|axis| !axis.height.is_zero() || !axis.offset.is_zero());
    let in_metres = !crankshaft.webs.is_empty() || has_distances || (has_weights && !crankshaft.in_multiples);
    let has_rotating = engine.cylinders().iter().any(|cylinder| !cylinder.rotating_mass.is_zero());
    let turns = in_metres || has_rotating || !crankshaft.pins.is_empty();
    match (dimensions.mass.is_none() && turns, dimensions.crank_radius.is_none() && in_metres) {
        (true, _) => Err(NotComparable::Masses),
        (_, true) => Err(NotComparable::CrankRadius),
        _ => Ok(()),
    }
}
