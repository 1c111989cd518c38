//! Which engine is it? From a layout file, or a name of the catalogue, to cylinders with exact angles and arms.
//!
#![doc = include_str!("README.md")]

mod articulated_keys;
mod asked;
mod balancer_keys;
mod bearings;
mod catalogue;
mod contradiction;
mod convention_keys;
mod counterweight_keys;
mod crankshaft_keys;
mod cylinder_keys;
mod diagram_keys;
mod error;
mod file_resolver;
mod firing_order;
mod firing_throws;
mod flywheel_keys;
mod forms;
mod gas_keys;
mod gas_layers;
mod gas_process;
mod gas_table;
mod geared_forms;
mod geared_keys;
mod kind;
mod known_firing;
mod knuckle_keys;
mod layout;
mod linear;
mod measured;
mod mechanism_keys;
mod mounting_keys;
mod narrow;
mod number;
mod numbering;
mod pin_split;
mod pressure_csv;
pub(crate) mod quantities;
mod replaced;
mod rewritten;
mod rotor_keys;
mod schema;
mod shared_keys;
mod template;
mod title_block_keys;
mod torsion_keys;
pub(crate) mod units;
mod usual;
pub mod written;

pub use catalogue::{Entry, catalogue, find, is_of_catalogue};
pub use diagram_keys::{Diagram, Harmonic, Line, Torque, parse_diagram};
pub use error::LayoutError;
pub use file_resolver::FileResolver;
pub use kind::Kind;
pub use layout::{Layout, parse, parse_beside, parse_layout, parse_layout_beside};
pub use number::{NumberError, parse_number};
pub use quantities::{parse_angle, parse_length, parse_radius, shown_position};
pub use replaced::with_value;
pub use rewritten::{
    balancer_table, bare_number, comment, counted_from_its_throw, counterweight_in_multiples, counterweight_table,
    exact_number, without_balancers, without_counterweights,
};
pub use rotor_keys::{Rotor, RotorMass, parse_rotor};
pub use schema::{number_kind, schema, tables};
pub use template::{Key, Template};
pub use units::turns_per_unit;
pub use usual::{
    LayoutWarning, USUAL_PEAK_BAR, USUAL_PEAK_DEGREES, odd_position, odd_value, warnings, warnings_of_values,
};
