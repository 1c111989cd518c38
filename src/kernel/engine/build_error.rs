//! Why is a draft no engine?

use std::fmt;

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
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum BuildError {
    /// No cylinder, or more than [`MOST_CYLINDERS`].
    Cylinders(usize),
    /// Two cylinders of the same name.
    SameName(String),
    /// A quantity below 0, or 0 where it has to be above.
    OutOfRange {
        /// Which, of what: `the crank radius of cylinder 2`.
        what: String,
        /// Its value.
        value: BigRational,
    },
    /// Some cylinders have a mechanism, and others none.
    MechanismMissing {
        /// The first cylinder without one.
        cylinder: String,
    },
    /// A rod that is too short for its crank and offset.
    CannotTurnRound {
        /// The cylinder.
        cylinder: String,
    },
    /// A number that is no order.
    Order(NotAnOrder),
    /// A list without exactly one value for each throw.
    List {
        /// What the list holds.
        of: &'static str,
        /// How many.
        values: usize,
        /// For this many throws.
        throws: usize,
    },
    /// A counterweight on a throw that is not there.
    NoSuchThrow(usize),
    /// A balancer shaft before the coefficient of a cylinder that is not there.
    NoSuchCylinder(usize),
    /// A cylinder on a crankshaft that is not there.
    NoSuchCrank {
        /// The cylinder.
        cylinder: String,
    },
    /// The first of several crankshafts is not the reference: it turns against it, or faster.
    FirstCrank,
    /// A crankshaft at a speed whose orders are not decided.
    Speed {
        /// The crankshaft.
        crank: String,
        /// How many times it turns while the reference turns once.
        speed: u32,
    },
    /// What is not computed where a crankshaft turns faster than the reference.
    FasterCrank(&'static str),
    /// A cylinder that is shared, but not by two pistons.
    Shared {
        /// One of them.
        cylinder: String,
    },
    /// A firing order that has not every cylinder once.
    Firing,
    /// A pressure that cannot be.
    Gas(GasMistake),
    /// A link without a master rod: its crankpin has none of this rod ratio at the angle that it names.
    NoMaster {
        /// The cylinder.
        cylinder: String,
    },
    /// What is computed of rods on the crankpins alone, in an engine with others.
    OfRodsAlone(NotARod, &'static str),
    /// Discs and springs that are no shaft for the crankpins.
    Torsion(NoShaft),
    /// A body on mounts that is none.
    Mounting(NoMounting),
}

impl fmt::Display for BuildError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            BuildError::Cylinders(count) => {
                write!(f, "an engine has 1 to {MOST_CYLINDERS} cylinders, this one has {count}")
            }
            BuildError::SameName(name) => write!(f, "two cylinders are called {name}"),
            BuildError::OutOfRange { what, value } => write!(f, "{what} is {value}, which is too small"),
            BuildError::MechanismMissing { cylinder } => {
                write!(f, "cylinder {cylinder} has no mechanism and others have one; give it to all, or to none")
            }
            BuildError::CannotTurnRound { cylinder } => {
                write!(f, "cylinder {cylinder} cannot turn round: its rod is too short")
            }
            BuildError::Order(number) => number.fmt(f),
            BuildError::List { of, values, throws } => {
                write!(f, "{values} {of} for {throws} throws; give one to each, or none")
            }
            BuildError::NoSuchThrow(index) => write!(f, "a counterweight on throw {}, which is not there", index + 1),
            BuildError::NoMaster { cylinder } => {
                write!(f, "the link of cylinder {cylinder} is on no rod of its crankpin")
            }
            BuildError::OfRodsAlone(with, what) => {
                write!(f, "with {with} {what} cannot be computed; leave it out, or give rods on the crankpins")
            }
            BuildError::NoSuchCylinder(index) => {
                write!(f, "a balancer shaft takes the coefficient of cylinder {}, which is not there", index + 1)
            }
            BuildError::NoSuchCrank { cylinder } => {
                write!(f, "cylinder {cylinder} is on a crankshaft that is not there")
            }
            BuildError::FirstCrank => {
                f.write_str("the first of several crankshafts turns with the reference, once while it turns once")
            }
            BuildError::Speed { crank, speed } => write!(
                f,
                "crankshaft {crank} turns {speed} times while the reference turns once, a whole number from 1 to {HIGHEST_ORDER}"
            ),
            BuildError::FasterCrank(what) => write!(
                f,
                "{what} in an engine with a crankshaft that turns faster than the reference: known where all turn equally fast so far"
            ),
            BuildError::Torsion(why) => why.fmt(f),
            BuildError::Mounting(why) => why.fmt(f),
            BuildError::Shared { cylinder } => {
                write!(f, "the cylinder of piston {cylinder} is shared, but not by two pistons")
            }
            BuildError::Firing => f.write_str("each cylinder fires once in a cycle"),
            BuildError::Gas(mistake) => mistake.fmt(f),
        }
    }
}

impl std::error::Error for BuildError {}

pub(super) fn not_negative(value: &BigRational, what: impl Fn() -> String) -> Result<(), BuildError> {
    in_range(!value.is_negative(), value, what)
}

pub(super) fn positive(value: &BigRational, what: impl Fn() -> String) -> Result<(), BuildError> {
    in_range(value.is_positive(), value, what)
}

fn in_range(fits: bool, value: &BigRational, what: impl Fn() -> String) -> Result<(), BuildError> {
    if fits { Ok(()) } else { Err(BuildError::OutOfRange { what: what(), value: value.clone() }) }
}
