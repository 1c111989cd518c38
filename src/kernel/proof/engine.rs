//! Which engine is a document about? Cylinders with their rods, as the sums see them.

use std::collections::BTreeSet;

use num_rational::BigRational;
use num_traits::{One, Signed, Zero};
use serde::{Deserialize, Serialize};

use super::audit::{Fault, Reason, demand, refuse_if};
use super::collected::turn;
use super::fraction;
use super::link::LinkClaim;
use super::quantity::{Quantity, Sense};
use super::rod::RodClaim;
use super::vector::Vector;

/// A cylinder as the phasors see it.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Cylinder {
    /// What the cylinder is called.
    pub name: String,
    /// Crank-throw angle β, in turns.
    #[serde(with = "fraction")]
    pub throw: BigRational,
    /// Angle α of the cylinder axis, in turns.
    #[serde(with = "fraction")]
    pub bank: BigRational,
    /// Position along the crankshaft, in the unit of the reference plane.
    #[serde(with = "fraction")]
    pub position: BigRational,
    /// Reciprocating mass, in kilograms (or multiples of a common mass).
    #[serde(with = "fraction")]
    pub reciprocating_mass: BigRational,
    /// Crank radius, in multiples of a common radius.
    #[serde(with = "fraction")]
    pub crank_radius: BigRational,
    /// Its rod.
    pub rod: RodStatement,
    /// Mass at the knuckle pin of its link times the crank radius, in multiples of m r; omitted where it is 0.
    #[serde(with = "fraction", default = "BigRational::zero", skip_serializing_if = "BigRational::is_zero")]
    pub knuckle_weight: BigRational,
    /// How many times its crankshaft turns while the reference one turns once: a whole number from 1 on, omitted where it is 1.
    #[serde(default = "once", skip_serializing_if = "is_once")]
    pub speed: u32,
    /// Its crankshaft, where several are geared together; its throw and rod are then those of the equivalent crank that turns with
    /// the reference.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub crankshaft: Option<CrankClaim>,
}

impl Cylinder {
    /// The order of its own motion that this order of the engine is, where its crankshaft has part in it.
    pub(super) fn own_order(&self, order: u32) -> Option<u32> {
        own_order(self.speed, order)
    }

    /// What it does is larger by this for the speed of its crankshaft: a force by the square, the torque at the reference one by the cube.
    pub(super) fn power(&self, exponent: usize) -> BigRational {
        power(self.speed, exponent)
    }
}

/// The order of a crank of this speed that is this order of the engine.
pub(super) fn own_order(speed: u32, order: u32) -> Option<u32> {
    (speed > 0 && order.is_multiple_of(speed)).then(|| order / speed)
}

/// A power of a speed.
pub(super) fn power(speed: u32, exponent: usize) -> BigRational {
    num_traits::pow(BigRational::from_integer(speed.into()), exponent)
}

/// The speed where none is given.
pub(super) fn once() -> u32 {
    1
}

#[expect(clippy::trivially_copy_pass_by_ref, reason = "serde hands a reference")]
pub(super) fn is_once(speed: &u32) -> bool {
    *speed == 1
}

/// Checks that a crankshaft turns a whole number of times, and that nothing is on a faster one that is not judged there.
pub(super) fn check_speed(rod: &RodStatement, speed: u32) -> Result<(), Reason> {
    refuse_if(speed == 0, "a crankshaft turns once at least while the reference one turns once")?;
    let is_held = speed == 1 || rod.link().is_none();
    Ok(demand(is_held, "a link on a crankshaft that turns faster than the reference one")?)
}

/// One of several crankshafts.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct CrankClaim {
    /// Whether it turns with the reference or against it.
    pub sense: Sense,
    /// Where its axis is in the plane across it: the sum of these, in multiples of the common radius.
    pub axis: Vec<Vector>,
}

/// What is said of a rod.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "lowercase", deny_unknown_fields)]
pub enum RodStatement {
    /// Nothing: all rods of the engine are taken to be equal and centric.
    Unknown,
    /// This rod.
    Known(RodClaim),
    /// This link on the rod of another cylinder.
    Link(LinkClaim),
}

