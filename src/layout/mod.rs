//! Which engine is it? From a layout file, or a name of the catalogue, to cylinders with exact angles and arms.
//!
#![doc = include_str!("README.md")]

mod balancer_keys;
mod bearings;
mod catalogue;
mod crankshaft;
mod crankshaft_keys;
mod engine;
mod error;
mod family;
mod file;
mod firing;
mod forms;
mod linear;
mod mechanism;
mod number;
mod order;
mod quantities;
mod template;
mod throws;
mod title_block;
pub(crate) mod units;
pub(crate) mod written;

pub use catalogue::{Entry, catalogue, find};
pub use crankshaft::{Balancer, BobWeight, Counterweight, Crankshaft, Web};
pub use engine::{Cylinder, Effects, Form, Layout, LengthUnit};
pub use error::LayoutError;
pub use family::{DELTA, Family, PHI, SymbolicCylinder};
pub use file::{Engine, parse, parse_engine};
pub use firing::{Cycle, Firing, Shot};
pub use linear::Linear;
pub use mechanism::{Given, Measure, Mechanism, Rod};
pub use number::{NumberError, parse_number};
pub use order::{DOES_NOT_EXIST, HIGHEST_ORDER, ORDERS, WHY_NOT};
pub use quantities::{parse_angle, parse_length};
pub use template::{Key, Template};
pub use throws::{Throw, throws};
pub use title_block::TitleBlock;
pub use units::turns_per_unit;
