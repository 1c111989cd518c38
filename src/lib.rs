//! crankstar decides, exactly, how a reciprocating engine balances, and writes the proof.
//!
//! An engine's inertia forces are sums of rotating vectors, one per cylinder and order. Whether such a sum vanishes is
//! decided here in exact arithmetic, and every verdict carries a certificate that a separate checker accepts.
//!
//! The cross-plane V8 shakes with no force; its moment of order 1 rotates, so that counterweights cancel it, and order 2 vanishes:
//!
//! ```
//! # fn main() -> Result<(), Box<dyn std::error::Error>> {
//! use crankstar::{Masses, Quantity, classify, parse};
//! let v8 = parse("V8.toml", "title = 'V8'\nvee = { bank_angle = 90, throws = [0, 90, 270, 180] }")?;
//! let [first, second] = &classify(&v8, &[1, 2], Masses::All, &Quantity::PLANAR)?[..] else { panic!() };
//! assert!(first.force.is_balanced() && !first.moment.is_balanced());
//! assert!(second.force.is_balanced() && second.moment.is_balanced());
//! # Ok(())
//! # }
//! ```
//!
//! An engine is built of cylinders too, and each verdict is checked by itself:
//!
//! ```
//! use crankstar::{BigRational, Cylinder, Draft, Masses, Quantity, Turn, check_certificate, classify};
//!
//! let mut four = Draft::new("In-line four");
//! for (place, half_turns) in [0, 1, 1, 0].into_iter().enumerate() {
//!     let position = BigRational::from_integer(place.into());
//!     four.cylinders.push(Cylinder::new(Turn::fraction(half_turns, 2), Turn::zero(), position, place));
//! }
//! let four = four.build().unwrap();
//!
//! let judged = classify(&four, &[1, 2], Masses::All, &Quantity::PLANAR).unwrap();
//! assert!(judged[0].force.is_balanced() && !judged[1].force.is_balanced());
//! // The checker knows nothing of how the verdict was found.
//! let second_order = &judged[1].parts[0].force.direct;
//! check_certificate(&second_order.sum.vectors(), false, &second_order.certificate).unwrap();
//! ```
//!
//! An engine of the catalogue is found by its name ([`find`]), and one that is written as a layout file is read ([`parse`]); the
//! folder `examples` has three short programs. The room `report` makes pages, documents of blocks, and `page::write` writes them as
//! Markdown, LaTeX, HTML, Typst or plain text.
//!
//! # The rooms
//!
//! ```text
//! python
//! cli  web
//! report
//! page
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
//! The upper four storeys are this crate; the rooms below them are the crate `crankstar_kernel`, of which every name stands here too.
//! A room imports from the storeys below it and nothing from its own; a test reads the imports and holds it to that.
//!
//! # Features
//!
//! The first three are on by default. Without any (`default-features = false`) the crate is the library without `page`, `report` and `optimise`: it
//! decides, proves and checks, and builds for WebAssembly.
//!
//! - `report`: the rooms `page` and `report`, pages and documents.
//! - `optimise`: the room `optimise`, with its solver for convex problems.
//! - `web`: the room `web`, what the page in a browser asks for; it takes `report` along.
//! - `cli`: the program; it takes `report` along.
//! - `xlsx`, `parquet`: tables of data ([`table`]) as workbooks and as Parquet, besides CSV.
//! - `python`: the room `python`, the module that `pip install .` builds; it takes `report` along.
//!
//! Comments cite the theory by section: `docs/theory.md` has the formulas, and whose they are.

#![warn(missing_docs)]

// The command line names the library as any other program does.
#[cfg(feature = "cli")]
extern crate self as crankstar;

#[doc(inline)]
pub use crankstar_kernel::*;

/// The program, which `src/main.rs` and the command of the Python package call; no interface of the library.
#[cfg(feature = "cli")]
#[doc(hidden)]
#[allow(clippy::disallowed_types, missing_docs)]
pub mod cli;
#[cfg(feature = "report")]
#[allow(clippy::disallowed_types)]
pub mod page;
#[cfg(feature = "python")]
#[allow(clippy::disallowed_types)]
mod python;
#[cfg(feature = "report")]
#[allow(clippy::disallowed_types)]
pub mod report;
#[cfg(feature = "web")]
#[allow(clippy::disallowed_types)]
pub mod web;

#[cfg(feature = "report")]
pub use report::data;
