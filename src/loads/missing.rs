//! What does a layout lack for numbers?

use std::fmt;

use num_traits::Zero;

use crate::beam::Mistake;
use crate::engine::{self, Engine};

/// Why a layout has no numbers.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Missing {
    /// No rod: without λ no coefficient is known.
    Rods,
    /// The rotating masses cannot be compared with reciprocating ones that are not given.
    Masses,
    /// The radii of webs, counterweights or balancer shafts cannot be compared with a crank radius that is not given.
    CrankRadius,
    /// Forces that no decimal can hold.
    TooLarge,
    /// Methods are compared for what moves with the crank alone.
    BalancerShafts,
    /// A crank that cannot turn round.
    Motion(String),
    /// A number that is no order.
    Order(u32),
    /// No main bearings.
    Bearings,
    /// Main bearings that hold no shaft.
    Beam(Mistake),
}

impl fmt::Display for Missing {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Missing::Rods => f.write_str(
                "the layout says nothing of its rods; below [mechanism], give rod_ratio, or rod_length with stroke or crank_radius",
            ),
            Missing::Masses => f.write_str(
                "the layout gives rotating masses, on rods, crankshaft or balancer shafts, but no reciprocating ones; below [mechanism], give reciprocating_mass or piston_mass",
            ),
            Missing::CrankRadius => f.write_str(
                "the layout gives webs, counterweights or balancer shafts but no crank; below [mechanism], give stroke or crank_radius",
            ),
            Missing::TooLarge => {
                f.write_str("m r ω² and m r² ω² have to be below 10^150: mass, crank radius or speed of the layout is too large for decimals")
            }
            Missing::BalancerShafts => {
                f.write_str("the methods are compared for engines without balancer shafts; leave out [[balancer]]")
            }
            Missing::Motion(reason) => f.write_str(reason),
            Missing::Order(number) => {
                write!(f, "{number} is no order; an order is a whole number from 1 to {}", engine::ORDERS.end())
            }
            Missing::Bearings => f.write_str(
                "the layout says nothing of its main bearings; above the first table, give their positions: bearings = [0.15, 0.05, -0.05, -0.15]",
            ),
            Missing::Beam(mistake) => mistake.fmt(f),
        }
    }
}

impl std::error::Error for Missing {}

/// Whether every number of a list is an order.
///
/// # Errors
/// The first that is none.
pub fn are_orders(orders: &[u32]) -> Result<(), Missing> {
    match orders.iter().find(|order| !engine::ORDERS.contains(order)) {
        None => Ok(()),
        Some(&other) => Err(Missing::Order(other)),
    }
}

/// Whether the masses that turn can be compared with the reciprocating ones.
///
/// # Errors
/// What the layout lacks for that.
pub fn comparable(layout: &Engine) -> Result<(), Missing> {
    let (mechanism, crankshaft) = (layout.dimensions(), layout.crankshaft());
    let in_metres =
        !crankshaft.webs.is_empty() || !crankshaft.counterweights.is_empty() || !crankshaft.balancers.is_empty();
    let turns = in_metres
        || layout.cylinders().iter().any(|cylinder| !cylinder.rotating_mass.is_zero())
        || !crankshaft.pins.is_empty();
    match (mechanism.mass.is_none() && turns, mechanism.crank_radius.is_none() && in_metres) {
        (true, _) => Err(Missing::Masses),
        (_, true) => Err(Missing::CrankRadius),
        _ => Ok(()),
    }
}