impl RodStatement {
    /// Whether it is a rod on the crankpin, or is taken for one.
    pub fn is_rod(&self) -> bool {
        *self == RodStatement::Unknown || self.on_the_pin().is_some()
    }

    /// Whether it is a rod on the crankpin whose cylinder axis meets the crankshaft, or is taken for one.
    pub fn is_centric(&self) -> bool {
        match self {
            RodStatement::Unknown => true,
            RodStatement::Known(rod) => rod.offset.is_zero(),
            RodStatement::Link(_) => false,
        }
    }

    /// The link, where it is one.
    pub(super) fn link(&self) -> Option<&LinkClaim> {
        match self {
            RodStatement::Link(link) => Some(link),
            RodStatement::Unknown | RodStatement::Known(_) => None,
        }
    }

    /// The rod, where one on the crankpin is named.
    pub fn on_the_pin(&self) -> Option<&RodClaim> {
        match self {
            RodStatement::Known(rod) => Some(rod),
            RodStatement::Unknown | RodStatement::Link(_) => None,
        }
    }
}

/// Whose masses the verdicts are about.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum Masses {
    /// The reciprocating masses alone.
    Reciprocating,
    /// What turns with the crankpins: the rotating parts of the rods, pins and webs.
    Rotating,
    /// The counterweights alone.
    Counterweights,
    /// All that the layout names, balancer shafts among them: the engine as it is built.
    All,
}

impl Masses {
    /// In words.
    pub fn name(self) -> &'static str {
        match self {
            Masses::Reciprocating => "the reciprocating masses",
            Masses::Rotating => "the rotating masses",
            Masses::Counterweights => "the counterweights",
            Masses::All => "all masses",
        }
    }
}

/// A mass that turns at a multiple of the crank speed, with a name.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct TurningMassClaim {
    /// What it is called: no cylinder and no other mass is called so.
    pub name: String,
    /// The multiple.
    pub order: u32,
    /// With the crank or against it.
    pub sense: Sense,
    /// Position along the crankshaft, in the unit of the reference plane.
    #[serde(with = "fraction")]
    pub position: BigRational,
    /// Its direction at θ = 0, in turns.
    #[serde(with = "fraction")]
    pub angle: BigRational,
    /// Mass times radius, in multiples of m r, as a cylinder's mass times its crank radius is.
    #[serde(with = "fraction")]
    pub mass_radius: BigRational,
    /// The rod whose coefficient c_k of this order the mass-radius is multiplied by; omitted for 1.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub coefficient_of: Option<RodStatement>,
    /// Where the axis that it turns about is in the plane across it, in multiples of the common radius: the sum of these; none
    /// where that is the middle.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub axis: Vec<Vector>,
}

/// The rods on the crankpins of an engine that names its rods; none where it names none.
pub(super) fn rods<'a>(
    statements: impl Iterator<Item = &'a RodStatement>,
) -> Result<Option<Vec<&'a RodClaim>>, Reason> {
    let (mut known, mut links, mut unknown) = (Vec::new(), Vec::new(), 0);
    for statement in statements {
        match statement {
            RodStatement::Unknown => unknown += 1,
            RodStatement::Known(rod) => known.push(rod),
            RodStatement::Link(link) => links.push(link),
        }
    }
    if let Some(link) = links.iter().find(|link| !link.turns_round()) {
        let LinkClaim { master, knuckle, angle, correction, ratio } = link;
        let corrected = if link.is_corrected() { format!(", correction {correction}") } else { String::new() };
        let link = format!("master {master}, knuckle {knuckle}, angle {angle}{corrected}, ratio {ratio}");
        return Err(format!("a link cannot turn round: {link}").into());
    }
    let turns_round = |rod: &&RodClaim| !rod.ratio.is_negative() && &rod.ratio + rod.offset.abs() < BigRational::one();
    if let Some(rod) = known.iter().find(|rod| !turns_round(rod)) {
        return Err(format!("a rod of ratio {} and offset {} cannot turn round", rod.ratio, rod.offset).into());
    }
    match (known.len() + links.len(), unknown) {
        (_, 0) => Ok(Some(known)),
        (0, _) => Ok(None),
        (given, missing) => Err(format!("{given} rods are known and {missing} are not; all are, or none").into()),
    }
}

