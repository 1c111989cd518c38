//! What is an engine, as far as its balance goes? Cylinders on their throws, what they weigh, and what else turns.
//!
//! A [`Draft`] is free to say anything; what [`Draft::build`] accepts is an [`Engine`], and holds together.

mod balance_factors;
mod build;
mod build_error;
mod convention;
mod crankshaft;
mod cycle;
mod cycle_order;
mod cylinder;
mod dimensions;
mod draft;
mod effects;
mod family;
mod firing;
mod firing_spans;
mod flywheel;
mod form;
mod gas;
mod geared;
mod geared_crank;
mod length;
mod linear;
mod links;
mod mechanism;
mod misfire;
mod model;
mod mounting;
mod open_firing;
mod order;
mod ray;
mod shared;
mod throws;
mod title_block;
mod torsion;

pub use balance_factors::BobWeight;
pub use build_error::{BuildError, MOST_CYLINDERS};
pub use convention::{Convention, Rotation, SeenFrom};
pub use crankshaft::{Balancer, Counterweight, Crankshaft, ShaftAxis, Web};
pub use cycle::Cycle;
pub use cycle_order::{CycleOrder, NotACycleOrder};
pub use cylinder::{Cylinder, Shared, firing_pistons};
pub use dimensions::{Dimensions, Given, Measure};
pub use draft::{Draft, ReferencePlane};
pub use effects::Effects;
pub use family::{DELTA, Family, PHI};
pub use firing::{Firing, Shot, not_one_each};
pub use firing_spans::{End, FiringSpan, NoSpans};
pub use flywheel::Flywheel;
pub use form::Form;
pub use gas::{
    At, Below, Chamber, CompressorStage, DeadCentre, Gas, GasMistake, Heat, IdealCycle, Ignition, MOST_ROWS,
    PressureLaw, PressureTable, Setting,
};
pub use geared_crank::{AxisLeftOut, GearedCrank};
pub use length::{Length, LengthUnit};
pub use linear::Linear;
pub use mechanism::{Link, Mechanism, NotARod, Rod, Rods};
pub use misfire::NoMisfire;
pub use model::Engine;
pub use mounting::{Block, MOST_MOUNTS, Mount, Mounting, NoMounting};
pub use open_firing::OpenFiring;
pub use order::{DOES_NOT_EXIST, HIGHEST_ORDER, NotAnOrder, ORDERS, WHY_NOT, are_orders};
pub use ray::{Law, Ray};
pub use throws::{Throw, throws};
pub use title_block::TitleBlock;
pub use torsion::{Damper, DamperValue, ElasticShaft, Gear, Harmonic, MOST_DISCS, NoShaft, Section, Steel, Torsion};
