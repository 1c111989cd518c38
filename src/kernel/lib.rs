//! Decides, exactly, how a reciprocating engine balances: the library of crankstar without its pages and commands.
//!
//! The crate `crankstar` has every room of it under the same name, and the pages, documents and commands besides; who wants these depends on that
//! one. This one compiles alone, for a browser too: it decides, proves, checks and weighs. Threads, files and a clock are needed by `shard`, `sweep`,
//! `search` and `accuracy` alone.
//!
//! ```
//! # fn main() -> Result<(), Box<dyn std::error::Error>> {
//! use crankstar_kernel::{Masses, Quantity, classify, parse};
//! let v8 = parse("V8.toml", "title = 'V8'\nvee = { bank_angle = 90, throws = [0, 90, 270, 180] }")?;
//! let [first, second] = &classify(&v8, &[1, 2], Masses::All, &Quantity::PLANAR)?[..] else { panic!() };
//! assert!(first.force.is_balanced() && !first.moment.is_balanced());
//! assert!(second.force.is_balanced() && second.moment.is_balanced());
//! # Ok(())
//! # }
//! ```
//!
//! # The rooms
//!
//! ```text
//! classroom
//! claim  optimise
//! flywheel  journal  mounts
//! accuracy  remedy  sweep  search  torque  torsion
//! loads  family  rotor
//! firing
//! verdict
//! order  numbers  gas  stars
//! file
//! engine
//! exact  shard  table
//! proof  motion  beam  text
//! ```
//!
//! A room imports from the storeys below it and nothing from its own; a test reads the imports and holds it to that. Clippy
//! refuses floats in `proof`, `exact`, `beam`, `classroom`, `engine`, `file`, `firing`, `order`, `stars`, `text` and `verdict`.
//!
//! # Features
//!
//! - `optimise`: the room `optimise`, with its solver for convex problems.
//! - `xlsx`, `parquet`: tables of data ([`table`]) as workbooks and as Parquet, besides CSV.
//!
//! Comments cite the theory by section: `docs/theory.md` of the repository has the formulas, and whose they are.

#![warn(missing_docs)]

#[allow(clippy::disallowed_types)]
pub mod accuracy;
#[deny(clippy::disallowed_types, clippy::float_arithmetic)]
pub mod beam;
#[allow(clippy::disallowed_types)]
pub mod claim;
#[deny(clippy::disallowed_types, clippy::float_arithmetic)]
pub mod classroom;
#[deny(clippy::disallowed_types, clippy::float_arithmetic)]
pub mod engine;
#[deny(clippy::disallowed_types, clippy::float_arithmetic)]
pub mod exact;
#[allow(clippy::disallowed_types)]
pub mod family;
#[deny(clippy::disallowed_types, clippy::float_arithmetic)]
pub mod file;
#[deny(clippy::disallowed_types, clippy::float_arithmetic)]
pub mod firing;
#[allow(clippy::disallowed_types)]
pub mod flywheel;
#[allow(clippy::disallowed_types)]
pub mod gas;
#[allow(clippy::disallowed_types)]
pub mod journal;
#[allow(clippy::disallowed_types)]
pub mod loads;
#[allow(clippy::disallowed_types)]
pub mod motion;
#[allow(clippy::disallowed_types)]
pub mod mounts;
#[allow(clippy::disallowed_types)]
pub mod numbers;
#[cfg(feature = "optimise")]
#[allow(clippy::disallowed_types)]
pub mod optimise;
#[deny(clippy::disallowed_types, clippy::float_arithmetic)]
pub mod order;
#[deny(clippy::disallowed_types, clippy::float_arithmetic)]
pub mod proof;
#[allow(clippy::disallowed_types)]
pub mod remedy;
#[allow(clippy::disallowed_types)]
pub mod rotor;
#[allow(clippy::disallowed_types)]
pub mod search;
pub mod shard;
#[deny(clippy::disallowed_types, clippy::float_arithmetic)]
pub mod stars;
#[allow(clippy::disallowed_types)]
pub mod sweep;
#[allow(clippy::disallowed_types)]
pub mod table;
#[deny(clippy::disallowed_types, clippy::float_arithmetic)]
pub mod text;
#[allow(clippy::disallowed_types)]
pub mod torque;
#[allow(clippy::disallowed_types)]
pub mod torsion;
#[deny(clippy::disallowed_types, clippy::float_arithmetic)]
pub mod verdict;

pub use engine::{BuildError, Cycle, Cylinder, Draft, Engine, Family, Mechanism, Rod};
pub use exact::{PhasorSum, Turn};
pub use file::{Layout, LayoutError, find, parse, parse_layout};
pub use order::Masses;
pub use proof::{
    AnyDocument, Axial, Certificate, Checked, Fault, Planar, Quantity, Refusal, Sense, Unreadable, check_certificate,
    read_document,
};
pub use verdict::classify;

/// The numbers of an engine: positions, masses, ratios.
pub use num_rational::BigRational;
