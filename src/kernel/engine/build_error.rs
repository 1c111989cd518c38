//! Why is a draft no engine?

use num_rational::BigRational;
use num_traits::Signed;

use super::gas::GasMistake;
use super::mechanism::NotARod;
use super::mounting::NoMounting;
use super::order::{HIGHEST_ORDER, NotAnOrder};
use super::torsion::NoShaft;

/// An engine has at most this many cylinders.
pub const MOST_CYLINDERS: usize = 2000;

/// Why a draft is no engine.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
pub enum BuildError {
    /// No cylinder, or more than [`MOST_CYLINDERS`].
    #[error("an engine has 1 to {MOST_CYLINDERS} cylinders, this one has {0}")]
    Cylinders(usize),
    /// Two cylinders of the same name.
    #[error("two cylinders are called {0}")]
    SameName(String),
    /// A quantity below 0, or 0 where it has to be above.
    #[error("{what} is {value}, which is too small")]
    OutOfRange {
        /// Which, of what: `the crank radius of cylinder 2`.
        what: String,
        /// Its value.
        value: BigRational,
    },
    /// Some cylinders have a mechanism, and others none.
    #[error("cylinder {0} has no mechanism and others have one; give it to all, or to none")]
    MechanismMissing(String),
    /// A rod that is too short for its crank and offset.
    #[error("cylinder {0} cannot turn round: its rod is too short")]
    CannotTurnRound(String),
    /// A number that is no order.
    #[error("{0}")]
    Order(NotAnOrder),
    /// A list without exactly one value for each throw.
    #[error("{values} {of} for {throws} throws; give one to each, or none")]
    List {
        /// What the list holds.
        of: &'static str,
        /// How many.
        values: usize,
        /// For this many throws.
        throws: usize,
    },
    /// A counterweight on a throw that is not there.
    #[error("a counterweight on throw {}, which is not there", .0 + 1)]
    NoSuchThrow(usize),
    /// A balancer shaft before the coefficient of a cylinder that is not there.
    #[error("a balancer shaft takes the coefficient of cylinder {}, which is not there", .0 + 1)]
    NoSuchCylinder(usize),
    /// A cylinder on a crankshaft that is not there.
    #[error("cylinder {0} is on a crankshaft that is not there")]
    NoSuchCrank(String),
    /// The first of several crankshafts is not the reference: it turns against it, or faster.
    #[error("the first of several crankshafts turns with the reference, once while it turns once")]
    FirstCrank,
    /// A crankshaft at a speed whose orders are not decided.
    #[error(
        "crankshaft {crank} turns {speed} times while the reference turns once, a whole number from 1 to {HIGHEST_ORDER}"
    )]
    Speed {
        /// The crankshaft.
        crank: String,
        /// How many times it turns while the reference turns once.
        speed: u32,
    },
    /// What is not computed where a crankshaft turns faster than the reference.
    #[error(
        "{0} in an engine with a crankshaft that turns faster than the reference: known where all turn equally fast so far"
    )]
    FasterCrank(&'static str),
    /// A cylinder that is shared, but not by two pistons.
    #[error("the cylinder of piston {0} is shared, but not by two pistons")]
    Shared(String),
    /// A firing order that has not every cylinder once.
    #[error("each cylinder fires once in a cycle")]
    Firing,
    /// A pressure that cannot be.
    #[error("{0}")]
    Gas(GasMistake),
    /// A link without a master rod: its crankpin has none of this rod ratio at the angle that it names.
    #[error("the link of cylinder {0} is on no rod of its crankpin")]
    NoMaster(String),
    /// What is computed of rods on the crankpins alone, in an engine with others.
    #[error("with {0} {1} cannot be computed; leave it out, or give rods on the crankpins")]
    OfRodsAlone(NotARod, &'static str),
    /// Discs and springs that are no shaft for the crankpins.
    #[error("{0}")]
    Torsion(NoShaft),
    /// A body on mounts that is none.
    #[error("{0}")]
    Mounting(NoMounting),
}

pub(super) fn not_negative(value: &BigRational, what: impl Fn() -> String) -> Result<(), BuildError> {
    in_range(!value.is_negative(), value, what)
}

pub(super) fn positive(value: &BigRational, what: impl Fn() -> String) -> Result<(), BuildError> {
    in_range(value.is_positive(), value, what)
}

fn in_range(fits: bool, value: &BigRational, what: impl Fn() -> String) -> Result<(), BuildError> {
    if fits { Ok(()) } else { Err(BuildError::OutOfRange { what: what(), value: value.clone() }) }
}
