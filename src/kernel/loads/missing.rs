//! What does a layout lack for numbers?

use std::fmt;

use crate::beam::BeamError;
use crate::engine::{Engine, NotARod, NotAnOrder};
use crate::firing::NoStar;
use crate::gas::NoGas;
use crate::order::NotComparable;

/// Why a layout has no numbers.
#[derive(Clone, Debug, PartialEq)]
pub enum Missing {
    /// No rod: without λ no coefficient is known.
    Rods,
    /// Masses that are not in one unit.
    NotComparable(NotComparable),
    /// Forces that no decimal can hold.
    TooLarge,
    /// Methods are compared for what moves with the crank alone.
    BalancerShafts,
    /// Methods are compared for crankshafts that all turn the same way.
    CranksAgainstEachOther,
    /// A crank that cannot turn round.
    Motion(String),
    /// A number that is no order.
    Order(NotAnOrder),
    /// What is computed of rods on the crankpins alone, in an engine with others.
    OfRodsAlone(NotARod, &'static str),
    /// What is not computed where a crankshaft turns faster than the reference.
    FasterCrank(&'static str),
    /// No main bearings.
    Bearings,
    /// Main bearings that hold no shaft.
    Beam(BeamError),
    /// Numbers of its gas.
    Gas(NoGas),
    /// When its cylinders fire.
    Firing,
    /// A reciprocating mass or a speed, without which gas and masses are in no common unit.
    MassesOrSpeed,
}

impl fmt::Display for Missing {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Missing::Rods => f.write_str(
                "the layout gives no rods; below [mechanism], give rod_ratio, or rod_length with stroke or crank_radius",
            ),
            Missing::NotComparable(what) => what.fmt(f),
            Missing::TooLarge => {
                f.write_str("m r ω² and m r² ω² have to be below 10^150: mass, crank radius or speed of the layout is too large for decimals")
            }
            Missing::BalancerShafts => {
                f.write_str("the methods are compared for engines without balancer shafts; omit [[balancer]]")
            }
            Missing::CranksAgainstEachOther => {
                f.write_str("the methods are compared for engines whose crankshafts all turn the same way at the same speed")
            }
            Missing::Motion(reason) => f.write_str(reason),
            Missing::Order(number) => number.fmt(f),
            Missing::OfRodsAlone(with, what) => write!(f, "not available for an engine with {with}: {what}"),
            Missing::FasterCrank(what) => {
                write!(f, "not available for an engine with a crankshaft that turns faster than the reference: {what}")
            }
            Missing::Bearings => f.write_str(
                "the layout gives no main bearings; above the first table, give their positions: bearings = [0.15, 0.05, -0.05, -0.15]",
            ),
            Missing::Beam(mistake) => mistake.fmt(f),
            Missing::Gas(lack) => lack.fmt(f),
            Missing::Firing => NoStar::NoFiring.fmt(f),
            Missing::MassesOrSpeed => f.write_str(
                "the layout gives no masses or no speed; add speed = 3000 above the first table, in revolutions a minute, and reciprocating_mass below [mechanism]",
            ),
        }
    }
}

impl std::error::Error for Missing {}

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

impl From<NotAnOrder> for Missing {
    fn from(what: NotAnOrder) -> Self {
        Missing::Order(what)
    }
}

impl From<NoGas> for Missing {
    fn from(lack: NoGas) -> Self {
        Missing::Gas(lack)
    }
}

impl From<NotComparable> for Missing {
    fn from(what: NotComparable) -> Self {
        Missing::NotComparable(what)
    }
}
