//! What is an engine, as far as its balance goes? Cylinders on their throws, what they weigh, and what else turns.

mod crankshaft;
mod family;
mod firing;
mod linear;
mod mechanism;
mod model;
mod order;
mod throws;
mod title_block;

pub use crankshaft::{Balancer, BobWeight, Counterweight, Crankshaft, Web};
pub use family::{DELTA, Family, PHI, SymbolicCylinder};
pub use firing::{Cycle, Firing, Shot};
pub use linear::Linear;
pub(crate) use mechanism::turns_round;
pub use mechanism::{Given, Measure, Mechanism, Rod};
pub use model::{Cylinder, Effects, Engine, Form, LengthUnit};
pub use order::{DOES_NOT_EXIST, HIGHEST_ORDER, ORDERS, WHY_NOT};
pub use throws::{Throw, throws};
pub use title_block::TitleBlock;
