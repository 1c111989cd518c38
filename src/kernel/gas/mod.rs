//! How does the gas press on one piston? Pressure, force, side force and torque over its cycle, and their harmonics.
//!
//! Angles ψ are the crank's, in radians from its dead centre on the cylinder axis, over a cycle of 2π (two-stroke) or 4π
//! (four-stroke). The force is `F_g = (p − p_c) A` towards the crank, the torque `T = −F_g s'` (theory, section 12).

mod burning;
mod cylinder;
mod error;
mod geometry;
mod harmonics;
mod law;
mod quadrature;
mod solve;
mod stage;
mod warning;
mod work;

pub use cylinder::CylinderGas;
pub use error::NoGas;
pub use geometry::Geometry;
pub use harmonics::Harmonics;
pub use quadrature::{integrate, integrate_short, points_short};
pub use warning::Warning;
