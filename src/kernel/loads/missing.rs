//! What does a layout lack for numbers?

use crate::beam::BeamError;
use crate::engine::{Engine, NotARod, NotAnOrder};
use crate::firing::NoStar;
use crate::gas::NoGas;
use crate::order::NotComparable;

/// Why a layout has no numbers.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum Missing {
    /// No rod: without λ no coefficient is known.
    #[error("the layout gives no rods; below [mechanism], give rod_ratio, or rod_length with stroke or crank_radius")]
    Rods,
    /// Masses that are not in one unit.
    #[error(transparent)]
    NotComparable(#[from] NotComparable),
    /// Forces that no decimal can hold.
    #[error(
        "m r ω² and m r² ω² have to be below 10^150: mass, crank radius or speed of the layout is too large for decimals"
    )]
    TooLarge,
    /// Methods are compared for what moves with the crank alone.
    #[error("the methods are compared for engines without balancer shafts; omit [[balancer]]")]
    BalancerShafts,
    /// Methods are compared for crankshafts that all turn the same way.
    #[error("the methods are compared for engines whose crankshafts all turn the same way at the same speed")]
    CranksAgainstEachOther,
    /// A crank that cannot turn round.
    #[error("{0}")]
    Motion(String),
    /// A number that is no order.
    #[error(transparent)]
    Order(#[from] NotAnOrder),
    /// What is computed of rods on the crankpins alone, in an engine with others.
    #[error("not available for an engine with {0}: {1}")]
    OfRodsAlone(NotARod, &'static str),
    /// What is not computed where a crankshaft turns faster than the reference.
    #[error("not available for an engine with a crankshaft that turns faster than the reference: {0}")]
    FasterCrank(&'static str),
    /// No main bearings.
    #[error(
        "the layout gives no main bearings; above the first table, give their positions: bearings = [0.15, 0.05, -0.05, -0.15]"
    )]
    Bearings,
    /// Main bearings that hold no shaft.
    #[error("{0}")]
    Beam(BeamError),
    /// Numbers of its gas.
    #[error(transparent)]
    Gas(#[from] NoGas),
    /// When its cylinders fire.
    #[error("{}", NoStar::NoFiring)]
    Firing,
    /// A reciprocating mass or a speed, without which gas and masses are in no common unit.
    #[error(
        "the layout gives no masses or no speed; add speed = 3000 above the first table, in revolutions a minute, and reciprocating_mass below [mechanism]"
    )]
    MassesOrSpeed,
}

impl Missing {
    /// Whether the orders of the inertia torque are judged, on which this rests.
    ///
    /// # Errors
    /// What moves a piston of which they are decimals.
    pub fn unless_torque_is_judged(engine: &Engine, what: &'static str) -> Result<(), Missing> {
        match engine.has_judged_torque() {
            true => Ok(()),
            false => engine.only_rods().map_err(|with| Missing::OfRodsAlone(with, what)),
        }
    }
}