/// Checks that no mass is below 0.
pub(super) fn check_masses<'a>(mut masses: impl Iterator<Item = &'a BigRational>) -> Result<(), Reason> {
    Ok(refuse_if(masses.any(Signed::is_negative), "a mass is less than nothing")?)
}

/// Checks that crank radii are above 0.
pub(super) fn check_radii<'a>(mut radii: impl Iterator<Item = &'a BigRational>) -> Result<(), Reason> {
    Ok(demand(radii.all(Signed::is_positive), "a crank radius is not above 0")?)
}

/// What a master rod and its links have in common: their crankpin (its throw in turns of one revolution, and what else a document says of
/// it), the axis of the master's cylinder, λ of its rod.
type Master<'a, const N: usize> = (BigRational, [&'a BigRational; N], BigRational, BigRational);

/// Checks that each link hangs on a master rod of the engine: one without offset, on the same crankpin, with its axis at the angle that is said.
/// Of each cylinder throw, bank and rod, and what else the document says of its crankpin: crank radius, position.
pub(super) fn check_masters<'a, const N: usize>(
    cylinders: impl Iterator<Item = (&'a BigRational, &'a BigRational, &'a RodStatement, [&'a BigRational; N])>,
) -> Result<(), Reason> {
    let (mut masters, mut links) = (BTreeSet::new(), Vec::<(Master<'a, N>, &LinkClaim)>::new());
    for (throw, bank, rod, pin) in cylinders {
        let master = |axis: BigRational, ratio: &BigRational| (turn(throw), pin, turn(&axis), ratio.clone());
        match rod {
            RodStatement::Known(rod) if rod.offset.is_zero() => {
                masters.insert(master(bank.clone(), &rod.ratio));
            }
            RodStatement::Link(link) => links.push((master(bank - &link.angle, &link.master), link)),
            RodStatement::Known(_) | RodStatement::Unknown => {}
        }
    }
    match links.iter().find(|(master, _)| !masters.contains(master)) {
        None => Ok(()),
        Some(((throw, _, axis, ratio), link)) => Err(format!(
            "a link at {} turns from its master rod has none: no rod of ratio {ratio} without offset is on the crankpin at {throw}, with its axis at {axis}",
            link.angle
        )
        .into()),
    }
}

/// Checks that the engine has cylinders, each with a name of its own.
pub(super) fn check_names<'a>(names: impl Iterator<Item = &'a str>) -> Result<(), Fault> {
    let mut seen = BTreeSet::new();
    for name in names {
        if !seen.insert(name) {
            return Err(Fault::new("cylinders", format!("two cylinders are called {name}")));
        }
    }
    if seen.is_empty() { Err(Fault::new("cylinders", "an engine has one at least")) } else { Ok(()) }
}

/// Checks that the orders asked for are rising and exist, and the quantities are in the order force, moment, torque, roll.
pub(super) fn check_asked(orders: &[u32], quantities: &[Quantity]) -> Result<(), Fault> {
    refuse_if(orders.is_empty(), Fault::new("orders", "the list is empty, there is nothing to check"))?;
    if orders[0] == 0 || orders.windows(2).any(|pair| pair[0] >= pair[1]) {
        return Err(Fault::new("orders", "orders rise from 1 on, each once"));
    }
    refuse_if(quantities.is_empty(), Fault::new("quantities", "the list is empty, there is nothing to check"))?;
    match quantities.windows(2).all(|pair| pair[0] < pair[1]) {
        true => Ok(()),
        false => Err(Fault::new("quantities", "they are in the order force, moment, torque, roll, each once")),
    }
}

/// Checks that no shaft takes the coefficient of a link, which has several.
pub(super) fn check_shafts<'a>(mut rods: impl Iterator<Item = &'a RodStatement>) -> Result<(), Reason> {
    let has_link = rods.any(|rod| rod.link().is_some());
    Ok(refuse_if(has_link, "a shaft takes the coefficient of a link, which has several")?)
}

/// Checks that a mass at a knuckle pin hangs on a link.
pub(super) fn check_knuckle(rod: &RodStatement, weight: &BigRational) -> Result<(), Reason> {
    Ok(demand(rod.link().is_some() || weight.is_zero(), "a knuckle weight without a link")?)
}
