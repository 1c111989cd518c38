//! crankstar decides, exactly, how a reciprocating engine balances, and writes the proof.
//!
//! An engine's inertia forces are sums of rotating vectors, one a cylinder and order. Whether such a sum vanishes is
//! decided here in exact arithmetic, and every verdict carries a certificate that a separate checker accepts.
//!
//! ```standalone_crate
//! use crankstar::proof::{Quantity, Sense};
//! let v8 = crankstar::file::find("V8-crossplane").unwrap().engine().unwrap();
//! let order_1 = crankstar::order::star(&v8, Quantity::Force, 1, Some(Sense::Direct));
//! println!("{}", serde_json::to_string(&order_1.certificate()).unwrap());
//! // {"kind":"polygons","polygons":[{"sides":2,"rotation":"0","weight":"2"},{"sides":2,"rotation":"1/4","weight":"2"}]}
//! # assert_eq!(
//! #     serde_json::to_string(&order_1.certificate()).unwrap(),
//! #     r#"{"kind":"polygons","polygons":[{"sides":2,"rotation":"0","weight":"2"},{"sides":2,"rotation":"1/4","weight":"2"}]}"#
//! # );
//! ```
//!
//! # The rooms
//!
//! ```text
//! cli
//! report
//! claim
//! accuracy  remedy  optimise  sweep  search
//! loads  family
//! verdict
//! order  numbers
//! file
//! engine
//! exact
//! proof  motion  beam  text
//! ```
//!
//! A room imports from the storeys below it and nothing from its own; a test reads the imports and holds it to that. Floats
//! do not compile in `proof`, `exact`, `beam`, `layout`, `order` and `verdict`.
//!
//! # Features
//!
//! All are on by default. Without any (`default-features = false`) the crate is the library without `report` and `optimise`: it
//! decides, proves and checks, needs neither threads nor files, and builds for WebAssembly.
//!
//! - `report`: the room `report`, pages and documents.
//! - `optimise`: the room `optimise`, with its solver for convex problems.
//! - `cli`: the program; it takes `report` along.
//!
//! Comments cite the theory by section: `docs/theory.md` has the formulas, and whose they are.

#![warn(missing_docs)]

#[deny(clippy::disallowed_types, clippy::float_arithmetic)]
pub mod beam;
#[deny(clippy::disallowed_types, clippy::float_arithmetic)]
pub mod engine;
#[deny(clippy::disallowed_types, clippy::float_arithmetic)]
pub mod exact;
#[deny(clippy::disallowed_types, clippy::float_arithmetic)]
pub mod file;
#[deny(clippy::disallowed_types, clippy::float_arithmetic)]
pub mod order;
#[deny(clippy::disallowed_types, clippy::float_arithmetic)]
pub mod proof;
#[deny(clippy::disallowed_types, clippy::float_arithmetic)]
pub mod text;
#[deny(clippy::disallowed_types, clippy::float_arithmetic)]
pub mod verdict;

#[allow(clippy::disallowed_types)]
pub mod accuracy;
#[allow(clippy::disallowed_types)]
pub mod claim;
#[allow(clippy::disallowed_types)]
pub mod family;
#[allow(clippy::disallowed_types)]
pub mod loads;
#[allow(clippy::disallowed_types)]
pub mod motion;
#[allow(clippy::disallowed_types)]
pub mod numbers;
#[cfg(feature = "optimise")]
#[allow(clippy::disallowed_types)]
pub mod optimise;
#[allow(clippy::disallowed_types)]
pub mod remedy;
#[cfg(feature = "report")]
#[allow(clippy::disallowed_types)]
pub mod report;
#[allow(clippy::disallowed_types)]
pub mod search;
#[allow(clippy::disallowed_types)]
pub mod sweep;
